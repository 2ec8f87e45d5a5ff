// The same random assembly on several ranks: bodies apart, ranks without a body.
#include <cmath>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include "RandomChains.hpp"

namespace harmos::stochastic {
namespace {

constexpr int steps = 3;

struct Answer {
  StochasticResult result;
  base::Matrix samples;
};

Answer solve(Method method, const std::vector<int>& owner, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const auto lawsOf = [method](const std::vector<double>& x) -> std::vector<Law> {
    const Law joint = method == Method::galerkin
                          ? spring(x[0], 0.5 * x[0])
                          : laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.04 * x[0]}});
    return {foundation(20.0, 15.0), joint, pull(-x[1], 0.3, {{"Y", {0.5, 1.0, -1.0}}}), spring(30.0, 20.0),
            foundation(2.0, 3.0)};
  };
  const auto projection = projectionOf(randomVector({std::make_shared<probability::Lognormal>(10.0, 1.0),
                                                     std::make_shared<probability::Normal>(2.0, 0.2)}),
                                       3);
  const Realisations laws = realisations(*projection, lawsOf);
  assembly::Assembly assembly = springsInSeries(laws[0], steps);
  assembly.bodies.push_back(latin::chain("third", 5.0, 3, 50.0));
  assembly.interfaces.push_back(latin::pointInterface("glue", laws[0][3], 1, 2, 2, 0));
  assembly.interfaces.push_back(latin::pointInterface("far end", laws[0][4], 2, 2));
  assembly.owner = owner;
  for (std::size_t b = 0; b < owner.size(); ++b) {
    if (owner[b] != comm->getRank()) assembly.bodies[b].stiffness = Teuchos::null;
  }
  StochasticOptions options;
  options.method = method;
  options.accuracy = 1e-7;
  base::Timers timers;
  StochasticSolver solver(assembly, projection, options, comm, timers);
  solver.setLaws(laws);
  solver.addResponse(displacement("end", 1, 2, {0.0, 1.0, 0.0}));
  solver.addResponse(
      std::make_shared<latin::ResultantResponse>("force", std::vector<int>{3}, std::vector<base::Vector3>{}));
  solver.addResponse(std::make_shared<latin::MaximumResponse>("shear", std::vector<int>{1},
                                                              latin::MaximumResponse::Field::tangentialTraction));
  Answer answer{solver.solve(), {}};
  answer.samples = solver.sampler().sample(2, {{0.3, -0.4}, {-1.0, 2.0}});
  return answer;
}

class Ranks : public testing::TestWithParam<Method> {};

TEST_P(Ranks, FindTheSame) {
  const auto comm = Tpetra::getDefaultComm();
  const Answer alone = solve(GetParam(), {0, 0, 0}, latin::self());
  ASSERT_EQ(alone.result.outcome, latin::Outcome::certified) << alone.result.reason;
  const int last = comm->getSize() - 1;
  for (const std::vector<int>& owner : {std::vector<int>{0, last, 0}, {last, 0, 0}, {0, 0, last}}) {
    const Answer shared = solve(GetParam(), owner, comm);
    ASSERT_EQ(shared.result.outcome, latin::Outcome::certified) << shared.result.reason;
    for (std::size_t i = 0; i < alone.result.responses.size(); ++i) {
      const base::Matrix& expected = alone.result.responses[i].coefficients;
      const base::Matrix& found = shared.result.responses[i].coefficients;
      for (int t = 0; t < steps; ++t) {
        for (int a = 0; a < expected.numRows(); ++a)
          EXPECT_NEAR(found(a, t), expected(a, t), 2e-7 * expected.normInf());
      }
    }
    for (int t = 0; t < steps; ++t) {
      for (int s = 0; s < 2; ++s) {
        EXPECT_NEAR(shared.samples(t, s), alone.samples(t, s), 2e-7 * std::max(0.1, std::abs(alone.samples(t, s))));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Ranks, testing::Values(Method::galerkin, Method::pseudoSpectral),
                         [](const auto& tested) { return tested.param == Method::galerkin ? "Galerkin" : "Points"; });

}  // namespace
}  // namespace harmos::stochastic
