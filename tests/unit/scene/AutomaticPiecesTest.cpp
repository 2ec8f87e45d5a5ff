#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/scene/MeshSource.hpp>
#include <harmos/scene/detail/AutomaticPieces.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The sample with a lower box of 140 000 unknowns.
const std::string large = "Mesh/Boxes/lower/Cells={35,35,35}";

/// Nothing joins the boxes.
PieceChoice choiceFor(std::vector<std::string> overrides, double freeBytes) {
  overrides.insert(overrides.end(), {large, "Steps/wait/Increments=1"});
  const Scene scene = sample(overrides);
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
  return makeScene(input::InputTree::fromText(text, "sample.xml"), "sample.xml", {large, "Steps/wait/Increments=1"},
                   laws::builtInLaws());
}

TEST(AutomaticPieces, OfALargePartThatPays) {
  const PieceChoice choice = choiceFor({}, unlimited);
  ASSERT_EQ(choice.pieces.count("lower"), 1u);
  EXPECT_EQ(choice.pieces.count("upper"), 0u);
  EXPECT_GE(choice.pieces.at("lower"), 3);
  EXPECT_NE(choice.text.find("cut \"lower\" into"), std::string::npos) << choice.text;
  EXPECT_NE(choice.text.find("Pieces = 1 keeps a part whole"), std::string::npos) << choice.text;
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
  EXPECT_NE(choiceFor({}, 2.75e9).text.find("too much"), std::string::npos);
  EXPECT_TRUE(choiceFor({}, 1e8).pieces.empty());  // no cut helps so much
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

}  // namespace
}  // namespace harmos::scene
