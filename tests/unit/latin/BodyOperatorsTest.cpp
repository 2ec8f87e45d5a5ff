#include <cmath>
#include <numeric>

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
  explicit Operators(const assembly::Assembly& given, const substructure::SolverOptions& options = {})
      : assembly(given),
        k(assembly, 1.0, *self()),
        eliminated(assembly, k, Elimination::affine, resistedInPlane(assembly, *self())),
        layout(assembly, k, eliminated, self()),
        bodies(assembly, k, layout, eliminated, options, timers) {
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
      own.bodies.solve(forces, 0, substructure::Precision::exact);
      shared.bodies.solve(forces, 0, substructure::Precision::exact);
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
    own.bodies.solve(forces, 0, substructure::Precision::exact);
    shared.bodies.solve(forces, 0, substructure::Precision::exact);
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
  all.bodies.solve(forces, 0, substructure::Precision::exact);
  all.bodies.trace(trace, 0, steps);
  for (int t = 0; t < steps; ++t) {
    all.bodies.solve(base::Matrix(Teuchos::Copy, forces, forces.numRows(), 1, 0, t), t, substructure::Precision::exact);
    all.bodies.trace(parts, t, 1);
  }
  for (int t = 0; t < steps; ++t) {
    for (int row = 0; row < trace.numRows(); ++row) EXPECT_NEAR(trace(row, t), parts(row, t), 1e-13 * trace.normInf());
  }
}

// A pressure p on an area A pushes with p A, half of it at each load step asked for.
/// A slender bar, clamped at one end, pushed at the other by a displacement, and with a contact along its side.
BoxAssembly pushedBar(double push) {
  BoxAssembly boxes({{"bar", {0, 0, 0}, {4, 1, 1}, {8, 2, 2}}}, steps);
  boxes.hold("bar foot", "bar_xmin", clamp());
  boxes.hold("bar side", "bar_ymax", laws::makeLaw("Unilateral Contact"));
  boxes.hold("bar head", "bar_xmax", laws::makeLaw("Prescribed Displacement", {{"X", push}}, {{"X", {1, 2}}}));
  boxes.assembly().bodies[0].loads.shape(3 * static_cast<int>(boxes.assembly().bodies[0].nodes.size()), steps);
  randomize(boxes.assembly().bodies[0].loads, 5);
  return boxes;
}

// Of many load steps inner displacements are found for some at a time, in whatever order they are asked for, also where
// traces are inverted.
TEST(BodyOperators, FindInnerDisplacementsOfManyLoadStepsInParts) {
  constexpr int many = 150;
  BoxAssembly boxes({{"bar", {0, 0, 0}, {4, 1, 1}, {8, 2, 2}}}, many);
  std::vector<double> history(many, 1.0);
  for (int t = 0; t < many; ++t) history[t] = 1.0 + t % 7;
  boxes.hold("bar foot", "bar_xmin", clamp());
  boxes.hold("bar side", "bar_ymax", laws::makeLaw("Unilateral Contact"));
  boxes.hold("bar head", "bar_xmax", laws::makeLaw("Prescribed Displacement", {{"X", 0.01}}, {{"X", history}}));
  const int nodes = static_cast<int>(boxes.assembly().bodies[0].nodes.size());
  boxes.assembly().bodies[0].loads.shape(3 * nodes, many);
  randomize(boxes.assembly().bodies[0].loads, 5);
  for (const bool inverts : {false, true}) {
    substructure::SolverOptions options;
    options.invertTrace = inverts;
    Operators all(boxes.assembly(), options), one(boxes.assembly());
    base::Matrix forces(all.layout.rows(), many);
    randomize(forces);
    std::vector<int> every(many);
    std::iota(every.begin(), every.end(), 0);
    all.bodies.select(every);
    all.bodies.solve(forces, 0, substructure::Precision::exact);
    const auto& held = all.eliminated.nodes(0);
    ASSERT_GT(held.size(), 0u);
    for (const int t : {149, 0, 64, 63, 100}) {
      one.bodies.select({t});
      one.bodies.solve(base::Matrix(Teuchos::Copy, forces, forces.numRows(), 1, 0, t), 0,
                       substructure::Precision::exact);
      double largest = 0.0;
      for (std::size_t n = 0; n < held.size(); ++n) {
        for (const double value : one.bodies.reaction(0, n, 0)) largest = std::max(largest, std::abs(value));
      }
      EXPECT_GT(largest, 0.0);
      for (std::size_t n = 0; n < held.size(); ++n) {
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(all.bodies.reaction(0, n, t)[c], one.bodies.reaction(0, n, 0)[c], 1e-11 * largest);
        }
      }
      for (int node = 0; node < nodes; ++node) {
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(all.bodies.displacement(0, node, t)[c], one.bodies.displacement(0, node, 0)[c], 1e-12);
        }
      }
    }
  }
}

