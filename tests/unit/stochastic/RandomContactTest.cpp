// Laws with kinks and memory, met at the points.
#include <cmath>
#include <iostream>
#include <random>

#include <gtest/gtest.h>

#include <harmos/latin/LatinSolver.hpp>
#include <harmos/probability/Uniform.hpp>

#include "RandomChains.hpp"

namespace harmos::stochastic {
namespace {

constexpr int steps = 4;

/// The joint is pressed, pushed sideways beyond sliding and pulled back; both friction and clearance are random.
struct FrictionChain {
  static std::vector<Law> lawsOf(const std::vector<double>& x) {
    return {foundation(20.0, 15.0), laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", x[0]}, {"Gap", x[1]}}),
            laws::makeLaw("Prescribed Displacement", {{"X", -0.3}, {"Y", 0.2}, {"Z", 0.0}},
                          {{"X", {0.5, 1.0, 1.0, 1.0}}, {"Y", {0.0, 0.2, 1.0, -0.5}}})};
  }
  static std::vector<std::shared_ptr<const latin::Response>> responses() {
    using Maximum = latin::MaximumResponse;
    return {displacement("middle", 0, 2, {0.0, 1.0, 0.0}),
            std::make_shared<latin::ResultantResponse>("force", std::vector<int>{1}, std::vector<base::Vector3>{}),
            std::make_shared<Maximum>("shear", std::vector<int>{1}, Maximum::Field::tangentialTraction),
            std::make_shared<latin::DissipationResponse>("loss", std::vector<int>{1})};
  }
  static latin::LatinResult solve(const std::vector<double>& x, double accuracy) {
    const assembly::Assembly assembly = springsInSeries(lawsOf(x), steps);
    latin::LatinOptions options;
    options.accuracy = accuracy;
    base::Timers timers;
    latin::LatinSolver solver(assembly, options, latin::self(), timers);
    for (const auto& response : responses()) solver.addResponse(response);
    return solver.solve();
  }
};

using LawsOf = std::function<std::vector<Law>(const std::vector<double>&)>;

struct RandomFriction {
  RandomFriction(const std::shared_ptr<const probability::RandomVector>& variables, const LawsOf& lawsOf, int order,
                 int points, double accuracy)
      : projection(projectionOf(variables, order, points)),
        laws(realisations(*projection, lawsOf)),
        assembly(springsInSeries(laws[0], steps)),
        solver(assembly, projection, optionsOf(accuracy), latin::self(), timers) {
    solver.setLaws(laws);
    for (const auto& response : FrictionChain::responses()) solver.addResponse(response);
    result = solver.solve();
  }
  static StochasticOptions optionsOf(double accuracy) {
    StochasticOptions options;
    options.accuracy = accuracy;
    return options;
  }

  std::shared_ptr<const Projection> projection;
  Realisations laws;
  assembly::Assembly assembly;
  base::Timers timers;
  StochasticSolver solver;
  StochasticResult result;
};

const auto friction = std::make_shared<probability::Uniform>(0.1, 0.5);
const auto gap = std::make_shared<probability::Uniform>(0.0, 0.02);

// With as many points as polynomials the projection interpolates: at each point stands the solution of that
// realisation, with its own history.
TEST(RandomContact, IsTheSolutionOfEveryRealisationWhereItInterpolates) {
  for (const bool hasRandomGap : {false, true}) {
    const auto both = [&](const std::vector<double>& x) {
      return hasRandomGap ? std::vector<double>{0.3, x[0]} : std::vector<double>{x[0], 0.01};
    };
    const auto variables = hasRandomGap ? randomVector({gap}) : randomVector({friction});
    const RandomFriction problem(
        variables, [&](const std::vector<double>& x) { return FrictionChain::lawsOf(both(x)); }, 4, 5, 1e-7);
    const StochasticResult& result = problem.result;
    ASSERT_EQ(result.outcome, latin::Outcome::certified) << result.reason;
    const ResponseSampler sampler = problem.solver.sampler();
    for (const auto& point : problem.projection->quadrature().points) {
      const latin::LatinResult expected = FrictionChain::solve(both(variables->values(point)), 1e-8);
      ASSERT_EQ(expected.outcome, latin::Outcome::certified);
      for (std::size_t i = 0; i < expected.responses.size(); ++i) {
        const base::Matrix values = sampler.sample(static_cast<int>(i), {point});
        for (int t = 0; t < steps; ++t) {
          const double value = expected.responses[i].values[t];
          EXPECT_NEAR(values(t, 0), value, 1e-6 * std::max(1e-2, std::abs(value)))
              << expected.responses[i].name << " at step " << t;
          EXPECT_NEAR(result.responses[i].at(t).evaluate(point), values(t, 0), 1e-9);
        }
      }
    }
  }
}

// Mean and standard deviation against draws that are each solved: kinks cost some per cent.
TEST(RandomContact, HasTheMomentsOfMonteCarlo) {
  constexpr int draws = 1000;
  const auto variables = randomVector({friction, gap});
  const RandomFriction problem(variables, FrictionChain::lawsOf, 4, 8, 1e-3);
  ASSERT_EQ(problem.result.outcome, latin::Outcome::certified) << problem.result.reason;
  EXPECT_LE(problem.result.errorEstimate, 1e-3);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> mean(4, 0.0), square(4, 0.0);
  for (int draw = 0; draw < draws; ++draw) {
    const auto germs = variables->germs({uniform(random), uniform(random)});
    const latin::LatinResult one = FrictionChain::solve(variables->values(germs), 1e-3);
    for (std::size_t i = 0; i < 4; ++i) {
      mean[i] += one.responses[i].values.back() / draws;
      square[i] += one.responses[i].values.back() * one.responses[i].values.back() / draws;
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const probability::Expansion found = problem.result.responses[i].at(steps - 1);
    const double deviation = std::sqrt(square[i] - mean[i] * mean[i]);
    EXPECT_NEAR(found.mean(), mean[i], 4.0 * deviation / std::sqrt(draws)) << problem.result.responses[i].name;
    EXPECT_NEAR(found.standardDeviation(), deviation, 0.08 * deviation) << problem.result.responses[i].name;
    std::cout << problem.result.responses[i].name << ": chaos " << found.mean() << " +- " << found.standardDeviation()
              << ", Monte Carlo " << mean[i] << " +- " << deviation << "\n";
  }
}

}  // namespace
}  // namespace harmos::stochastic
