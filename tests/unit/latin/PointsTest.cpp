// Interfaces whose points are no nodes: what a point feels is a weighted mean of several nodes of a side.
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/NodalForces.hpp>
#include <harmos/latin/PairFields.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"
#include "Traces.hpp"

namespace harmos::latin {
namespace {

constexpr int steps = 2;
// Matrices have a condition of 1e4; relative to the largest value.
constexpr double roundOff = 1e-11;
constexpr double young = 1000.0, poisson = 0.3;  // of BoxAssembly

/// Two cubes in contact, moved and held by boundaries of all kinds that meet at edges.
assembly::Assembly heldCubes(bool isConsistent) {
  BoxAssembly cubes({{"lower", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {"upper", {0, 0, 1}, {1, 1, 2}, {2, 2, 2}}}, steps);
  cubes.hold("bottom", "lower_zmin",
             laws::makeLaw("Prescribed Displacement", {{"X", 0.02}, {"Z", 0.01}}, {{"X", {1, 2}}, {"Z", {1, -1}}}),
             isConsistent);
  cubes.hold("side", "lower_ymin", laws::makeLaw("Prescribed Displacement", {{"Y", 0.03}}), isConsistent);
  cubes.join("joint", "lower_zmax", "upper_zmin", laws::makeLaw("Unilateral Contact"), isConsistent);
  cubes.hold("spring", "upper_xmin",
             laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", 200.0}, {"Tangential Stiffness", 30.0}}),
             isConsistent);
  cubes.hold("top", "upper_zmax", laws::makeLaw("Pressure", {{"Pressure", 20.0}}), isConsistent);
  return cubes.assembly();
}

void unselect(assembly::Interface& interface) {
  interface.trace1 = unselected(interface.trace1);
  if (interface.sides() == 2) interface.trace2 = unselected(interface.trace2);
}

struct Applied {
  Applied(assembly::Assembly given, Elimination elimination) : assembly(std::move(given)) {
    StageOptions options;
    options.elimination = elimination;
    fixedPoint = std::make_unique<FixedPoint>(assembly, options, self(), timers);
    base::Matrix alpha(fixedPoint->layout().rows(), steps);
    image.shape(alpha.numRows(), steps);
    randomize(alpha);
    iterate = &fixedPoint->apply(alpha, image);
  }
  assembly::Assembly assembly;
  base::Timers timers;
  std::unique_ptr<FixedPoint> fixedPoint;
  base::Matrix image;
  const Iterate* iterate = nullptr;
};

void expectEqual(const base::Matrix& a, const base::Matrix& b) {
  ASSERT_EQ(a.numRows(), b.numRows());
  ASSERT_EQ(a.numCols(), b.numCols());
  for (int j = 0; j < a.numCols(); ++j) {
    for (int row = 0; row < a.numRows(); ++row) ASSERT_NEAR(a(row, j), b(row, j), roundOff * a.normInf()) << row;
  }
}

void expectEqualBodies(const Applied& a, const Applied& b) {
  for (int body = 0; body < 2; ++body) {
    for (int node = 0; node < static_cast<int>(a.assembly.bodies[body].nodes.size()); ++node) {
      for (int t = 0; t < steps; ++t) {
        const base::Vector3 u = a.iterate->displacement(body, node, t), v = b.iterate->displacement(body, node, t);
        ASSERT_LT(base::distance(u, v), roundOff * a.iterate->largestDisplacement(1.0)) << body << " " << node;
      }
    }
  }
}

TEST(Points, ThatAreNodesAreIteratedAlikeOnBothPaths) {
  for (const bool isConsistent : {false, true}) {
    for (const Elimination elimination : {Elimination::affine, Elimination::none}) {
      const Applied selected(heldCubes(isConsistent), elimination);
      assembly::Assembly general = heldCubes(isConsistent);
      for (assembly::Interface& interface : general.interfaces) {
        // Where boundaries are eliminated, they must stay on nodes.
        if (interface.sides() == 2 || interface.law->prescribesTraction() || elimination == Elimination::none) {
          unselect(interface);
          EXPECT_FALSE(interface.trace1.isSelection());
        }
      }
      const Applied mixed(std::move(general), elimination);
      expectEqual(selected.image, mixed.image);
      expectEqual(selected.iterate->traction(), mixed.iterate->traction());
      expectEqualBodies(selected, mixed);
      const BoundaryFields &a = selected.iterate->boundaryFields(), &b = mixed.iterate->boundaryFields();
      EXPECT_EQ(a.interfaces.size(), elimination == Elimination::affine && !isConsistent ? 3u : 0u);
      expectEqual(a.traction, b.traction);
      expectEqual(a.trace, b.trace);
    }
  }
}

TEST(Points, ThatAreNoNodesAreNotEliminated) {
  assembly::Assembly assembly = heldCubes(false);
  unselect(assembly.interfaces[1]);
  const assembly::SearchDirection k(assembly, 1.0, *self());
  const EliminatedBoundaries eliminated(assembly, k, Elimination::affine, resistedInPlane(assembly, *self()));
  EXPECT_TRUE(eliminated.contains(0));
  EXPECT_FALSE(eliminated.contains(1));
  EXPECT_TRUE(eliminated.contains(3));
}

// F_j = sum of B_pj h_p f_p is all that a body feels.
TEST(Points, ActOnNodesByTheTransposedOperator) {
  assembly::Assembly assembly = twoChains(laws::makeLaw("Unilateral Contact"), clamp());
  assembly.interfaces[1].area = {2.0};
  assembly.interfaces[1].trace1 = {};
  assembly.interfaces[1].trace1.append({{3, 1.25}, {2, -0.25}});
  const assembly::SearchDirection k(assembly, 1.0, *self());
  const EliminatedBoundaries eliminated(assembly, k, Elimination::affine, resistedInPlane(assembly, *self()));
  const TraceLayout layout(assembly, k, eliminated, self());
  ASSERT_EQ(layout.nodes(), 5);  // one at both ends, and those of the joint
  base::Matrix traction(layout.rows(), 1);
  traction(layout.begin(1, 0), 0) = 3.0;
  const base::Matrix forces = nodalForces(layout, traction);
  ASSERT_EQ(forces.numRows(), 15);
  EXPECT_NEAR(forces(3, 0), 1.25 * 2.0 * 3.0 / std::sqrt(1.25 * 2.0), 1e-14);
  EXPECT_NEAR(forces(6, 0), -0.25 * 2.0 * 3.0 / std::sqrt(0.25 * 2.0), 1e-14);
}

struct Solved {
  explicit Solved(assembly::Assembly given, double accuracy = 1e-10, Elimination elimination = Elimination::affine)
      : assembly(std::move(given)) {
    LatinOptions options;
    options.accuracy = accuracy;
    options.stages.elimination = elimination;
    solver = std::make_unique<LatinSolver>(assembly, options, self(), timers);
    result = solver->solve();
  }
  assembly::Assembly assembly;
  base::Timers timers;
  std::unique_ptr<LatinSolver> solver;
  LatinResult result;
};

TEST(Points, ThatAreNodesLeadToTheSameAnswerOnBothPaths) {
  assembly::Assembly general = heldCubes(false);
  for (assembly::Interface& interface : general.interfaces) unselect(interface);
  const Solved selected(heldCubes(false)), mixed(std::move(general));
  ASSERT_EQ(selected.result.outcome, Outcome::certified) << selected.result.reason;
  ASSERT_EQ(mixed.result.outcome, Outcome::certified) << mixed.result.reason;
  for (int body = 0; body < 2; ++body) {
    for (int node = 0; node < static_cast<int>(selected.assembly.bodies[body].nodes.size()); ++node) {
      for (int t = 0; t < steps; ++t) {
        const base::Vector3 u = selected.solver->state().displacement(body, node, t);
        EXPECT_LT(base::distance(u, mixed.solver->state().displacement(body, node, t)), 1e-9);
      }
    }
  }
}

// What a boundary holds at the edge of such an interface pulls at all nodes that a point feels.
TEST(Points, StandBesideEliminatedBoundaries) {
  assembly::Assembly assembly = heldCubes(false);
  assembly::Interface& joint = assembly.interfaces[2];
  joint.trace1 = smoothed(joint.trace1);
  joint.trace2 = smoothed(joint.trace2);
  const Solved with(assembly), without(assembly, 1e-10, Elimination::none);
  ASSERT_EQ(with.result.outcome, Outcome::certified) << with.result.reason;
  ASSERT_EQ(without.result.outcome, Outcome::certified) << without.result.reason;
  EXPECT_TRUE(with.solver->fixedPoint().eliminated().contains(1));
  for (int t = 0; t < steps; ++t) {
    for (int body = 0; body < 2; ++body) {
      for (int node = 0; node < static_cast<int>(assembly.bodies[body].nodes.size()); ++node) {
        const base::Vector3 u = with.solver->state().displacement(body, node, t);
        EXPECT_LT(base::distance(u, without.solver->state().displacement(body, node, t)), 1e-9);
      }
    }
    base::Vector3 onLower{};
    for (const int i : {0, 1, 2}) {
      const std::vector<base::Vector3> f = with.solver->state().tractions(i, t);
      for (std::size_t p = 0; p < f.size(); ++p) onLower = onLower + assembly.interfaces[i].area[p] * f[p];
    }
    EXPECT_LT(base::norm(onLower), 1e-8);
  }
}

/// A strip of two blocks, [0, 2] x [0, 1] of 8 x 3 and [0, 2] x [1, 2] of 4 x 2 elements, that slides freely on the
/// ground and along the axis. On the common line lie 9 nodes of the lower and 5 of the upper block.
BoxAssembly strip(const std::shared_ptr<const laws::InterfaceLaw>& top) {
  BoxAssembly boxes({{"lower", {0, 0}, {2, 1}, {8, 3}, mesh::ElementType::quad4},
                     {"upper", {0, 1}, {2, 2}, {4, 2}, mesh::ElementType::quad4}});
  boxes.hold("bottom", "lower_ymin", laws::makeLaw("Symmetry"));
  boxes.hold("lower axis", "lower_xmin", laws::makeLaw("Symmetry"));
  boxes.hold("upper axis", "upper_xmin", laws::makeLaw("Symmetry"));
  boxes.hold("top", "upper_ymax", top);
  return boxes;
}

int nodeAt(const substructure::Substructure& body, double x, double y) {
  for (std::size_t node = 0; node < body.nodes.size(); ++node) {
    if (base::distance(body.nodes[node], {x, y, 0.0}) < 1e-12) return static_cast<int>(node);
  }
  ADD_FAILURE() << "no node at " << x << ", " << y;
  return -1;
}

/// The joint of the strip with its points on the nodes of one side. With the dual basis psi of that side,
/// B = (1/h) int psi N with N of the other side, by hand: from the finer side the other one is interpolated; from the
/// coarser side, an element of the length l gives its ends l (3/8, 1/4, -1/8) of the three nodes opposite.
assembly::Interface nonMatching(const assembly::Assembly& strip, const std::shared_ptr<const laws::InterfaceLaw>& law,
                                bool isOnFiner) {
  const auto lower = [&](int i) { return nodeAt(strip.bodies[0], 0.25 * i, 1.0); };
  const auto upper = [&](int i) { return nodeAt(strip.bodies[1], 0.5 * i, 1.0); };
  assembly::Interface joint;
  joint.name = "joint";
  joint.law = law;
  joint.body1 = 0;
  joint.body2 = 1;
  const int last = isOnFiner ? 8 : 4;
  const double length = 2.0 / last;
  for (int i = 0; i <= last; ++i) {
    const bool isEnd = i == 0 || i == last;
    joint.position.push_back({length * i, 1.0, 0.0});
    joint.area.push_back(isEnd ? 0.5 * length : length);
    joint.gap.push_back(0.0);
    joint.frame.push_back({{{0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}});
    if (isOnFiner) {
      joint.trace1.append({{lower(i), 1.0}});
      if (i % 2 == 0) {
        joint.trace2.append({{upper(i / 2), 1.0}});
      } else {
        joint.trace2.append({{upper(i / 2), 0.5}, {upper(i / 2 + 1), 0.5}});
      }
      continue;
    }
    joint.trace2.append({{upper(i), 1.0}});
    if (isEnd) {
      const int inwards = i == 0 ? 1 : -1;
      joint.trace1.append({{lower(2 * i), 0.75}, {lower(2 * i + inwards), 0.5}, {lower(2 * i + 2 * inwards), -0.25}});
    } else {
      joint.trace1.append({{lower(2 * i - 2), -0.125},
                           {lower(2 * i - 1), 0.25},
                           {lower(2 * i), 0.75},
                           {lower(2 * i + 1), 0.25},
                           {lower(2 * i + 2), -0.125}});
    }
  }
  return joint;
}

// A uniform pressure gives a uniform stress, whatever the meshes are: plane strain.
TEST(Points, BetweenMeshesThatDoNotMatchPassThePatchTest) {
  const double pressure = 10.0;
  const double along = -pressure * (1.0 - poisson * poisson) / young,
               across = pressure * poisson * (1.0 + poisson) / young;
  for (const bool isOnFiner : {true, false}) {
    for (const char* law : {"Perfect", "Unilateral Contact"}) {
      BoxAssembly boxes = strip(laws::makeLaw("Pressure", {{"Pressure", pressure}}));
      boxes.assembly().interfaces.push_back(nonMatching(boxes.assembly(), laws::makeLaw(law), isOnFiner));
      const Solved solved(boxes.assembly());
      ASSERT_EQ(solved.result.outcome, Outcome::certified) << solved.result.reason;
      for (int body = 0; body < 2; ++body) {
        const auto& nodes = solved.assembly.bodies[body].nodes;
        for (std::size_t node = 0; node < nodes.size(); ++node) {
          const base::Vector3 u = solved.solver->state().displacement(body, static_cast<int>(node), 0);
          EXPECT_NEAR(u[0], across * nodes[node][0], 1e-9 * 0.02) << law << isOnFiner;
          EXPECT_NEAR(u[1], along * nodes[node][1], 1e-9 * 0.02) << law << isOnFiner;
        }
      }
      const PairFields fields = pairFields(solved.solver->state(), 4);
      for (const base::Vector3& t : fields.traction) EXPECT_LT(base::distance(t, {-pressure, 0.0, 0.0}), 1e-8);
      for (const base::Vector3& jump : fields.jump) EXPECT_LT(base::norm(jump), 1e-9 * 0.02);
    }
  }
}

// The rigid motions of the interface, too, are those of both sides.
TEST(Points, BetweenMeshesThatDoNotMatchAreKnownNotToHoldWhatIsPulledOff) {
  for (const bool isOnFiner : {true, false}) {
    BoxAssembly boxes = strip(laws::makeLaw("Pressure", {{"Pressure", -10.0}}));
    boxes.assembly().interfaces.push_back(
        nonMatching(boxes.assembly(), laws::makeLaw("Unilateral Contact"), isOnFiner));
    const Solved solved(boxes.assembly(), 1e-3);
    EXPECT_EQ(solved.result.outcome, Outcome::noEquilibrium) << solved.result.reason;
  }
}

double mean(const Solved& solved, int body, const mesh::TraceOperator& trace) {
  double w = 0.0;
  for (const auto& [node, weight] : trace.row(0)) w += weight * solved.solver->state().displacement(body, node, 0)[2];
  return w;
}

/// Two cubes with one point between the means of their faces, of the area 1. The upper one is guided along z.
assembly::Assembly joinedInTheMean(const std::shared_ptr<const laws::InterfaceLaw>& law, bool isGuided = true) {
  BoxAssembly cubes = twoCubes(law, laws::makeLaw("Pressure", {{"Pressure", 6.0}}));
  if (isGuided) {
    cubes.hold("x", "upper_xmin", laws::makeLaw("Symmetry"));
    cubes.hold("y", "upper_ymin", laws::makeLaw("Symmetry"));
  }
  assembly::Interface& joint = cubes.assembly().interfaces[1];
  const double area = std::accumulate(joint.area.begin(), joint.area.end(), 0.0);
  joint.trace1 = meanOf(joint.trace1, joint.area);
  joint.trace2 = meanOf(joint.trace2, joint.area);
  joint.position = {{0.5, 0.5, 1.0}};
  joint.frame.resize(1);
  joint.gap = {0.0};
  joint.area = {area};
  return cubes.assembly();
}

TEST(Points, OfMeanMotionsAreSprings) {
  const double stiffness = 50.0;
  const Solved solved(joinedInTheMean(
      laws::makeLaw("Linear Elastic", {{"Normal Stiffness", stiffness}, {"Tangential Stiffness", 20.0}})));
  ASSERT_EQ(solved.result.outcome, Outcome::certified) << solved.result.reason;
  const assembly::Interface& joint = solved.assembly.interfaces[1];
  const double jump = mean(solved, 1, joint.trace2) - mean(solved, 0, joint.trace1);
  EXPECT_NEAR(jump, -6.0 / stiffness, 1e-9);
  const PairFields fields = pairFields(solved.solver->state(), 1);
  ASSERT_EQ(fields.pairs, 1);
  EXPECT_NEAR(fields.traction[0][0], -6.0, 1e-8);
  EXPECT_NEAR(fields.jump[0][0], jump, 1e-9);
  // The faces themselves warp: only their means are joined.
  const auto u = [&](int body, double x) {
    const auto& nodes = solved.assembly.bodies[body].nodes;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      if (base::distance(nodes[node], {x, x, 1.0}) < 1e-12)
        return solved.solver->state().displacement(body, static_cast<int>(node), 0)[2];
    }
    return 0.0;
  };
  EXPECT_GT(std::abs(u(0, 0.0) - u(0, 0.5)), 1e-5);
}

// A mean turns freely, and a part on it, however much the law bonds.
TEST(Points, OfMeanMotionsHoldNoRotation) {
  EXPECT_THROW(Solved(joinedInTheMean(laws::makeLaw("Perfect"), false)), base::Error);
}

TEST(Points, OfMeanMotionsCanBePrescribed) {
  BoxAssembly cube({{"cube", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}});
  cube.hold("x", "cube_xmin", laws::makeLaw("Symmetry"));
  cube.hold("y", "cube_ymin", laws::makeLaw("Symmetry"));
  cube.hold("bottom", "cube_zmin", laws::makeLaw("Symmetry"));
  cube.hold("top", "cube_zmax", laws::makeLaw("Prescribed Displacement", {{"Z", -0.01}}));
  assembly::Interface& top = cube.assembly().interfaces[3];
  top.trace1 = meanOf(top.trace1, top.area);
  top.area = {1.0};
  top.position = {{0.5, 0.5, 1.0}};
  top.frame.resize(1);
  top.gap = {0.0};
  const Solved solved(cube.assembly());
  ASSERT_EQ(solved.result.outcome, Outcome::certified) << solved.result.reason;
  EXPECT_NEAR(mean(solved, 0, solved.assembly.interfaces[3].trace1), -0.01, 1e-11);
  // The sum of the nodal forces of a uniform traction: B is the mean by area, so that the cube stays uniform.
  const PairFields fields = pairFields(solved.solver->state(), 3);
  EXPECT_NEAR(fields.traction[0][0], -0.01 * young, 1e-7);
}

}  // namespace
}  // namespace harmos::latin
