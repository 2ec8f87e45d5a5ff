#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/LatinSolver.hpp>

#include "RandomChains.hpp"

namespace harmos::stochastic {
namespace {

constexpr int steps = 3;

/// The stiffness of the joint and the load are random.
std::vector<Law> lawsOf(const std::vector<double>& x) {
  return {foundation(20.0, 15.0), spring(x[0], 0.5 * x[0]), pull(x[1], 0.5, {{"X", {0.5, -1.0, 1.0}}})};
}

std::vector<std::shared_ptr<const latin::Response>> responses() {
  using Maximum = latin::MaximumResponse;
  return {displacement("end", 1, 2), displacement("side", 1, 2, {0.0, 1.0, 0.0}),
          std::make_shared<latin::ResultantResponse>("pull", std::vector<int>{2}, std::vector<base::Vector3>{}),
          std::make_shared<Maximum>("traction", std::vector<int>{0, 1}, Maximum::Field::normalTraction),
          std::make_shared<Maximum>("slip", std::vector<int>{1}, Maximum::Field::slip)};
}

class RandomElasticChain : public testing::TestWithParam<Method> {
 protected:
  RandomElasticChain()
      : projection_(projectionOf(variables_, 6)),
        assembly_(springsInSeries(lawsOf({10.0, 1.0}), steps)),
        solver_(assembly_, projection_, options(), latin::self(), timers_) {
    solver_.setLaws(realisations(*projection_, lawsOf));
    for (const auto& response : responses()) solver_.addResponse(response);
    result_ = solver_.solve();
  }
  static StochasticOptions options() {
    StochasticOptions options;
    options.accuracy = 1e-8;
    options.method = GetParam();
    return options;
  }

  std::shared_ptr<const probability::RandomVector> variables_ = randomVector(
      {std::make_shared<probability::Lognormal>(10.0, 1.0), std::make_shared<probability::Normal>(2.0, 0.2)});
  std::shared_ptr<const Projection> projection_;
  assembly::Assembly assembly_;
  base::Timers timers_;
  StochasticSolver solver_;
  StochasticResult result_;
};

TEST_P(RandomElasticChain, SamplesAreSolutions) {
  ASSERT_EQ(result_.outcome, latin::Outcome::certified) << result_.reason;
  const std::vector<std::vector<double>> germs = {{0.0, 0.0}, {1.0, -1.0}, {-1.5, 0.5}};
  const ResponseSampler sampler = solver_.sampler();
  for (std::size_t s = 0; s < germs.size(); ++s) {
    const assembly::Assembly one = springsInSeries(lawsOf(variables_->values(germs[s])), steps);
    latin::LatinOptions options;
    options.accuracy = 1e-9;
    latin::LatinSolver solver(one, options, latin::self(), timers_);
    for (const auto& response : responses()) solver.addResponse(response);
    const latin::LatinResult expected = solver.solve();
    for (std::size_t i = 0; i < expected.responses.size(); ++i) {
      const base::Matrix found = sampler.sample(static_cast<int>(i), germs);
      for (int t = 0; t < steps; ++t) {
        const double value = expected.responses[i].values[t];
        EXPECT_NEAR(found(t, static_cast<int>(s)), value, 2e-6 * std::abs(value)) << expected.responses[i].name;
      }
    }
  }
}

// Fields for output: coefficients of displacements and of interface fields stand in the modal columns.
TEST_P(RandomElasticChain, FieldsAreExpansions) {
  const latin::PairFields fields = latin::pairFields(solver_.state(), 2);
  const double history[] = {0.5, -1.0, 1.0};
  for (int t = 0; t < steps; ++t) {
    for (int a = 0; a < projection_->terms(); ++a) {
      const int column = solver_.column(t, a);
      EXPECT_NEAR(solver_.state().displacement(1, 2, column)[0], result_.responses[0].coefficients(a, t), 1e-12);
      // (00) is the mean of the load, (01) its deviation.
      const double load = history[t] * (a == 0 ? 2.0 : a == 2 ? 0.2 : 0.0);
      EXPECT_NEAR(fields.traction[fields.at(column, 0)][0], load, 1e-12);
      EXPECT_NEAR(result_.responses[2].coefficients(a, t), load, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, RandomElasticChain, testing::Values(Method::galerkin, Method::pseudoSpectral),
                         [](const auto& tested) { return tested.param == Method::galerkin ? "Galerkin" : "Points"; });

}  // namespace
}  // namespace harmos::stochastic