// Reactions and displacements of held nodes are the same whether they are taken from the whole solution or, where
// traces are inverted, from what moves these nodes; also after other displacements were set, and with them given back.
TEST(BodyOperators, MoveHeldNodesWithoutASolveOfTheWhole) {
  substructure::SolverOptions inverting;
  inverting.invertTrace = true;
  Operators whole(pushedBar(0.01).assembly()), inverted(pushedBar(0.01).assembly(), inverting);
  base::Matrix forces(whole.layout.rows(), steps);
  randomize(forces);
  for (const double push : {0.01, 0.03, 0.03, 0.01}) {
    double largest = 0.0;
    for (Operators* one : {&whole, &inverted}) {
      one->assembly.interfaces[2].law = pushedBar(push).assembly().interfaces[2].law;
      one->eliminated.update();
      one->bodies.updateLoads(one->assembly);
      one->bodies.solve(forces, 0, substructure::Precision::exact);
    }
    const auto& held = whole.eliminated.nodes(0);
    ASSERT_GT(held.size(), 0u);
    for (int t = 0; t < steps; ++t) {
      for (std::size_t n = 0; n < held.size(); ++n) {
        const base::Vector3 r = whole.bodies.reaction(0, n, t);
        for (const double value : r) largest = std::max(largest, std::abs(value));
      }
    }
    EXPECT_GT(largest, 0.0);
    for (int t = 0; t < steps; ++t) {
      for (std::size_t n = 0; n < held.size(); ++n) {
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(inverted.bodies.reaction(0, n, t)[c], whole.bodies.reaction(0, n, t)[c], 1e-9 * largest);
          EXPECT_NEAR(inverted.bodies.displacement(0, held[n].node, t)[c],
                      whole.bodies.displacement(0, held[n].node, t)[c], 1e-12);
        }
      }
    }
  }
}

// Loads that are the same as before are not read again, unless others were in their place.
TEST(BodyOperators, HaveTheirOwnLoadsAfterOthers) {
  BoxAssembly boxes = wedges(translated, false);
  boxes.assembly().bodies[1].loads = base::Matrix();
  Operators one(boxes.assembly());
  const base::Matrix own = one.bodies.loads(0);
  EXPECT_GT(own.normInf(), 0.0);
  const long changes = one.bodies.loadChanges();
  one.bodies.updateLoads(one.assembly);
  EXPECT_EQ(one.bodies.loadChanges(), changes);

  std::vector<base::Matrix> others;
  for (const auto& body : one.assembly.bodies) others.emplace_back(3 * static_cast<int>(body.nodes.size()), steps);
  one.bodies.setLoads(others, std::vector<base::Matrix>(others.size()));
  EXPECT_EQ(one.bodies.loads(0).normInf(), 0.0);
  one.bodies.updateLoads(one.assembly);
  EXPECT_EQ(one.bodies.loads(0), own);

  const auto pressure = one.assembly.interfaces[2].law;
  one.assembly.interfaces[2].law = laws::makeLaw("Pressure", {{"Pressure", 6.0}}, {{"Pressure", {1, 2}}});
  one.bodies.updateLoads(one.assembly);
  EXPECT_NEAR(one.bodies.loads(0).normInf(), 2.0 * own.normInf(), 1e-12 * own.normInf());
  one.assembly.interfaces[2].law = pressure;
  one.bodies.updateLoads(one.assembly);
  EXPECT_EQ(one.bodies.loads(0), own);

  base::Matrix forces(one.layout.rows(), steps);
  randomize(forces);
  one.bodies.solve(forces, 0, substructure::Precision::exact);
  one.bodies.perturb(one.assembly, 1, 1.0);
  EXPECT_NE(one.bodies.loads(0), own);
  one.bodies.unperturb(one.assembly);
  EXPECT_EQ(one.bodies.loads(0), own);
}

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
