#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>

#include <Tpetra_Core.hpp>

#include <harmos/files/NodalVariable.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/scene/SceneRun.hpp>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

// Width 2, depth 1, each block 0.2 high; pressure 10, 10, 5, shear 0, 1, 1; friction 0.5.
constexpr double area = 2.0, arm = 0.2, shear = 1.0 * area;
constexpr double tolerance = 1e-6;
const char* const scene = "results/two_blocks.xml";

TEST(RanksResults, SafetiesFollowFromEquilibrium) {
  const SolvedScene run(SceneInput::fromFile(scene));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double slip[] = {1000.0, 5.0, 2.5}, gaping[] = {1000.0, 1000.0, 2.0};
  for (int step = 0; step < 3; ++step) {
    EXPECT_NEAR(run.value("slip", step), slip[step], tolerance * slip[step]) << step;
    EXPECT_NEAR(run.value("gaping", step), gaping[step], tolerance * gaping[step]) << step;
  }
  // The shear bends the pressure: less where the upper block would lift first, at x = 0.
  EXPECT_LT(run.value("slip_at_a_point"), 2.4);
  EXPECT_GT(run.value("slip_at_a_point"), 1.0);
  EXPECT_LT(run.value("gaping_at_a_point"), 1.9);
  EXPECT_GT(run.value("gaping_at_a_point"), 1.0);
}

TEST(RanksResults, PointsWithoutFrictionHaveNoSafetyAgainstSlip) {
  const SolvedScene run(SceneInput::fromFile(scene)
                            .set("Interfaces/contact/Law/Friction Coefficient=0")
                            .set("Boundaries/load/Law/X=0")
                            .add("Boundaries", xmlList("kept", xmlText("Side Set", "upper_xmin") +
                                                                   xmlList("Law", xmlText("Type", "Symmetry")))));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_EQ(run.value("slip"), 1000.0);
  EXPECT_EQ(run.value("slip_at_a_point"), 1000.0);
  EXPECT_NEAR(run.value("gaping"), 2.0, tolerance);
}

TEST(RanksResults, SectionForcesFollowFromEquilibrium) {
  const SolvedScene run(SceneInput::fromFile(scene));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  EXPECT_NEAR(run.value("axial", 0), -10.0 * area, 1e-5);
  EXPECT_NEAR(run.value("axial"), -5.0 * area, 1e-5);
  EXPECT_NEAR(run.value("shear", 0), 0.0, 1e-5);
  EXPECT_NEAR(run.value("shear"), shear, 1e-5);
  EXPECT_NEAR(run.value("bending", 0), 0.0, 1e-5);
  EXPECT_NEAR(run.value("bending"), shear * arm, 1e-5);
  EXPECT_NEAR(run.value("torque"), 0.0, 1e-5);
}

TEST(RanksResults, NodalStressOfAUniformStateIsExactInAPartThatIsCut) {
  const SolvedScene run(SceneInput::fromFile(scene));
  EXPECT_NEAR(run.value("von_mises", 0), 10.0, 1e-4);
  EXPECT_GT(run.value("von_mises"), 5.0);
}

TEST(RanksResults, RecordHasForcesEnergiesAndEquilibriumOfTheLastStep) {
  const auto comm = Tpetra::getDefaultComm();
  scene::SceneRunRequest request;
  request.scene = std::string(HARMOS_VERIFICATION_DIR) + "/" + scene;
  request.overrides = {"Output/Nodal Stress=true"};
  request.directory = "results_test_" + std::to_string(comm->getSize());
  const scene::SceneRunResult result = scene::runScene(request, laws::builtInLaws(), comm);
  const files::SolutionRecord& record = result.record.solution;
  ASSERT_EQ(record.interfaces.size(), 4u);  // the cut is none of the scene's
  const files::InterfaceRecord& contact = record.interfaces[0];
  const files::InterfaceRecord& glue = record.interfaces[1];
  const files::InterfaceRecord& held = record.interfaces[2];
  EXPECT_EQ(contact.name, "contact");
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(contact.centre[c], (base::Vector3{1.0, 0.5, 0.2})[c], 1e-12);
  EXPECT_NEAR(contact.axial, -5.0 * area, 1e-5);
  ASSERT_TRUE(contact.slip && contact.gaping);
  EXPECT_NEAR(contact.slip->whole, 2.5, 1e-5);
  EXPECT_NEAR(contact.gaping->worst.position[0], 0.0, 1e-12);
  EXPECT_FALSE(glue.slip || glue.gaping);
  EXPECT_FALSE(held.slip || held.gaping);
  ASSERT_TRUE(record.slip);
  EXPECT_EQ(record.slip->worst.of, "contact");
  // Shear and pressure are not uniform, so the springs store more than by their means.
  const double uniform = 0.5 * area * (5.0 * 5.0 + 1.0) / 5000.0;
  EXPECT_GT(glue.stored, uniform);
  EXPECT_LT(glue.stored, 1.2 * uniform);
  EXPECT_EQ(contact.stored, 0.0);
  // What holds the plate: about the centre of its face, three heights below the load.
  EXPECT_NEAR(held.force[0], -shear, 1e-5);
  EXPECT_NEAR(held.force[2], 5.0 * area, 1e-5);
  EXPECT_NEAR(held.moment[1], -3.0 * arm * shear, 1e-5);
  ASSERT_EQ(record.parts.size(), 3u);
  for (const files::PartRecord& part : record.parts) {
    EXPECT_GT(part.largestForce, 5.0 * area) << part.name;
    EXPECT_LT(base::norm(part.force), 1e-5) << part.name;
    EXPECT_LT(base::norm(part.moment), 1e-5) << part.name;
  }
  if (comm->getRank() != 0) return;
  ASSERT_TRUE(record.largestVonMises);
  EXPECT_EQ(record.largestVonMises->at, "nodes");
  EXPECT_GT(record.largestVonMises->point.value, 5.0);
  // Four interfaces and the cut; points that pieces share count once.
  const auto areas = files::readNodalVariable(request.directory + "/two_blocks_interfaces.e", "area", 0);
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 4.0 * area + 0.2, 1e-12);
  std::filesystem::remove_all(request.directory);
}

}  // namespace
}  // namespace harmos::verification
