#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <Thyra_DetachedMultiVectorView.hpp>
#include <Thyra_DetachedVectorView.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/thyra/ResponseModel.hpp>

#include "../latin/BoxAssembly.hpp"

namespace harmos::thyra {
namespace {

using Args = ::Thyra::ModelEvaluatorBase;
using Vector = Teuchos::RCP<::Thyra::VectorBase<double>>;
constexpr int steps = 3;

/// Two cubes that rub on one another: g = (displacement, friction force) at three load steps, p = (mu, shear).
class Model {
 public:
  Model() : cubes_(latin::twoCubes(joint(0.3), top(0.9), steps)) {
    if (Tpetra::getDefaultComm()->getSize() > 1) cubes_.assembly().owner = {0, 1};
    auto& interfaces = cubes_.assembly().interfaces;
    for (std::size_t i = 0; i < interfaces.size(); ++i) {
      if (interfaces[i].name == "joint") joint_ = static_cast<int>(i);
      if (interfaces[i].name == "top") top_ = static_cast<int>(i);
    }
    latin::LatinOptions options;
    options.accuracy = 1e-10;
    const std::vector<std::shared_ptr<const latin::Response>> responses{
        std::make_shared<latin::DisplacementResponse>(
            "u", std::vector<latin::DisplacementResponse::Node>{{1, 3, 0.5}, {1, 20, 0.5}}, base::Vector3{1, 0, 0}),
        std::make_shared<latin::DissipationResponse>("lost", std::vector<int>{joint_})};
    const std::vector<latin::ModelParameter> parameters{
        {"mu", 0.3, 3e-7,
         [&interfaces, this](double value) {
           leastFriction_ = std::min(leastFriction_, value);
           interfaces[joint_].law = joint(value);
         }},
        {"shear", 0.9, 9e-7, [&interfaces, this](double value) { interfaces[top_].law = top(value); }}};
    model_ =
        Teuchos::rcp(new ResponseModel(cubes_.assembly(), options, responses, parameters, Tpetra::getDefaultComm()));
  }

  ResponseModel& operator*() { return *model_; }
  /// dg/dmu at all load steps.
  std::vector<double> byFriction(double mu) {
    auto in = model_->createInArgs();
    in.set_p(0, at(mu, 0.9));
    auto out = model_->createOutArgs();
    const auto columns = ::Thyra::createMembers(model_->get_g_space(0), 2);
    out.set_DgDp(0, 0, Args::Derivative<double>(columns, Args::DERIV_MV_JACOBIAN_FORM));
    model_->evalModel(in, out);
    const ::Thyra::ConstDetachedMultiVectorView<double> view(*columns);
    std::vector<double> result;
    for (int row = 0; row < view.subDim(); ++row) result.push_back(view(row, 0));
    return result;
  }
  double leastFriction() const { return leastFriction_; }

  /// p with other values.
  Vector at(double mu, double shear) const {
    const Vector p = ::Thyra::createMember(model_->get_p_space(0));
    ::Thyra::DetachedVectorView<double> view(p);
    view[0] = mu;
    view[1] = shear;
    return p;
  }
  std::vector<double> values(double mu, double shear) const {
    auto in = model_->createInArgs();
    auto out = model_->createOutArgs();
    in.set_p(0, at(mu, shear));
    const Vector g = ::Thyra::createMember(model_->get_g_space(0));
    out.set_g(0, g);
    model_->evalModel(in, out);
    const ::Thyra::ConstDetachedVectorView<double> view(*g);
    std::vector<double> result(view.subDim());
    for (int i = 0; i < view.subDim(); ++i) result[i] = view[i];
    return result;
  }

 private:
  static std::shared_ptr<const laws::InterfaceLaw> joint(double mu) {
    return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", mu}});
  }
  static std::shared_ptr<const laws::InterfaceLaw> top(double shear) {
    return laws::makeLaw("Prescribed Traction", {{"X", shear}, {"Z", -4.0}}, {{"X", {0.4, 1.0, -0.6}}});
  }

