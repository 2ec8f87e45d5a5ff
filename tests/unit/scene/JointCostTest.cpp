#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/scene/ProblemCost.hpp>
#include <harmos/scene/detail/CostModel.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

std::string list(const std::string& name, const std::string& entries) {
  return "<ParameterList name=\"" + name + "\">" + entries + "</ParameterList>";
}

std::string law(const std::string& type, const std::string& entries) {
  return list("Law", parameter("Type", "string", type) + entries);
}

std::string friction() {
  return law("Coulomb Friction", parameter("Friction Coefficient", "double", "0.3"));
}

/// With the scene, which the problem may refer to.
struct Heap {
  Scene scene;
  Problem problem;
};

/// Squares in the plane, so many side by side and on each other, joined by one law; the lowest are held, the highest
/// pressed in two steps, the second time harder.
Heap heap(int columns, int rows, const std::string& joint = friction()) {
  const auto nameOf = [](int i, int j) { return "b" + std::to_string(i) + "_" + std::to_string(j); };
  const auto pair = [](int a, int b) { return "{" + std::to_string(a) + ", " + std::to_string(b) + "}"; };
  std::string boxes, parts, boundaries;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      boxes += list(nameOf(i, j), parameter("Lower Corner", "Array(double)", pair(i, j)) +
                                      parameter("Upper Corner", "Array(double)", pair(i + 1, j + 1)) +
                                      parameter("Cells", "Array(double)", "{2, 2}"));
      parts += list(nameOf(i, j), parameter("Material", "string", "steel"));
    }
    boundaries +=
        list("held " + std::to_string(i),
             parameter("Side Set", "string", nameOf(i, 0) + "_ymin") +
                 law("Prescribed Displacement", parameter("X", "double", "0") + parameter("Y", "double", "0")));
    boundaries += list(
        "pressed " + std::to_string(i),
        parameter("Side Set", "string", nameOf(i, rows - 1) + "_ymax") +
            law("Pressure", parameter("Pressure", "double", "1") + parameter("Pressure History", "string", "ramp")));
  }
  const std::string all = parameter("Part 1", "string", "*") + parameter("Part 2", "string", "*");
  const std::string text =
      list("Harmos",
           list("Mesh", parameter("Type", "string", "Boxes") + list("Boxes", boxes)) +
               list("Materials", list("steel", parameter("Type", "string", "Isotropic") +
                                                   parameter("Young's Modulus", "double", "1000") +
                                                   parameter("Poisson's Ratio", "double", "0"))) +
               list("Parts", parts) + list("Interfaces", list("joint", all + joint)) + list("Boundaries", boundaries) +
               list("Steps", list("press", parameter("Increments", "int", "2"))) +
               list("Histories", list("ramp", parameter("Type", "string", "Ramp") + parameter("End", "double", "1"))) +
               list("Responses", list("force", parameter("Type", "string", "Interface Force") +
                                                   parameter("Interface", "string", "held 0") +
                                                   parameter("Direction", "Array(double)", "{0, 1}"))));
  base::Timers timers;
  Scene scene = makeScene(input::InputTree::fromText(text, "heap.xml"), "heap.xml", {}, laws::builtInLaws());
  Problem problem = makeProblem(scene, *Tpetra::getDefaultComm(), timers);
  return {std::move(scene), std::move(problem)};
}

JointGraph graphOf(const Heap& heap) {
  const Problem& problem = heap.problem;
  std::vector<std::string> parts;
  for (const auto& body : problem.assembly.bodies) parts.push_back(body.partName());
  return jointGraphOf(problem.assembly.interfaces, parts, problem.assembly.dimension);
}

CostEstimate costOf(const Heap& heap) {
  return estimateCost(heap.problem, latin::LatinOptions(), FactorSizes::fromOrder, *Tpetra::getDefaultComm());
}

TEST(JointGraph, IsAsHighAsBodiesInLoopsAre) {
  EXPECT_EQ(graphOf(heap(1, 4)).height, 1.0);  // a stack
  EXPECT_EQ(graphOf(heap(4, 1)).height, 1.0);  // a row
  EXPECT_EQ(graphOf(heap(2, 2)).height, 2.0);
  EXPECT_EQ(graphOf(heap(2, 4)).height, 4.0);
}

TEST(JointGraph, CountsWhatIsGluedAsOne) {
  EXPECT_EQ(graphOf(heap(2, 3, law("Perfect", ""))).height, 1.0);
}

TEST(JointGraph, KnowsWherePairsMeet) {
  EXPECT_EQ(graphOf(heap(1, 2)).sharedNodes, 0.0);
  EXPECT_EQ(graphOf(heap(2, 2, law("Perfect", ""))).sharedNodes, 0.0);
  EXPECT_EQ(graphOf(heap(2, 2, law("Unilateral Contact", ""))).sharedNodes, 0.0);
  // Where the four meet, and below, where both ends of a pair are held.
  EXPECT_EQ(graphOf(heap(2, 2)).sharedNodes, 2.0);
}

// Three nodes on every edge, two cells apart of three.
TEST(JointGraph, CountsPointsAlongInterfaces) {
  EXPECT_NEAR(graphOf(heap(1, 2)).points, 4.0, 1e-12);
}

// Two rays of friction at each of three pairs of four joints, two components at each of three nodes of two boundaries,
// and what is left over of three resultants of four bodies, of either sign; both load steps have the same loads but for
// a factor.
TEST(StaticsSize, CountsWhatLinearProgrammesHave) {
  const Heap four = heap(2, 2);
  const StaticsSize size = staticsOf(four.problem.assembly, *Tpetra::getDefaultComm());
  EXPECT_EQ(size.rows, 4.0 * 3.0);
  EXPECT_EQ(size.joints, 4.0 * 3.0 + 2.0 * 3.0);
  EXPECT_EQ(size.columns, 2.0 * 12.0 + 2.0 * 6.0 + 2.0 * 12.0);
  EXPECT_EQ(size.programmes, 1.0);
}

TEST(StaticsSize, GrowsFasterThanItsJoints) {
  const auto comm = Tpetra::getDefaultComm();
  const StaticsSize small = staticsOf(heap(2, 4).problem.assembly, *comm),
                    large = staticsOf(heap(8, 16).problem.assembly, *comm);
  EXPECT_GT(large.seconds(1.0) / small.seconds(1.0), large.joints / small.joints);
}

TEST(CostEstimate, CountsStaticsStagesAndDirectionsOfHeaps) {
  const CostEstimate stack = costOf(heap(1, 4)), heaped = costOf(heap(4, 4));
  EXPECT_GT(stack.staticsSeconds, 0.0);
  EXPECT_GT(heaped.stages, 3.0 * stack.stages);
  const double perUnknown = static_cast<double>(stack.fieldBytes) / static_cast<double>(stack.interfaceUnknowns);
  EXPECT_GT(heaped.fieldBytes / static_cast<double>(heaped.interfaceUnknowns), 2.0 * perUnknown);
  EXPECT_GT(heaped.correctionSeconds, 16.0 * stack.correctionSeconds);
}

// A rough estimate is made in every run, which asks statics itself.
TEST(CostEstimate, AsksNoStaticsForARoughOne) {
  const Heap stack = heap(1, 4);
  EXPECT_EQ(estimateCost(stack.problem, latin::LatinOptions(), FactorSizes::fromUnknowns, *Tpetra::getDefaultComm())
                .staticsSeconds,
            0.0);
}

}  // namespace
}  // namespace harmos::scene
