#include <gtest/gtest.h>

#include <map>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinSolver.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

TEST(Problem, HoldsBodiesAndInterfacesOfTheScene) {
  const auto comm = Tpetra::getDefaultComm();
  const Scene scene = sample({"Parts/lower/Pieces=2"});
  base::Timers timers;
  const Problem problem = makeProblem(scene, *comm, timers);
  EXPECT_EQ(problem.assembly.bodies.size(), 3u);
  EXPECT_EQ(problem.surfaces.size(), problem.assembly.interfaces.size());
  EXPECT_EQ(problem.responses.size(), 3u);
  // A body force of 3 per volume on a volume of 4, reached at the third step.
  double force = 0.0, sum = 0.0;
  const base::Matrix& loads = problem.assembly.bodies[2].loads;
  for (int dof = 2; dof < loads.numRows(); dof += 3) force += loads(dof, 2);
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_SUM, force, Teuchos::outArg(sum));
  EXPECT_NEAR(sum, -12.0, 1e-12);
}

TEST(Problem, PatternsJoinThePartsThatTouchAndThatNoOtherInterfaceNames) {
  const auto comm = Tpetra::getDefaultComm();
  const auto pairsOf = [&](const std::vector<std::string>& overrides, const std::string& more) {
    std::string text = sampleScene();
    text.insert(text.find("<ParameterList name=\"seal\">"), more);
    const Scene scene =
        makeScene(input::InputTree::fromText(text, "sample.xml"), "sample.xml", overrides, laws::builtInLaws());
    base::Timers timers;
    const Problem problem = makeProblem(scene, *comm, timers);
    std::map<std::string, std::size_t> pairs;
    for (const assembly::Interface& interface : problem.assembly.interfaces) {
      pairs[interface.name] += interface.pairs();
    }
    return pairs;
  };
  const std::vector<std::string> all{"Interfaces/seal/Part 1=*", "Interfaces/seal/Part 2=?????",
                                     "Parts/upper/Pieces=2"};
  EXPECT_EQ(pairsOf(all, ""), pairsOf({"Parts/upper/Pieces=2"}, ""));
  const std::string bond = R"(<ParameterList name="bond">
      <Parameter name="Side 1" type="string" value="lower_zmax"/>
      <Parameter name="Side 2" type="string" value="upper_zmin"/>
      <ParameterList name="Law"><Parameter name="Type" type="string" value="Perfect"/></ParameterList></ParameterList>)";
  EXPECT_THROW(pairsOf(all, bond), base::Error);
}

TEST(Problem, ConsistentMassOnRequest) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const Scene lumped = sample();
  EXPECT_TRUE(makeProblem(lumped, *comm, timers).assembly.interfaces[0].mass.empty());
  const Scene consistent = sample({"Solver/Interface Mass=Consistent"});
  EXPECT_FALSE(makeProblem(consistent, *comm, timers).assembly.interfaces[0].mass.empty());
}

TEST(Problem, PressedBlocksCarryTheLoad) {
  const auto comm = Tpetra::getDefaultComm();
  for (const std::string pieces : {"1", "3"}) {
    const Scene scene = sample({"Parts/upper/Pieces=" + pieces, "Solver/Accuracy=1e-6"});
    base::Timers timers;
    const Problem problem = makeProblem(scene, *comm, timers);
    latin::LatinSolver solver(problem.assembly, latin::LatinOptions(scene.input.list("Solver")), comm, timers);
    for (const auto& response : problem.responses) solver.addResponse(response);
    const latin::LatinResult result = solver.solve();
    EXPECT_EQ(result.outcome, latin::Outcome::certified) << result.reason;
    // At the end 10 * 4 by pressure and 12 by weight; compression 10/E over both blocks, (3/2 + 3) / E by the weight.
    // The tolerance is the accuracy asked for.
    EXPECT_NEAR(result.responses[0].values.back(), -52.0, 52e-6);
    EXPECT_NEAR(result.responses[1].values.back(), 0.0245, 0.0245e-6);
    EXPECT_NEAR(result.responses[2].values.back(), 0.0245, 0.0245e-6);
  }
}

}  // namespace
}  // namespace harmos::scene