  latin::BoxAssembly cubes_;
  int joint_ = -1, top_ = -1;
  double leastFriction_ = 1.0;
  Teuchos::RCP<ResponseModel> model_;
};

TEST(ResponseModel, NamesItsParametersAndResponses) {
  Model model;
  EXPECT_EQ((*model).get_p_space(0)->dim(), 2);
  EXPECT_EQ((*model).get_g_space(0)->dim(), 2 * steps);
  EXPECT_EQ((*(*model).get_p_names(0))[1], "shear");
  EXPECT_EQ((*model).get_g_names(0)[steps], "lost 1");
  const ::Thyra::ConstDetachedVectorView<double> nominal((*model).getNominalValues().get_p(0));
  EXPECT_EQ(nominal[0], 0.3);
  (*model).setBounds({0.1, 0.0}, {0.9, 2.0});
  EXPECT_EQ(::Thyra::ConstDetachedVectorView<double>((*model).getUpperBounds().get_p(0))[1], 2.0);
  EXPECT_THROW((*model).setBounds({0.1}, {0.9}), base::Error);
}

// Both forms, against differences of solutions.
TEST(ResponseModel, HasTheDerivativesOfDifferences) {
  Model model;
  auto in = (*model).createInArgs();
  in.set_p(0, model.at(0.32, 0.95));
  auto out = (*model).createOutArgs();
  const auto columns = ::Thyra::createMembers((*model).get_g_space(0), 2);
  out.set_DgDp(0, 0, Args::Derivative<double>(columns, Args::DERIV_MV_JACOBIAN_FORM));
  (*model).evalModel(in, out);
  const auto gradients = ::Thyra::createMembers((*model).get_p_space(0), 2 * steps);
  out.set_DgDp(0, 0, Args::Derivative<double>(gradients, Args::DERIV_MV_GRADIENT_FORM));
  (*model).evalModel(in, out);
  const ::Thyra::ConstDetachedMultiVectorView<double> jacobian(*columns), gradient(*gradients);
  const double h = 1e-4;
  for (int i = 0; i < 2; ++i) {
    const auto above = model.values(0.32 + (i == 0 ? h : 0.0), 0.95 + (i == 1 ? h : 0.0));
    const auto below = model.values(0.32 - (i == 0 ? h : 0.0), 0.95 - (i == 1 ? h : 0.0));
    for (int row = 0; row < 2 * steps; ++row) {
      const double difference = (above[row] - below[row]) / (2.0 * h);
      double largest = 0.0;
      for (int t = 0; t < steps; ++t) {
        const int other = row / steps * steps + t;
        largest = std::max(largest, std::abs(above[other] - below[other]) / (2.0 * h));
      }
      EXPECT_NEAR(jacobian(row, i), difference, 1e-5 * largest + 1e-9) << row << " by " << i;
      EXPECT_NEAR(gradient(i, row), jacobian(row, i), 1e-7 * largest + 1e-10);
    }
  }
}

// Towards the inside at a bound, beyond which optimisers never go.
TEST(ResponseModel, StaysWithinItsBounds) {
  Model free, bounded;
  (*bounded).setBounds({0.3, 0.0}, {0.9, 2.0});
  const auto expected = free.byFriction(0.3), found = bounded.byFriction(0.3);
  EXPECT_LT(free.leastFriction(), 0.3);
  EXPECT_EQ(bounded.leastFriction(), 0.3);
  double largest = 0.0;
  for (const double value : expected) largest = std::max(largest, std::abs(value));
  for (std::size_t row = 0; row < expected.size(); ++row) EXPECT_NEAR(found[row], expected[row], 1e-6 * largest);
}

TEST(ResponseModel, SolvesOnceForOnePoint) {
  Model model;
  const auto first = model.values(0.3, 0.9);
  EXPECT_EQ(model.values(0.3, 0.9), first);
  EXPECT_EQ((*model).solutions(), 1);
  model.values(0.31, 0.9);
  EXPECT_EQ((*model).solutions(), 2);
}

// A force that friction cannot carry.
TEST(ResponseModel, SaysThatThereIsNoEquilibrium) {
  Model model;
  try {
    model.values(0.05, 0.95);
    FAIL() << "nothing was thrown";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::noEquilibrium) << error.what();
  }
  EXPECT_EQ(model.values(0.3, 0.9).size(), 2U * steps);
}

}  // namespace
}  // namespace harmos::thyra
