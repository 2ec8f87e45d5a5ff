#include <gtest/gtest.h>

#include <algorithm>

#include <Tpetra_Core.hpp>

#include <harmos/latin/LatinSolver.hpp>
#include <harmos/scene/MeshError.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

/// What is said of the mesh error of a response.
std::string said(const std::vector<std::string>& overrides, const std::string& response) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const Scene scene = sample(overrides);
  const Problem problem = makeProblem(scene, *comm, timers);
  latin::LatinSolver solver(problem.assembly, latin::LatinOptions(scene.input.list("Solver")), comm, timers);
  for (const auto& each : problem.responses) solver.addResponse(each);
  const latin::LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, latin::Outcome::certified) << result.reason;
  const MeshErrors errors = estimateMeshErrors(problem, solver.fixedPoint(), solver.state(), problem.responses, *comm);
  const auto found = std::find_if(errors.responses.begin(), errors.responses.end(),
                                  [&](const ResponseMeshError& error) { return error.response == response; });
  if (found == errors.responses.end()) return "nothing";
  EXPECT_EQ(recordOf(*found).reason, found->reason.empty() ? found->locking : found->reason);
  return describe(*found, 0.0);
}

// With a Poisson's ratio of 0.4999 hexahedra that are clamped below hardly give way.
TEST(SceneMeshError, NamesPartsThatLockAndWhatHelps) {
  const std::string ratio = "Materials/steel/Poisson's Ratio=0.4999";
  const std::string locked = "lower is nearly incompressible, its elements lock: choose Formulation = B-Bar";
  EXPECT_NE(said({ratio}, "sink").find(locked), std::string::npos) << said({ratio}, "sink");
  EXPECT_EQ(said({ratio, "Parts/lower/Formulation=B-Bar"}, "sink").find("lower is nearly"), std::string::npos);
  EXPECT_EQ(said({"Materials/steel/Poisson's Ratio=0.3"}, "sink").find("incompressible"), std::string::npos);
  const std::string tetrahedra =
      said({ratio, "Mesh/Boxes/lower/Element=Tet4", "Mesh/Boxes/upper/Element=Tet4"}, "sink");
  EXPECT_NE(tetrahedra.find("its elements lock: mesh it with HEX8 and choose Formulation = B-Bar"), std::string::npos)
      << tetrahedra;
}

}  // namespace
}  // namespace harmos::scene
