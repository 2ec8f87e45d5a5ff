// Identifies a friction coefficient and the stiffness of a glue from a noisy curve: ROL minimises the distance of the
// curve of the model to the one that was measured, with the derivatives that Harmos gives.
#include <cmath>
#include <iostream>
#include <random>

#include <ROL_Bounds.hpp>
#include <ROL_Objective.hpp>
#include <ROL_Problem.hpp>
#include <ROL_Solver.hpp>
#include <ROL_StdVector.hpp>
#include <ROL_Stream.hpp>
#include <Thyra_DetachedMultiVectorView.hpp>
#include <Thyra_DetachedVectorView.hpp>

#include <harmos/base/AllRanks.hpp>

#include "Joint.hpp"

namespace {

using Args = Thyra::ModelEvaluatorBase;
constexpr double noise = 0.5;  // [force], standard deviation; the largest force is about 30

/// sum of ((g_i(p) - d_i) / noise)^2 / 2 over the load steps, of p over its first guess.
class Distance final : public ROL::Objective<double> {
 public:
  Distance(const harmos::thyra::ResponseModel& model, std::vector<double> scale, std::vector<double> measured)
      : model_(model), scale_(std::move(scale)), measured_(std::move(measured)) {}

  /// The curve at p over its first guess.
  std::vector<double> curve(const std::vector<double>& x) const {
    auto out = model_.createOutArgs();
    const auto g = Thyra::createMember(model_.get_g_space(0));
    out.set_g(0, g);
    model_.evalModel(at(x), out);
    const Thyra::ConstDetachedVectorView<double> view(*g);
    std::vector<double> values;
    for (int i = 0; i < view.subDim(); ++i) values.push_back(view[i]);
    return values;
  }

  double value(const ROL::Vector<double>& x, double& /*tolerance*/) override {
    double sum = 0.0;
    for (const double r : residuals(x)) sum += 0.5 * r * r;
    return sum;
  }
  void gradient(ROL::Vector<double>& gradient, const ROL::Vector<double>& x, double& /*tolerance*/) override {
    const std::vector<double> r = residuals(x);
    multiply(gradient, x, [&](int i) { return r[i]; });
  }
  /// Of Gauss and Newton: the residuals are small in the end.
  void hessVec(ROL::Vector<double>& product, const ROL::Vector<double>& v, const ROL::Vector<double>& x,
               double& /*tolerance*/) override {
    const auto columns = jacobian(x);
    const Thyra::ConstDetachedMultiVectorView<double> view(*columns);
    const std::vector<double>& direction = entries(v);
    multiply(product, x, [&](int i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < scale_.size(); ++j) sum += view(i, static_cast<int>(j)) * scale_[j] * direction[j];
      return sum / noise;
    });
  }

 private:
  static const std::vector<double>& entries(const ROL::Vector<double>& x) {
    return *dynamic_cast<const ROL::StdVector<double>&>(x).getVector();
  }
  Args::InArgs<double> at(const std::vector<double>& x) const {
    auto in = model_.createInArgs();
    const auto p = Thyra::createMember(model_.get_p_space(0));
    Thyra::DetachedVectorView<double> view(p);
    for (std::size_t j = 0; j < x.size(); ++j) view[static_cast<int>(j)] = scale_[j] * x[j];
    in.set_p(0, p);
    return in;
  }
  std::vector<double> residuals(const ROL::Vector<double>& x) const {
    std::vector<double> r = curve(entries(x));
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = (r[i] - measured_[i]) / noise;
    return r;
  }
  /// dg/dp, found once for one point.
  Teuchos::RCP<Thyra::MultiVectorBase<double>> jacobian(const ROL::Vector<double>& x) const {
    if (!columns_.is_null() && point_ == entries(x)) return columns_;
    point_ = entries(x);
    columns_ = Thyra::createMembers(model_.get_g_space(0), static_cast<int>(scale_.size()));
    auto out = model_.createOutArgs();
    out.set_DgDp(0, 0, Args::Derivative<double>(columns_, Args::DERIV_MV_JACOBIAN_FORM));
    model_.evalModel(at(point_), out);
    return columns_;
  }
  /// result = J^T r / noise.
  template <class Residual>
  void multiply(ROL::Vector<double>& result, const ROL::Vector<double>& x, const Residual& residual) const {
    const auto columns = jacobian(x);
    const Thyra::ConstDetachedMultiVectorView<double> view(*columns);
    std::vector<double>& to = *dynamic_cast<ROL::StdVector<double>&>(result).getVector();
    for (std::size_t j = 0; j < scale_.size(); ++j) {
      to[j] = 0.0;
      for (int i = 0; i < view.subDim(); ++i) {
        to[j] += view(i, static_cast<int>(j)) * scale_[j] * residual(i) / noise;
      }
    }
  }

  const harmos::thyra::ResponseModel& model_;
  std::vector<double> scale_, measured_;
  mutable std::vector<double> point_;
  mutable Teuchos::RCP<Thyra::MultiVectorBase<double>> columns_;
};

int identify() {
  const Joint joint({"Interfaces/sliding/Law/Friction Coefficient", "Boundaries/glue/Law/Tangential Stiffness"},
                    {0.0, 1.0, -1.0, 0.5, 1.0});
  const std::vector<double> truth{0.35, 120.0}, guess{0.2, 60.0};

  // What was measured: the curve of the truth, and noise that is the same everywhere.
  std::vector<double> measured = Distance(joint.model(), truth, {}).curve({1.0, 1.0});
  std::minstd_rand numbers(1);
  for (double& value : measured) {
    double sum = 0.0;  // of twelve uniform numbers: nearly normal
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(numbers()) / std::minstd_rand::max();
    value += noise * (sum - 6.0);
  }

  const auto vector = [](double a, double b) {
    return ROL::makePtr<ROL::StdVector<double>>(ROL::makePtr<std::vector<double>>(std::vector<double>{a, b}));
  };
  const auto x = vector(1.0, 1.0);
  const auto problem =
      ROL::makePtr<ROL::Problem<double>>(ROL::makePtr<Distance>(joint.model(), guess, measured), x, vector(0.0, 0.0));
  problem->addBoundConstraint(ROL::makePtr<ROL::Bounds<double>>(vector(0.05, 0.1), vector(5.0, 10.0)));
  ROL::ParameterList options;
  options.sublist("Step").set("Type", "Trust Region");
  options.sublist("Status Test").set("Gradient Tolerance", 1e-3);
  options.sublist("Status Test").set("Iteration Limit", 30);
  ROL::Solver<double> solver(problem, options);
  ROL::nullstream silent;
  solver.solve(silent);

  const std::vector<double>& found = *x->getVector();
  const double mu = guess[0] * found[0], stiffness = guess[1] * found[1];
  if (Tpetra::getDefaultComm()->getRank() == 0) {
    std::cout << "mu = " << mu << " (" << truth[0] << "), k_t = " << stiffness << " (" << truth[1] << "), "
              << joint.model().solutions() << " solutions\n";
  }
  return std::abs(mu - truth[0]) < 0.02 && std::abs(stiffness - truth[1]) < 0.05 * truth[1] ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard scope(&argc, &argv);
  return harmos::base::runOnAllRanks(*Tpetra::getDefaultComm(), identify, std::cerr);
}
