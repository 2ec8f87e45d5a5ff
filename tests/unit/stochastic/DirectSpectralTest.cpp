#include <functional>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/stochastic/DirectSpectral.hpp>

#include "RandomChains.hpp"

namespace harmos::stochastic {
namespace {

constexpr int steps = 3;

/// Stiffness of the joint, load and the way of the ground's spring are random.
std::vector<Law> lawsOf(const std::vector<double>& x) {
  return {
      laws::makeLaw("Prescribed Displacement", {{"X", 0.1 * x[1]}, {"Y", 0.0}, {"Z", 0.0}}, {{"X", {1.0, 2.0, 0.0}}}),
      spring(x[0], 0.5 * x[0]), pull(x[1], 0.5, {{"X", {0.5, -1.0, 1.0}}})};
}

void expectAgreement(const std::function<void(assembly::Assembly&)>& change) {
  const auto projection = projectionOf(randomVector({std::make_shared<probability::Lognormal>(10.0, 3.0),
                                                     std::make_shared<probability::Normal>(2.0, 0.2)}),
                                       3);
  const Realisations laws = realisations(*projection, lawsOf);
  assembly::Assembly assembly = springsInSeries(laws[0], steps);
  change(assembly);
  const std::vector<std::shared_ptr<const latin::Response>> responses = {displacement("end", 1, 2),
                                                                         displacement("side", 1, 0, {0.0, 1.0, 0.0})};
  base::Timers timers;
  StochasticOptions options;
  options.method = Method::galerkin;
  options.accuracy = 1e-8;
  StochasticSolver solver(assembly, projection, options, latin::self(), timers);
  solver.setLaws(laws);
  for (const auto& response : responses) solver.addResponse(response);
  const StochasticResult expected = solver.solve();
  ASSERT_EQ(expected.outcome, latin::Outcome::certified) << expected.reason;

  DirectSpectral direct(assembly, projection, laws, {}, timers);
  EXPECT_EQ(direct.unknowns(), 21 * 10);
  for (const auto way : {DirectSpectral::Solver::conjugateGradients, DirectSpectral::Solver::factorisation}) {
    direct.solve(way, 1e-12);
    EXPECT_EQ(direct.iterations() > 0, way == DirectSpectral::Solver::conjugateGradients);
    for (std::size_t i = 0; i < responses.size(); ++i) {
      const base::Matrix found = direct.coefficients(static_cast<const latin::DisplacementResponse&>(*responses[i]));
      for (int t = 0; t < steps; ++t) {
        for (int a = 0; a < projection->terms(); ++a) {
          EXPECT_NEAR(found(a, t), expected.responses[i].coefficients(a, t), 1e-8) << "polynomial " << a;
        }
      }
    }
  }
}

// The equations are those of Galerkin's LATIN, solved in another way.
TEST(DirectSpectral, AgreesWithGalerkin) {
  expectAgreement([](assembly::Assembly&) {});
}

TEST(DirectSpectral, AgreesWithGalerkinBetweenMeansOfNodes) {
  expectAgreement([](assembly::Assembly& assembly) {
    assembly::Interface &joint = assembly.interfaces[1], &end = assembly.interfaces[2];
    joint.trace1 = joint.trace2 = end.trace1 = {};
    joint.trace1.append({{3, 1.25}, {2, -0.25}});
    joint.trace2.append({{0, 0.5}, {1, 0.5}});
    end.trace1.append({{2, 0.75}, {1, 0.25}});
  });
}

TEST(DirectSpectral, RefusesWhatItDoesNotTreat) {
  const auto projection = projectionOf(randomVector({std::make_shared<probability::Normal>(1.0, 0.1)}), 1);
  base::Timers timers;
  for (const char* joint : {"Perfect", "Unilateral Contact"}) {
    const assembly::Assembly assembly = springsInSeries({foundation(1.0), laws::makeLaw(joint), pull(1.0)});
    const Realisations laws = realisations(*projection, [&](const std::vector<double>& k) -> std::vector<Law> {
      return {foundation(k[0]), laws::makeLaw(joint), pull(1.0)};
    });
    try {
      const DirectSpectral direct(assembly, projection, laws, {}, timers);
      FAIL();
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ExitCode::input);
      EXPECT_NE(std::string(error.what()).find("interface \"joint\""), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace harmos::stochastic
