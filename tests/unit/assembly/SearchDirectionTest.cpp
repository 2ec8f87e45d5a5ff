#include <cmath>

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include <harmos/assembly/SearchDirection.hpp>
#include <harmos/base/Error.hpp>

#include "../latin/Chains.hpp"

namespace harmos::assembly {
namespace {

using latin::chain;
using latin::pointInterface;

constexpr double factor = SearchDirection::factor;

double k(const Assembly& assembly, int interfaceIndex, int pair = 0, double scale = 1.0) {
  return SearchDirection(assembly, scale, *Tpetra::getDefaultComm()).of(interfaceIndex)[pair];
}

Assembly twoBodies(double spring1, double spring2) {
  Assembly assembly;
  assembly.bodies = {chain("a", 0.0, 3, spring1), chain("b", 2.0, 3, spring2)};
  assembly.interfaces = {pointInterface("joint", laws::makeLaw("Unilateral Contact"), 0, 2, 1, 0, 0.5),
                         pointInterface("wall", latin::clamp(), 0, 0, -1, 0, 0.25)};
  assembly.times = {1.0};
  // Each rank owns a body, if there are so many ranks.
  if (Tpetra::getDefaultComm()->getSize() > 1) assembly.owner = {0, Tpetra::getDefaultComm()->getSize() - 1};
  return assembly;
}

TEST(SearchDirection, OfABoundaryIsItsOwnStiffnessPerArea) {
  // The end node of a chain has one spring.
  EXPECT_NEAR(k(twoBodies(30.0, 60.0), 1), factor * 30.0 / 0.25, 1e-12);
}

TEST(SearchDirection, OfAnInterfaceIsTheHarmonicMean) {
  EXPECT_NEAR(k(twoBodies(30.0, 60.0), 0), factor * 2.0 / (0.5 / 30.0 + 0.5 / 60.0), 1e-12);
  // The softer side decides.
  EXPECT_NEAR(k(twoBodies(30.0, 3e10), 0), factor * 2.0 * 30.0 / 0.5, 1e-6);
}

TEST(SearchDirection, OfABondIsThreeTimesStiffer) {
  Assembly bonded = twoBodies(30.0, 60.0);
  bonded.interfaces[0].law = laws::makeLaw("Perfect");
  EXPECT_NEAR(k(bonded, 0), 3.0 * k(twoBodies(30.0, 60.0), 0), 1e-12);
}

TEST(SearchDirection, OfAConsistentMassIsThreeTimesStifferInSpace) {
  for (const int dimension : {2, 3}) {
    Assembly joined = twoBodies(30.0, 60.0);
    joined.dimension = dimension;
    const double lumped = k(joined, 0);
    joined.interfaces[0].mass = {{0, 0, 0.5}};
    EXPECT_NEAR(k(joined, 0), (dimension == 3 ? 3.0 : 1.0) * lumped, 1e-12) << dimension;
  }
}

// A law that falls by 25 per length: lines of two sides with k are as steep at k = 2 x 25.
TEST(SearchDirection, StaysAboveTheSoftening) {
  Assembly glued = twoBodies(30.0, 60.0);
  glued.interfaces[0].law = latin::softGlue(25.0);
  const double least = SearchDirection::marginOfSoftening * 2.0 * 25.0;
  ASSERT_LT(k(twoBodies(30.0, 60.0), 0), least);
  for (const double scale : {1e-3, 1.0}) EXPECT_DOUBLE_EQ(k(glued, 0, 0, scale), least);
  EXPECT_DOUBLE_EQ(k(glued, 0, 0, 1e3), 1e3 * k(twoBodies(30.0, 60.0), 0));
  const SearchDirection direction(glued, 1.0, *Tpetra::getDefaultComm());
  EXPECT_EQ(direction.heldBySoftening(), std::vector<int>{0});
  EXPECT_DOUBLE_EQ(direction.of(1)[0], k(twoBodies(30.0, 60.0), 1));
}

TEST(SearchDirection, RefusesSofteningInWhichThePartsAreLost) {
  Assembly glued = twoBodies(30.0, 60.0);
  glued.interfaces[0].law = latin::softGlue(1e15);
  try {
    k(glued, 0);
    ADD_FAILURE() << "it was taken";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::notConverged);
    EXPECT_NE(std::string(error.what()).find("interface \"joint\": the law \"Cohesive Zone\" falls by "),
              std::string::npos)
        << error.what();
  }
}

TEST(SearchDirection, DoesNotDependOnTheOrderOfTheSides) {
  Assembly swapped = twoBodies(30.0, 60.0);
  std::swap(swapped.interfaces[0].body1, swapped.interfaces[0].body2);
  std::swap(swapped.interfaces[0].trace1, swapped.interfaces[0].trace2);
  EXPECT_DOUBLE_EQ(k(swapped, 0), k(twoBodies(30.0, 60.0), 0));
}

TEST(SearchDirection, IsTheMeanOverTheComponents) {
  Assembly assembly = twoBodies(30.0, 60.0);
  assembly.bodies[0].stiffness = substructure::makeCrsMatrix({0, 1, 2, 3}, {0, 1, 2}, {1.0, 2.0, 6.0});
  assembly.bodies[0].nodes.resize(1);
  assembly.interfaces.erase(assembly.interfaces.begin());  // the joint is at a node that is gone
  EXPECT_NEAR(k(assembly, 0), factor * 3.0 / 0.25, 1e-12);
}

TEST(SearchDirection, TakesTheScaleAsAFactor) {
  const Assembly assembly = twoBodies(30.0, 60.0);
  EXPECT_DOUBLE_EQ(k(assembly, 0, 0, 1e-6), 1e-6 * k(assembly, 0));
}

// k is a stress per length: in metres instead of millimetres a spring of 30 N/mm is one of 30000 N/m on 1e-6 times the
// area.
TEST(SearchDirection, HasItsUnit) {
  Assembly metres = twoBodies(30e3, 60e3);
  for (Interface& joint : metres.interfaces) joint.area[0] *= 1e-6;
  EXPECT_NEAR(k(metres, 0) / k(twoBodies(30.0, 60.0), 0), 1e9, 1e-3);
}

TEST(SearchDirection, OfEqualBodiesIsThatOfTheRepresentative) {
  Assembly assembly = twoBodies(30.0, 30.0);
  auto congruence = std::make_shared<substructure::Congruence>();
  congruence->representative = 0;
  congruence->node = {2, 1, 0};
  congruence->rotation = {{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  assembly.bodies[1].congruence = congruence;
  assembly.bodies[1].stiffness = Teuchos::null;
  EXPECT_DOUBLE_EQ(k(assembly, 0), k(twoBodies(30.0, 30.0), 0));
}

Assembly wideInterface(bool isConsistent) {
  Assembly assembly = twoBodies(30.0, 30.0);
  Interface& joint = assembly.interfaces[0];
  joint.trace1 = mesh::TraceOperator({1, 2});  // diagonals 60 and 30
  joint.trace2 = mesh::TraceOperator({1, 0});
  joint.position.push_back(joint.position[0]);
  joint.frame.push_back(joint.frame[0]);
  joint.area = {0.5, 1.5};
  joint.gap = {0.0, 0.0};
  if (isConsistent) joint.mass = {{0, 0, 0.5}, {1, 1, 1.5}};
  return assembly;
}

TEST(SearchDirection, VariesFromNodeToNode) {
  EXPECT_NEAR(k(wideInterface(false), 0, 0), factor * 60.0 / 0.5, 1e-12);
  EXPECT_NEAR(k(wideInterface(false), 0, 1), factor * 30.0 / 1.5, 1e-12);
}

TEST(SearchDirection, OfAMeanOfNodesIsThatOfItsCompliance) {
  Assembly assembly = wideInterface(false);
  mesh::TraceOperator& trace = assembly.interfaces[0].trace1;
  trace = {};
  trace.append({{1, 0.25}, {2, 0.75}});  // diagonals 60 and 30
  trace.append({{1, -0.5}, {2, 1.5}});
  const auto expected = [](double area, double compliance1, double stiffness2) {
    return factor * 2.0 / (area * compliance1 + area / stiffness2);
  };
  EXPECT_NEAR(k(assembly, 0, 0), expected(0.5, 0.0625 / 60.0 + 0.5625 / 30.0, 60.0), 1e-12);
  EXPECT_NEAR(k(assembly, 0, 1), expected(1.5, 0.25 / 60.0 + 2.25 / 30.0, 30.0), 1e-12);
}

TEST(SearchDirection, IsConstantWithConsistentMass) {
  const double first = k(wideInterface(false), 0, 0), second = k(wideInterface(false), 0, 1);
  const double mean = std::exp((0.5 * std::log(first) + 1.5 * std::log(second)) / 2.0);
  EXPECT_NEAR(k(wideInterface(true), 0, 0), 3.0 * mean, 1e-12);
  EXPECT_DOUBLE_EQ(k(wideInterface(true), 0, 0), k(wideInterface(true), 0, 1));
}

TEST(SearchDirection, NamesABodyWithoutStiffness) {
  try {
    k(twoBodies(30.0, 0.0), 0);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("\"b\""), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("\"joint\""), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace harmos::assembly
