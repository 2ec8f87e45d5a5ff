#include <gtest/gtest.h>

#include <set>
#include <string>

#include <Tpetra_Core.hpp>

#include <harmos/scene/MeshSource.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

TEST(Bodies, PiecesKeepTheOptionsOfTheirPart) {
  const Scene scene = sample({"Parts/lower/Pieces=2"});
  const mesh::Mesh mesh = makeMesh(scene.input.list("Mesh"), "");
  input::ErrorList errors;
  const Bodies bodies = makeBodies(scene, mesh, errors);
  ASSERT_EQ(errors.count(), 0);
  ASSERT_EQ(bodies.pieces.size(), 3u);
  EXPECT_EQ(bodies.parts[0].name, "lower");
  EXPECT_EQ(bodies.parts[1].name, "lower");
  EXPECT_EQ(bodies.parts[2].name, "upper");
}

TEST(Bodies, PiecesOfTheSceneWinOverOthers) {
  const Scene scene = sample({"Parts/lower/Pieces=2"});
  const mesh::Mesh mesh = makeMesh(scene.input.list("Mesh"), "");
  input::ErrorList errors;
  EXPECT_EQ(makeBodies(scene, mesh, errors, {}, {{"lower", 4}, {"upper", 3}}).pieces.size(), 5u);
}

TEST(Bodies, EqualBodiesAreFoundButNotAcrossFormulations) {
  for (const std::string formulation : {"Full Integration", "B-Bar"}) {
    const Scene scene = sample({"Parts/upper/Formulation=" + formulation});
    const mesh::Mesh mesh = makeMesh(scene.input.list("Mesh"), "");
    input::ErrorList errors;
    const auto congruences =
        findCongruences(makeBodies(scene, mesh, errors), mesh, elasticity::Kinematics::threeDimensional, {});
    EXPECT_EQ(congruences[0], nullptr);
    EXPECT_EQ(congruences[1] != nullptr, formulation == "Full Integration");
  }
}

TEST(Bodies, RingsOfOtherRadiiAreNotEqual) {
  Scene scene = sample({"Parts/upper/Formulation=Full Integration"});
  mesh::Mesh mesh = makeMesh(scene.input.list("Mesh"), "");
  input::ErrorList errors;
  const Bodies bodies = makeBodies(scene, mesh, errors);
  const auto isEqual = [&] {
    return findCongruences(bodies, mesh, elasticity::Kinematics::axisymmetric, {})[1] != nullptr;
  };
  EXPECT_TRUE(isEqual());  // one above the other
  for (const int node : bodies.pieces[1].nodes) mesh.nodes[node][0] += 3.0;
  EXPECT_FALSE(isEqual());
}

TEST(Bodies, AreMirrorImagesWhereInterfacesAre) {
  const auto replace = [](std::string text, const std::string& old, const std::string& now) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), now);
  };
  // Held below and above, joined between.
  std::string held = replace(sampleScene(), "value=\"Pressure\"", "value=\"Prescribed Displacement\"");
  held = replace(held, "name=\"Pressure\" type=\"double\" value=\"10\"", "name=\"Z\" type=\"double\" value=\"-0.1\"");
  held = replace(held, "name=\"Pressure History\"", "name=\"Z History\"");
  base::Timers timers;
  for (const bool isHeld : {false, true}) {
    const Scene scene =
        makeScene(input::InputTree::fromText(isHeld ? held : sampleScene(), "sample.xml"), "sample.xml",
                  isHeld ? std::vector<std::string>{"Boundaries/pressed/Law/X=0", "Boundaries/pressed/Law/Y=0"}
                         : std::vector<std::string>{},
                  laws::builtInLaws());
    const Problem problem = makeProblem(scene, *Tpetra::getDefaultComm(), timers);
    const auto& congruence = problem.bodies.congruences[1];
    ASSERT_TRUE(congruence);
    EXPECT_EQ(congruence->representative, 0);
    // A translation where nothing else is gained.
    EXPECT_EQ(congruence->rotation[2][2], isHeld ? -1.0 : 1.0);
    const assembly::Interface& seal = problem.assembly.interfaces[0];
    std::set<int> above;
    for (int p = 0; p < seal.pairs(); ++p) above.insert(seal.trace2.node(p));
    for (int p = 0; p < seal.pairs(); ++p)
      EXPECT_EQ(above.count(congruence->node[seal.trace1.node(p)]), isHeld ? 1U : 0U);
  }
}

/// The part "upper" of the sample, x and y in (0, 2), z in (1, 2), under a body force -3 ramp(t) along z times a
/// formula.
class UnderAFormula {
 public:
  explicit UnderAFormula(const std::string& formula)
      : scene_(sample({"Parts/upper/Body Force/Z Formula=" + formula})),
        mesh_(makeMesh(scene_.input.list("Mesh"), "")),
        bodies_(makeBodies(scene_, mesh_, errors)) {
    if (errors.count() > 0) return;
    const Temperatures none(scene_, mesh_, errors);
    const auto assembled =
        assemble(scene_, mesh_, makeModel(scene_.input.list("Model"), mesh_), bodies_, none, {}, {0, 0}, 0, errors);
    loads_ = assembled[1].loads;
  }

  /// Integral of the force times x at the end of load step 5, where t = 3 and the ramp is 1; and without x.
  double moment() const {
    return sum([](const base::Vector3& place) { return place[0]; });
  }
  double resultant() const {
    return sum([](const base::Vector3&) { return 1.0; });
  }

  input::ErrorList errors;

 private:
  template <class Weight>
  double sum(const Weight& weight) const {
    double total = 0.0;
    const std::vector<int>& nodes = bodies_.pieces[1].nodes;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      total += weight(mesh_.nodes[nodes[node]]) * loads_(3 * static_cast<int>(node) + 2, 4);
    }
    return total;
  }

  Scene scene_;
  mesh::Mesh mesh_;
  Bodies bodies_;
  base::Matrix loads_;
};

TEST(Bodies, ForcesFollowAFormulaOfPlaceAndTime) {
  const UnderAFormula varied("(x + 2 * y * z) * t"), grown("t^2");
  ASSERT_EQ(varied.errors.count(), 0);
  EXPECT_NEAR(varied.resultant(), -3.0 * 3.0 * (4.0 + 12.0), 1e-12 * 144.0);
  EXPECT_NEAR(varied.moment(), -3.0 * 3.0 * (16.0 / 3.0 + 12.0), 1e-12 * 144.0);
  EXPECT_NEAR(grown.resultant(), -3.0 * 9.0 * 4.0, 1e-12 * 108.0);
}

TEST(Bodies, FormulasWithoutValueAreRefusedWithTheirPlace) {
  const std::string message = UnderAFormula("sqrt(x - 1)").errors.message();
  EXPECT_NE(message.find("Parts / upper / Body Force / Z Formula: "), std::string::npos) << message;
}

TEST(Bodies, LargestGoFirstToTheLeastBusyRank) {
  Bodies bodies;
  for (const std::size_t nodes : {10u, 100u, 60u, 50u}) {
    bodies.pieces.emplace_back();
    bodies.pieces.back().nodes.resize(nodes);
  }
  EXPECT_EQ(distribute(bodies, 1), (std::vector<int>{0, 0, 0, 0}));
  EXPECT_EQ(distribute(bodies, 2), (std::vector<int>{1, 0, 1, 1}));
}

}  // namespace
}  // namespace harmos::scene
