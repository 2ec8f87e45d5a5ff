#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/scene/MeshSource.hpp>
#include <harmos/scene/detail/AutomaticPieces.hpp>
#include <harmos/substructure/MultigridLibrary.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The sample with a lower box of 129 000 unknowns, whose tetrahedra are not their own mirror images.
const std::string large = "Mesh/Boxes/lower/Cells={17,17,17}", tetrahedra = "Mesh/Boxes/lower/Element=Tet10";

/// Nothing joins the boxes.
PieceChoice choiceFor(std::vector<std::string> overrides, double freeBytes, const std::string& text = sampleScene()) {
  overrides.insert(overrides.begin(), {large, tetrahedra, "Steps/wait/Increments=1"});
  const Scene scene =
      makeScene(input::InputTree::fromText(text, "sample.xml"), "sample.xml", overrides, laws::builtInLaws());
  const mesh::Mesh mesh = makeMesh(scene.input.list("Mesh"), "");
  input::ErrorList errors;
  return choosePieces(scene, mesh, makeBodies(scene, mesh, errors), {}, 3, 1, freeBytes);
}

/// Two load steps, and perfect joints.
Scene glued() {
  std::string text = sampleScene();
  const std::string law = "value=\"Coulomb Friction\"/>", next = "</ParameterList>";
  const std::size_t at = text.find(law);
  text.replace(at, text.find(next, at) - at, "value=\"Perfect\"/>");
  return makeScene(input::InputTree::fromText(text, "sample.xml"), "sample.xml",
                   {large, tetrahedra, "Steps/wait/Increments=1"}, laws::builtInLaws());
}

std::string box(const std::string& name, const std::string& lower, const std::string& upper, const std::string& mesh) {
  return "<ParameterList name=\"" + name + "\"><Parameter name=\"Lower Corner\" type=\"Array(double)\" value=\"{" +
         lower + "}\"/><Parameter name=\"Upper Corner\" type=\"Array(double)\" value=\"{" + upper + "}\"/>" + mesh +
         "</ParameterList>";
}

std::string part(const std::string& name) {
  return "<ParameterList name=\"" + name +
         "\"><Parameter name=\"Material\" type=\"string\" value=\"steel\"/></ParameterList>";
}

std::string contact(const std::string& name, const std::string& one, const std::string& two) {
  return "<ParameterList name=\"" + name + "\"><Parameter name=\"Part 1\" type=\"string\" value=\"" + one +
         "\"/><Parameter name=\"Part 2\" type=\"string\" value=\"" + two +
         "\"/><ParameterList name=\"Law\"><Parameter name=\"Type\" type=\"string\" value=\"Unilateral "
         "Contact\"/></ParameterList></ParameterList>";
}

/// A plate of 85 000 unknowns and two layers between coarse blocks: points of these see whole faces of it, so that no
/// element can be divided from the others of its layer. A third block touches it unevenly.
Scene sandwich() {
  const std::string coarse = R"xml(<Parameter name="Cells" type="Array(double)" value="{3, 3, 1}"/>)xml";
  const std::string fine = R"xml(<Parameter name="Cells" type="Array(double)" value="{50, 50, 2}"/>)xml"
                           R"(<Parameter name="Element" type="string" value="Hex20"/>)";
  const std::string text =
      R"(<ParameterList name="Harmos"><ParameterList name="Mesh"><Parameter name="Type" type="string" value="Boxes"/>)"
      R"(<ParameterList name="Boxes">)" +
      box("below", "0, 0, 0", "2, 2, 1", coarse) + box("plate", "0, 0, 1", "2, 2, 1.05", fine) +
      box("above", "0, 0, 1.05", "2, 2, 2", coarse) + box("beside", "2, 0, 1", "3, 1, 1.02", coarse) +
      R"(</ParameterList></ParameterList><ParameterList name="Materials"><ParameterList name="steel">)"
      R"(<Parameter name="Type" type="string" value="Isotropic"/>)"
      R"(<Parameter name="Young's Modulus" type="double" value="1000"/>)"
      R"(<Parameter name="Poisson's Ratio" type="double" value="0.3"/>)"
      R"(</ParameterList></ParameterList><ParameterList name="Parts">)" +
      part("below") + part("plate") + part("above") + part("beside") +
      R"(</ParameterList><ParameterList name="Interfaces">)" + contact("lower", "below", "plate") +
      contact("upper", "plate", "above") + contact("side", "plate", "beside") +
      R"(</ParameterList><ParameterList name="Steps"><ParameterList name="load"/></ParameterList>)"
      R"(<ParameterList name="Responses"/></ParameterList>)";
  return makeScene(input::InputTree::fromText(text, "sandwich.xml"), "sandwich.xml", {}, laws::builtInLaws());
}

TEST(AutomaticPieces, OfALargePartThatPays) {
  const PieceChoice choice = choiceFor({}, unlimited);
  ASSERT_EQ(choice.pieces.count("lower"), 1u);
  EXPECT_EQ(choice.pieces.count("upper"), 0u);
  EXPECT_GE(choice.pieces.at("lower"), 3);
  EXPECT_NE(choice.text.find("cut \"lower\" into"), std::string::npos) << choice.text;
  EXPECT_NE(choice.text.find("Pieces = 1 keeps a part whole"), std::string::npos) << choice.text;
}

// Its mirror planes cut it in blocks that are as cheap.
TEST(AutomaticPieces, OfNoPartThatIsItsOwnMirrorImage) {
  EXPECT_TRUE(
      choiceFor({"Mesh/Boxes/lower/Cells={35,35,35}", "Mesh/Boxes/lower/Element=Hex8"}, unlimited).pieces.empty());
}

