#include <cmath>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/latin/BodyOperators.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"
#include "Traces.hpp"

namespace harmos::latin {
namespace {

constexpr int steps = 2;

/// Where a second wedge stands that equals the first.
using Motion = std::function<base::Vector3(const base::Vector3&)>;

base::Vector3 wedge(const base::Vector3& x) {
  return {x[0], x[1] * (1.0 + 0.3 * x[0]), x[2] * (1.0 + 0.2 * x[0])};
}
base::Vector3 translated(const base::Vector3& x) {
  const base::Vector3 y = wedge(x);
  return {y[0] + 5.0, y[1], y[2] - 1.0};
}
base::Vector3 rotated(const base::Vector3& x) {
  const base::Vector3 y = wedge(x);
  return {5.0 + 0.6 * y[0] - 0.8 * y[1], 0.8 * y[0] + 0.6 * y[1], y[2]};
}
base::Vector3 mirrored(const base::Vector3& x) {
  const base::Vector3 y = wedge({1.0 - x[0], x[1], x[2]});
  return {5.0 - y[0], y[1], y[2]};
}

/// Two wedges, both clamped at the lower face and held by a contact at a side; loaded by pressure and forces.
BoxAssembly wedges(const Motion& motion, bool isShared, bool isConsistent = false) {
  BoxAssembly boxes({{"a", {0, 0, 0}, {1, 1, 1}, {2, 1, 2}}, {"b", {0, 0, 0}, {1, 1, 1}, {2, 1, 2}}}, steps);
  boxes.deform("a", wedge);
  boxes.deform("b", motion);
  for (const std::string box : {"a", "b"}) {
    boxes.hold(box + " bottom", box + "_zmin", clamp(), isConsistent);
    boxes.hold(box + " side", box + "_ymax", laws::makeLaw("Unilateral Contact"), isConsistent);
    boxes.hold(box + " top", box + "_zmax", laws::makeLaw("Pressure", {{"Pressure", 3.0}}, {{"Pressure", {1, 2}}}));
  }
  boxes.assembly().bodies[1].loads.shape(3 * static_cast<int>(boxes.assembly().bodies[1].nodes.size()), steps);
  randomize(boxes.assembly().bodies[1].loads, 5);
  if (isShared) boxes.share(0, 1);
  return boxes;
}

struct Operators {
  explicit Operators(const assembly::Assembly& given)
      : assembly(given),
        k(assembly, 1.0, *self()),
        eliminated(assembly, k, Elimination::affine, resistedInPlane(assembly, *self())),
        layout(assembly, k, eliminated, self()),
        bodies(assembly, k, layout, eliminated, {}, timers) {
    bodies.select(allSteps(steps));
  }
  assembly::Assembly assembly;
  base::Timers timers;
  assembly::SearchDirection k;
  EliminatedBoundaries eliminated;
  TraceLayout layout;
  BodyOperators bodies;
};

TEST(BodyOperators, OfEqualBodiesAreOne) {
  for (const Motion motion : {translated, rotated, mirrored}) {
    for (bool isConsistent : {false, true}) {
      Operators own(wedges(motion, false, isConsistent).assembly());
      Operators shared(wedges(motion, true, isConsistent).assembly());
      EXPECT_EQ(own.bodies.operators(), 2);
      EXPECT_EQ(shared.bodies.operators(), 1);

      base::Matrix forces(own.layout.rows(), steps);
      randomize(forces);
      own.bodies.solve(forces, 0, steps, substructure::Precision::exact);
      shared.bodies.solve(forces, 0, steps, substructure::Precision::exact);
      base::Matrix trace(own.layout.rows(), steps), sharedTrace(own.layout.rows(), steps);
      own.bodies.trace(trace, 0, steps);
      shared.bodies.trace(sharedTrace, 0, steps);
      // Equal up to round-off times the condition number.
      const double tolerance = 1e-11 * trace.normInf();
      for (int t = 0; t < steps; ++t) {
        for (int row = 0; row < trace.numRows(); ++row) EXPECT_NEAR(trace(row, t), sharedTrace(row, t), tolerance);
        for (int node = 0; node < static_cast<int>(own.assembly.bodies[1].nodes.size()); ++node) {
          for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(own.bodies.displacement(1, node, t)[c], shared.bodies.displacement(1, node, t)[c], tolerance);
          }
        }
      }

      base::Matrix right(own.bodies.loads(1).numRows(), 3);
      randomize(right, 3);
      const base::Matrix x = own.bodies.solveBody(1, right), y = shared.bodies.solveBody(1, right);
      for (int j = 0; j < 3; ++j) {
        for (int dof = 0; dof < x.numRows(); ++dof) EXPECT_NEAR(x(dof, j), y(dof, j), 1e-11 * x.normInf());
      }
    }
  }
}

// B is carried along with the nodes: rotated bodies whose sides feel means of nodes.
TEST(BodyOperators, OfEqualBodiesWithEqualTraceOperatorsAreOne) {
  for (const Motion motion : {translated, rotated, mirrored}) {
    const auto smooth = [&](bool isShared, bool isBothSides) {
      BoxAssembly boxes = wedges(motion, isShared);
      std::vector<assembly::Interface>& interfaces = boxes.assembly().interfaces;
      interfaces[1].trace1 = smoothed(interfaces[1].trace1);
      if (isBothSides) interfaces[4].trace1 = smoothed(interfaces[4].trace1);
      return Operators(boxes.assembly());
    };
    EXPECT_EQ(smooth(true, false).bodies.operators(), 2);
    Operators own = smooth(false, true), shared = smooth(true, true);
    EXPECT_EQ(shared.bodies.operators(), 1);
    base::Matrix forces(own.layout.rows(), steps), trace(forces), sharedTrace(forces);
    randomize(forces);
    own.bodies.solve(forces, 0, steps, substructure::Precision::exact);
    shared.bodies.solve(forces, 0, steps, substructure::Precision::exact);
    own.bodies.trace(trace, 0, steps);
    shared.bodies.trace(sharedTrace, 0, steps);
    for (int t = 0; t < steps; ++t) {
      for (int row = 0; row < trace.numRows(); ++row)
        EXPECT_NEAR(trace(row, t), sharedTrace(row, t), 1e-11 * trace.normInf());
    }
  }
}

// Equal matrices do not help when the interfaces around the bodies differ.
TEST(BodyOperators, OfBodiesWithOtherInterfacesAreTwo) {
  BoxAssembly boxes = wedges(rotated, true);
  boxes.assembly().interfaces.erase(boxes.assembly().interfaces.begin() + 4);  // the side of b
  EXPECT_EQ(Operators(boxes.assembly()).bodies.operators(), 2);
}

TEST(BodyOperators, SolveAPartOfTheColumns) {
  Operators all(wedges(rotated, true).assembly());
  base::Matrix forces(all.layout.rows(), steps), trace(all.layout.rows(), steps), parts(all.layout.rows(), steps);
  randomize(forces);
  all.bodies.solve(forces, 0, steps, substructure::Precision::exact);
  all.bodies.trace(trace, 0, steps);
  for (int t = 0; t < steps; ++t) {
    all.bodies.solve(forces, t, 1, substructure::Precision::exact);
    all.bodies.trace(parts, t, 1);
  }
  for (int t = 0; t < steps; ++t) {
    for (int row = 0; row < trace.numRows(); ++row) EXPECT_NEAR(trace(row, t), parts(row, t), 1e-13 * trace.normInf());
  }
}

// A pressure p on an area A pushes with p A, half of it at each load step asked for.
TEST(BodyOperators, TurnPrescribedTractionsIntoLoads) {
  assembly::Assembly assembly = wedges(translated, false).assembly();
  const Operators operators(assembly);
  double force = 0.0, area = 0.0;
  for (double a : assembly.interfaces[2].area) area += a;
  for (int dof = 0; dof < operators.bodies.loads(0).numRows(); ++dof) {
    const double value = operators.bodies.loads(0)(dof, 1);
    force += value * value;
  }
  EXPECT_GT(force, 0.0);
  base::Vector3 sum{};
  for (int dof = 0; dof < operators.bodies.loads(0).numRows(); ++dof) sum[dof % 3] += operators.bodies.loads(0)(dof, 1);
  EXPECT_NEAR(std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]), 6.0 * area, 1e-9 * area);
}

TEST(BodyOperators, NameABodyThatNothingHolds) {
  assembly::Assembly assembly = twoChains(laws::makeLaw("Perfect"), laws::makeLaw("Prescribed Traction", {{"X", 1.0}}));
  assembly.interfaces.erase(assembly.interfaces.begin() + 1);
  assembly.times = {1.0, 2.0};
  try {
    const Operators operators(assembly);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("\"right\""), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace harmos::latin
