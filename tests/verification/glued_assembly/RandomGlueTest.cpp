// Two glues whose moduli are random: E = mean (1 + d xi), d = .2 and .25. References: a prototype's Galerkin solution,
// Monte Carlo of it, and the closed form of the statically determinate chain that the joints are.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <iostream>
#include <random>

#include <Teuchos_DefaultSerialComm.hpp>

#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/stochastic/DirectSpectral.hpp>
#include <harmos/stochastic/StochasticSolver.hpp>

#include "../../unit/laws/MakeLaw.hpp"
#include "SceneInput.hpp"

namespace harmos::verification {
namespace {

using stochastic::Method;

double seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The scene and its solver; the operators are factored once for all laws that a test gives it.
class RandomGlue {
 public:
  RandomGlue(Method method, double accuracy, bool isNormal, int points = 4)
      : isNormal_(isNormal),
        scene_(SceneInput::fromFile("../../xml/glued_assembly.xml").scene()),
        problem_(scene::makeProblem(scene_, *comm_, timers_)) {
    const auto basis = std::make_shared<probability::Basis>(variables(0.2, 0.25), 3);
    projection_ =
        std::make_shared<stochastic::Projection>(basis, probability::tensorQuadrature(basis->variables(), points));
    stochastic::StochasticOptions options;
    options.method = method;
    options.accuracy = accuracy;
    const double before = seconds();
    solver_ = std::make_unique<stochastic::StochasticSolver>(problem_.assembly, projection_, options, comm_, timers_);
    std::cout << "factor: " << seconds() - before << " s CPU\n";
    for (const auto& response : problem_.responses) solver_->addResponse(response);
  }

  stochastic::StochasticResult solve(double d1, double d2, const base::Matrix* start = nullptr) {
    solver_->setLaws(lawsOf(d1, d2));
    const double before = seconds();
    auto result = solver_->solve(start);
    std::cout << result.iterations << " iterations, " << result.columns << " columns, " << seconds() - before
              << " s CPU, estimate " << result.errorEstimate << "\n";
    return result;
  }

  stochastic::Realisations lawsOf(double d1, double d2) const {
    const auto randomVector = variables(d1, d2);
    stochastic::Realisations laws;
    for (const auto& germs : projection_->quadrature().points) {
      const std::vector<double> factor = randomVector->values(germs);
      laws.emplace_back();
      for (const assembly::Interface& interface : problem_.assembly.interfaces) {
        const bool isFirst = interface.name == "glue_1";
        if (isFirst || interface.name == "glue_2") {
          const double normal = isFirst ? 500.0 / 0.3 * factor[0] : 1000.0 / 0.3 * factor[1];
          laws.back().push_back(
              laws::makeLaw("Linear Elastic", {{"Normal Stiffness", normal}, {"Tangential Stiffness", normal / 2.9}}));
        } else {
          laws.back().push_back(interface.law);
        }
      }
    }
    return laws;
  }

  /// The same equations solved directly.
  stochastic::DirectSpectral rival(double d1, double d2, base::Timers& timers) const {
    return {problem_.assembly, projection_, lawsOf(d1, d2), substructure::SolverOptions(), timers};
  }
  const latin::DisplacementResponse& displacement(const std::string& name) const {
    return dynamic_cast<const latin::DisplacementResponse&>(*problem_.responses[responseIndex(name)]);
  }

  static probability::Expansion response(const stochastic::StochasticResult& result, const std::string& name) {
    for (const auto& one : result.responses) {
      if (one.name == name) return one.at(0);
    }
    throw std::invalid_argument("no response " + name);
  }
  std::size_t responseIndex(const std::string& name) const {
    for (std::size_t i = 0; i < problem_.responses.size(); ++i) {
      if (problem_.responses[i]->name() == name) return i;
    }
    throw std::invalid_argument("no response " + name);
  }
  const stochastic::StochasticSolver& solver() const { return *solver_; }

 private:
  /// The two stiffnesses over their means.
  std::shared_ptr<const probability::RandomVector> variables(double d1, double d2) const {
    const auto factor = [&](double d) -> std::shared_ptr<const probability::Distribution> {
      if (isNormal_) return std::make_shared<probability::Normal>(1.0, d);
      return std::make_shared<probability::Lognormal>(1.0, d);
    };
    return std::make_shared<probability::RandomVector>(
        std::vector<probability::Variable>{{"I", factor(d1)}, {"II", factor(d2)}});
  }

