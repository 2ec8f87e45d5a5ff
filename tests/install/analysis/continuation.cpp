// Follows a joint under a growing force, though the model is moved and not pushed: LOCA finds the amplitude x of the
// displacement at which the force at the end, g(x), is the load, and steps the load, with dg/dx of Harmos.
#include <cmath>
#include <iostream>
#include <vector>

#include <LOCA.H>
#include <LOCA_LAPACK.H>
#include <Thyra_DetachedMultiVectorView.hpp>
#include <Thyra_DetachedVectorView.hpp>
#include <Thyra_VectorStdOps.hpp>

#include <harmos/base/AllRanks.hpp>

#include "Joint.hpp"

namespace {

using Args = Thyra::ModelEvaluatorBase;
constexpr double largestLoad = 26.0;  // [force]; the joint slides as a whole at 28

class ForceOfWay final : public LOCA::LAPACK::Interface {
 public:
  explicit ForceOfWay(const harmos::thyra::ResponseModel& model) : model_(model), guess_(1) { guess_(0) = 0.01; }

  const NOX::LAPACK::Vector& getInitialGuess() override { return guess_; }
  bool computeF(NOX::LAPACK::Vector& f, const NOX::LAPACK::Vector& x) override {
    auto out = model_.createOutArgs();
    const auto g = Thyra::createMember(model_.get_g_space(0));
    out.set_g(0, g);
    model_.evalModel(at(x), out);
    const Thyra::ConstDetachedVectorView<double> view(*g);
    f(0) = view[view.subDim() - 1] - load_;
    return true;
  }
  bool computeJacobian(NOX::LAPACK::Matrix<double>& jacobian, const NOX::LAPACK::Vector& x) override {
    auto out = model_.createOutArgs();
    const auto column = Thyra::createMembers(model_.get_g_space(0), 1);
    out.set_DgDp(0, 0, Args::Derivative<double>(column, Args::DERIV_MV_JACOBIAN_FORM));
    model_.evalModel(at(x), out);
    const Thyra::ConstDetachedMultiVectorView<double> view(*column);
    jacobian(0, 0) = view(view.subDim() - 1, 0);
    return true;
  }
  void setParams(const LOCA::ParameterVector& parameters) override { load_ = parameters.getValue("load"); }
  void printSolution(const NOX::LAPACK::Vector& x, const double load) override {
    if (Tpetra::getDefaultComm()->getRank() == 0) std::cout << "load " << load << ", displacement " << x(0) << "\n";
    ways.push_back(x(0));
    loads.push_back(load);
  }

  std::vector<double> ways, loads;

 private:
  Args::InArgs<double> at(const NOX::LAPACK::Vector& x) const {
    auto in = model_.createInArgs();
    const auto p = Thyra::createMember(model_.get_p_space(0));
    Thyra::set_ele(0, x(0), p.ptr());
    in.set_p(0, p);
    return in;
  }

  const harmos::thyra::ResponseModel& model_;
  NOX::LAPACK::Vector guess_;
  double load_ = 0.0;
};

Teuchos::RCP<Teuchos::ParameterList> options() {
  const auto list = Teuchos::rcp(new Teuchos::ParameterList);
  Teuchos::ParameterList& stepper = list->sublist("LOCA").sublist("Stepper");
  stepper.set("Continuation Method", "Arc Length");
  stepper.set("Continuation Parameter", "load");
  stepper.set("Initial Value", 4.0);
  stepper.set("Max Value", largestLoad);
  stepper.set("Min Value", 0.0);
  stepper.set("Max Steps", 30);
  stepper.set("Max Nonlinear Iterations", 15);
  Teuchos::ParameterList& size = list->sublist("LOCA").sublist("Step Size");
  size.set("Initial Step Size", 4.0);
  size.set("Max Step Size", 6.0);
  size.set("Min Step Size", 1e-3);
  list->sublist("NOX").sublist("Printing").set("Output Information", 0);
  return list;
}

int follow() {
  const Joint joint({"Boundaries/moved/Law/X"}, {0.0, 0.25, 0.5, 0.75, 1.0});
  const auto list = options();
  const auto global = LOCA::createGlobalData(list, Teuchos::rcp<LOCA::Abstract::Factory>(new LOCA::LAPACK::Factory));
  ForceOfWay problem(joint.model());
  const auto group = Teuchos::rcp(new LOCA::LAPACK::Group(global, problem));
  LOCA::ParameterVector parameters;
  parameters.addParameter("load", 4.0);
  group->setParams(parameters);
  const auto isSmall = Teuchos::rcp(new NOX::StatusTest::NormF(1e-4, NOX::StatusTest::NormF::Unscaled));
  const auto isLong = Teuchos::rcp(new NOX::StatusTest::MaxIters(15));
  const auto test = Teuchos::rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR, isSmall, isLong));
  LOCA::Stepper stepper(global, group, test, list);
  const bool isFinished = stepper.run() == LOCA::Abstract::Iterator::Finished;
  LOCA::destroyGlobalData(global);

  // The loads are reached, and the joint gives way the more the nearer it is to sliding.
  bool isRight = isFinished && problem.loads.size() >= 4 && std::abs(problem.loads.back() - largestLoad) < 1e-3;
  const std::size_t last = problem.ways.size() - 1;
  const double first = problem.ways[0] / problem.loads[0];
  isRight = isRight && (problem.ways[last] - problem.ways[0]) / (problem.loads[last] - problem.loads[0]) > 1.05 * first;
  return isRight ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard scope(&argc, &argv);
  return harmos::base::runOnAllRanks(*Tpetra::getDefaultComm(), follow, std::cerr);
}