// The mesh is, the material need not be.
TEST(AutomaticPieces, OfAPartWhoseMaterialIsNotItsOwnMirrorImage) {
  const auto choiceWithAxes = [](const std::string& one, const std::string& two) {
    std::string text = sampleScene(), law = "value=\"Orthotropic\"/>";
    for (const std::string number : {"1", "2", "3"})
      law += "<Parameter name=\"Young's Modulus " + number + "\" type=\"double\" value=\"9" + number + "0\"/>";
    for (const std::string number : {"12", "23", "13"}) {
      law += "<Parameter name=\"Poisson's Ratio " + number + "\" type=\"double\" value=\"0.3\"/>";
      law += "<Parameter name=\"Shear Modulus " + number + "\" type=\"double\" value=\"350\"/>";
    }
    law += "<Parameter name=\"Axis 1\" type=\"Array(double)\" value=\"" + one + "\"/>";
    law += "<Parameter name=\"Axis 2\" type=\"Array(double)\" value=\"" + two + "\"/>";
    const std::string isotropic = "value=\"Isotropic\"/>", next = "</ParameterList>";
    const std::size_t at = text.find(isotropic);
    text.replace(at, text.find(next, at) - at, law);
    return choiceFor({"Mesh/Boxes/lower/Cells={35,35,35}", "Mesh/Boxes/lower/Element=Hex8"}, unlimited, text);
  };
  EXPECT_TRUE(choiceWithAxes("{0, 0, 1}", "{-1, 0, 0}").pieces.empty());
  EXPECT_EQ(choiceWithAxes("{3, 2, 1}", "{-1, 2, 1}").pieces.count("lower"), 1u);
}

TEST(AutomaticPieces, WhatIsGivenWins) {
  EXPECT_TRUE(choiceFor({"Parts/lower/Pieces=1"}, unlimited).pieces.empty());
}

TEST(AutomaticPieces, NothingIsCutWhereNoCutsWereMeasured) {
  EXPECT_TRUE(choiceFor({"Solver/Accuracy=1e-7"}, unlimited).pieces.empty());
  EXPECT_TRUE(choiceFor({"Solver/Algorithm=Plain"}, unlimited).pieces.empty());
}

TEST(AutomaticPieces, MemoryThatThereIsNotIsSaidAsTheReason) {
  EXPECT_EQ(choiceFor({}, unlimited).text.find("too much"), std::string::npos);
  EXPECT_NE(choiceFor({}, 2.6e9).text.find("too much"), std::string::npos);
  EXPECT_TRUE(choiceFor({}, 1e8).pieces.empty());  // no cut helps so much
}

// Cuts were not measured at such an accuracy.
TEST(AutomaticPieces, WhatNeitherFitsNorMayBeCutIsSolvedIteratively) {
  if (!substructure::hasMultigrid()) GTEST_SKIP() << "built without MueLu";
  const std::string fine = "Solver/Accuracy=1e-7";
  const PieceChoice choice = choiceFor({fine}, 2e9);
  EXPECT_TRUE(choice.pieces.empty());
  EXPECT_EQ(choice.iterated, std::set<std::string>{"lower"});
  EXPECT_NE(choice.text.find("solve \"lower\" iteratively"), std::string::npos) << choice.text;
  EXPECT_TRUE(choiceFor({fine}, unlimited).iterated.empty());
  EXPECT_TRUE(choiceFor({fine}, 1e8).iterated.empty());  // that does not fit either
  EXPECT_TRUE(choiceFor({fine, "Parts/lower/Linear Solver=Direct"}, 2e9).iterated.empty());
  EXPECT_TRUE(choiceFor({}, 2.6e9).iterated.empty());  // pieces fit
}

TEST(AutomaticPieces, SmallScenesAreLeftAsTheyAre) {
  base::Timers timers;
  const Problem problem = makeProblem(sample(), *Tpetra::getDefaultComm(), timers, Cutting::automatic);
  EXPECT_TRUE(problem.pieces.empty());
  EXPECT_EQ(problem.cuts, "");
  EXPECT_EQ(problem.bodies.pieces.size(), 2u);
}

TEST(AutomaticPieces, ProblemsHaveThemAndSayWhy) {
  base::Timers timers;
  const Problem problem = makeProblem(glued(), *Tpetra::getDefaultComm(), timers, Cutting::automatic);
  ASSERT_EQ(problem.pieces.size(), 1u);
  EXPECT_EQ(problem.bodies.pieces.size(), static_cast<std::size_t>(1 + problem.pieces.at("lower")));
  EXPECT_EQ(problem.assembly.bodies.size(), problem.bodies.pieces.size());
  EXPECT_FALSE(problem.cuts.empty());
}

TEST(AutomaticPieces, WhatCannotBeCutAsChosenStaysWhole) {
  const auto comm = Tpetra::getDefaultComm();
  base::Timers timers;
  const Scene scene = sandwich();
  const Problem whole = makeProblem(scene, *comm, timers);
  const PieceChoice choice =
      choosePieces(scene, whole.mesh, whole.bodies, whole.assembly.interfaces, 3, comm->getSize(), unlimited);
  ASSERT_GE(choice.pieces.count("plate"), 1u);
  const Problem problem = makeProblem(scene, *comm, timers, Cutting::automatic);
  EXPECT_TRUE(problem.pieces.empty());
  EXPECT_EQ(problem.cuts, "");
  ASSERT_EQ(problem.bodies.pieces.size(), 4u);
  EXPECT_EQ(problem.bodies.pieces[1].nodes.size(), whole.bodies.pieces[1].nodes.size());
  ASSERT_EQ(problem.assembly.interfaces.size(), 3u);
  EXPECT_EQ(problem.assembly.interfaces[0].pairs(), whole.assembly.interfaces[0].pairs());
}

}  // namespace
}  // namespace harmos::scene