  bool isNormal_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_ = Teuchos::rcp(new Teuchos::SerialComm<int>());
  base::Timers timers_;
  scene::Scene scene_;
  scene::Problem problem_;
  std::shared_ptr<const stochastic::Projection> projection_;
  std::unique_ptr<stochastic::StochasticSolver> solver_;
};

TEST(RandomGlue, GalerkinOfOrderThree) {
  RandomGlue problem(Method::galerkin, 1e-6, true);
  const auto result = problem.solve(0.2, 0.25);
  ASSERT_EQ(result.outcome, latin::Outcome::certified) << result.reason;
  const probability::Expansion y = RandomGlue::response(result, "u_y");
  const double deviation = 0.0070238;
  // Orders (00), (10), (01), (20), (11), (02), (30), (21), (12), (03).
  const std::vector<double> expected = {0.3371276,   -6.193249e-3, -2.592768e-3, 1.639562e-3, 0.0,
                                        1.041099e-3, -5.392831e-4, 0.0,          0.0,         -4.406357e-4};
  for (std::size_t a = 0; a < expected.size(); ++a) {
    const double tolerance = expected[a] == 0.0 ? 2e-7 : 1e-5 * deviation;
    EXPECT_NEAR(y.coefficients()[a], expected[a], tolerance) << "coefficient " << a;
  }
  EXPECT_NEAR(y.standardDeviation(), 0.0070239, 1e-7);
  EXPECT_NEAR(y.skewness(), 1.1256079, 1e-4);
  EXPECT_NEAR(y.kurtosis(), 5.4753599, 1e-3);
  const probability::Expansion x = RandomGlue::response(result, "u_x");
  EXPECT_NEAR(x.mean(), -2.0976499, 1e-7);
  EXPECT_NEAR(x.standardDeviation(), 0.0301836, 1e-7);
  EXPECT_NEAR(x.skewness(), -0.9351555, 1e-4);
  EXPECT_NEAR(x.kurtosis(), 4.8429719, 1e-3);

  // Without a solve: the largest tractions of ten thousand draws.
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> germs(10000, std::vector<double>(2));
  for (auto& point : germs) point = {normal(random), normal(random)};
  const auto sampler = problem.solver().sampler();
  const double before = seconds();
  const auto momentsOf = [&](const std::string& name) {
    const base::Matrix values = sampler.sample(static_cast<int>(problem.responseIndex(name)), germs);
    double mean = 0.0, square = 0.0;
    for (int s = 0; s < values.numCols(); ++s) mean += values(0, s) / values.numCols();
    for (int s = 0; s < values.numCols(); ++s) square += std::pow(values(0, s) - mean, 2) / values.numCols();
    return std::pair(mean, std::sqrt(square));
  };
  const auto [normalMean, normalDeviation] = momentsOf("glue_1_normal");
  const auto [tangentialMean, tangentialDeviation] = momentsOf("glue_1_tangential");
  const double used = seconds() - before;
  std::cout << "two maxima over 101 nodes of 10 000 draws: " << used << " s CPU\n";
  EXPECT_LT(used, 1.0);
  // Both are samples: four standard errors.
  EXPECT_NEAR(normalMean, 28.743568, 4 * 1.42 * 2.27 / 100.0);
  EXPECT_NEAR(normalDeviation, 2.273410, 0.05 * 2.27);
  EXPECT_NEAR(tangentialMean, 19.363325, 4 * 1.42 * 1.83 / 100.0);
  EXPECT_NEAR(tangentialDeviation, 1.825949, 0.05 * 1.83);
}

// The same Galerkin equations by the direct spectral method: conjugate gradients, then one factorisation.
TEST(RandomGlue, AgreesWithTheDirectSpectralMethod) {
  RandomGlue problem(Method::galerkin, 1e-6, false);
  const auto result = problem.solve(0.2, 0.25);
  ASSERT_EQ(result.outcome, latin::Outcome::certified) << result.reason;
  base::Timers timers;
  auto rival = problem.rival(0.2, 0.25, timers);
  EXPECT_EQ(rival.unknowns(), 371740);
  using Solver = stochastic::DirectSpectral::Solver;
  for (const Solver solver : {Solver::conjugateGradients, Solver::factorisation}) {
    rival.solve(solver, 1e-10);
    for (const char* name : {"u_x", "u_y"}) {
      const probability::Expansion expected = RandomGlue::response(result, name);
      const base::Matrix found = rival.coefficients(problem.displacement(name));
      EXPECT_NEAR(found(0, 0), expected.mean(), 1e-6 * std::abs(expected.mean()));
      for (int a = 1; a < found.numRows(); ++a) {
        EXPECT_NEAR(found(a, 0), expected.coefficients()[a], 1e-6 * expected.standardDeviation())
            << name << ", polynomial " << a;
      }
    }
    std::cout << rival.iterations() << " conjugate gradients; so far";
    for (const auto& phase : timers.phases()) std::cout << ", " << phase.name << " " << phase.cpuSeconds << " s CPU";
    std::cout << "\n";
  }
}

TEST(RandomGlue, LognormalMoments) {
  for (const Method method : {Method::galerkin, Method::pseudoSpectral}) {
    RandomGlue problem(method, 1e-5, false, 6);
    const auto result = problem.solve(0.2, 0.25);
    ASSERT_EQ(result.outcome, latin::Outcome::certified) << result.reason;
    const probability::Expansion y = RandomGlue::response(result, "u_y");
    EXPECT_NEAR(y.mean(), 0.336874291, 1e-6);
    EXPECT_NEAR(y.standardDeviation(), 0.006079107, 2e-4 * 0.006079107);
    EXPECT_NEAR(y.skewness(), 0.346159375, 2e-3);
    EXPECT_NEAR(y.kurtosis(), 3.256657337, 1e-2);  // truncated at order three
    EXPECT_NEAR(probability::sobolIndices(y)[0].main, 0.870854, 1e-4);
    const probability::Expansion x = RandomGlue::response(result, "u_x");
    EXPECT_NEAR(x.mean(), -2.097056445, 5e-6);
    EXPECT_NEAR(x.standardDeviation(), 0.027329686, 2e-4 * 0.027329686);
  }
}

// New laws on the same factors, each from the state of the one before.
TEST(RandomGlue, SweepOfTheDeviation) {
  RandomGlue problem(Method::galerkin, 1e-5, true);
  base::Matrix start;
  for (const auto& [d, expected] :
       {std::pair(0.2, 6.727391e-3), std::pair(0.3, 13.820518e-3), std::pair(0.4, 66.612424e-3)}) {
    const auto result = problem.solve(d, d, start.numRows() > 0 ? &start : nullptr);
    ASSERT_EQ(result.outcome, latin::Outcome::certified) << result.reason;
    EXPECT_NEAR(RandomGlue::response(result, "u_y").standardDeviation(), expected, 3e-5 * expected);
    start = problem.solver().alpha();
  }
}

// The error of a run is below its estimate, and that is below what was asked for.
TEST(RandomGlue, EstimateCoversTheError) {
  RandomGlue exactly(Method::galerkin, 1e-8, false);
  const auto exact = exactly.solve(0.2, 0.25);
  ASSERT_EQ(exact.outcome, latin::Outcome::certified) << exact.reason;
  for (double accuracy : {3e-2, 1e-2, 1e-3, 1e-4}) {
    RandomGlue problem(Method::galerkin, accuracy, false);
    const auto result = problem.solve(0.2, 0.25);
    ASSERT_EQ(result.outcome, latin::Outcome::certified) << result.reason;
    EXPECT_LE(result.errorEstimate, accuracy);
    for (std::size_t i = 0; i < exact.responses.size(); ++i) {
      const probability::Expansion truth = exact.responses[i].at(0), found = result.responses[i].at(0);
      double difference = 0.0;
      for (std::size_t a = 1; a < truth.coefficients().size(); ++a) {
        difference += std::pow(truth.coefficients()[a] - found.coefficients()[a], 2);
      }
      const double mean = std::abs(found.mean() - truth.mean()) / std::abs(truth.mean());
      const double spread = std::max(truth.standardDeviation(), 1e-3 * std::abs(truth.mean()));
      const double error = std::max(mean, std::sqrt(difference) / spread);
      std::cout << accuracy << " " << exact.responses[i].name << ": error " << error << ", estimate "
                << result.responses[i].errorEstimate << "\n";
      EXPECT_LE(error, std::max(1e-7, result.responses[i].errorEstimate)) << exact.responses[i].name;
    }
  }
}

}  // namespace
}  // namespace harmos::verification
