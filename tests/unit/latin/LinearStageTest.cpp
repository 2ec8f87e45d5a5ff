#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include <harmos/latin/InterfaceMass.hpp>
#include <harmos/latin/LinearStage.hpp>
#include <harmos/substructure/SolverFactory.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"
#include "Displacements.hpp"

namespace harmos::latin {
namespace {

// Solves with matrices of condition 1e4 leave about 1e-12; the check is relative to the largest nodal force.
constexpr double roundOff = 1e-10;
constexpr int steps = 4;

struct Stage {
  explicit Stage(assembly::Assembly given, bool withMacroProblem = true,
                 Formulation formulation = Formulation::displacement, const substructure::SolverOptions& options = {})
      : assembly(std::move(given)),
        k(assembly, 1.0, *self()),
        eliminated(assembly, k, Elimination::none, {}),
        layout(assembly, k, eliminated, self()),
        linear(assembly, k, layout, eliminated, formulation, withMacroProblem, options, timers),
        alpha(layout.rows(), steps),
        beta(layout.rows(), steps) {
    linear.select(allSteps(steps));
    randomize(alpha);
    linear.solve(alpha, beta);
  }

  base::Matrix nodalForces(int body) const {
    base::Matrix forces = linear.operators().loads(body);
    for (const TraceLayout::Block& block : layout.blocks()) {
      if (block.body != body) continue;
      const assembly::Interface& joint = assembly.interfaces[block.interface];
      std::vector<double> force(3 * block.pairs);
      for (int t = 0; t < steps; ++t) {
        applyMass(joint, 3, linear.traction()[t] + block.begin, force.data());
        joint.trace(block.side).addTransposed(3, force.data(), forces[t]);
      }
    }
    return forces;
  }

  base::Matrix displacements(int body) const {
    return displacementsOf(linear, body, assembly.bodies[body].nodes.size());
  }

  assembly::Assembly assembly;
  base::Timers timers;
  assembly::SearchDirection k;
  EliminatedBoundaries eliminated;
  TraceLayout layout;
  LinearStage linear;
  base::Matrix alpha, beta;
};

/// Loaded by pressure, by forces of the bodies' own, and with interfaces of every kind.
assembly::Assembly loadedCubes(bool isConsistent = false) {
  BoxAssembly cubes =
      twoCubes(laws::makeLaw("Perfect"), laws::makeLaw("Pressure", {{"Pressure", 2.0}}, {{"Pressure", {1, 2, 3, 4}}}),
               steps, isConsistent);
  cubes.hold("side", "lower_xmin", laws::makeLaw("Symmetry"), isConsistent);
  base::Matrix& loads = cubes.assembly().bodies[1].loads;
  loads.shape(3 * static_cast<int>(cubes.assembly().bodies[1].nodes.size()), steps);
  randomize(loads, 7);
  return cubes.assembly();
}

void expectEquilibrium(const Stage& stage) {
  for (int body = 0; body < 2; ++body) {
    const auto& stiffness = *stage.assembly.bodies[body].stiffness;
    const base::Matrix inner = product(stiffness, stage.displacements(body));
    const base::Matrix outer = stage.nodalForces(body);
    for (int t = 0; t < steps; ++t) {
      for (int dof = 0; dof < inner.numRows(); ++dof) {
        EXPECT_NEAR(inner(dof, t), outer(dof, t), roundOff * inner.normInf());
      }
    }
  }
}

TEST(LinearStage, BalancesEveryBody) {
  for (bool withMacroProblem : {false, true}) {
    for (bool isConsistent : {false, true}) expectEquilibrium(Stage(loadedCubes(isConsistent), withMacroProblem));
  }
}

TEST(LinearStage, BalancesEveryBodyInTheVelocityForm) {
  for (bool withMacroProblem : {false, true})
    expectEquilibrium(Stage(loadedCubes(), withMacroProblem, Formulation::velocity));
}

TEST(LinearStage, KnowsItsErrorInSinglePrecision) {
  if (substructure::availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD solves in single precision";
  substructure::SolverOptions options;
  options.invertTrace = true;
  Stage stage(loadedCubes(), true, Formulation::displacement, options);
  const base::Matrix exact = stage.beta, trace = stage.linear.trace();
  const double error = stage.linear.prepareSingle();
  EXPECT_GT(error, 1e-8);
  EXPECT_LT(error, 1e-4);
  stage.linear.solve(stage.alpha, stage.beta);
  EXPECT_EQ(stage.beta, exact) << "double as long as nobody asks for less";
  stage.linear.solve(stage.alpha, stage.beta, substructure::Precision::single);
  base::Matrix difference = stage.linear.trace();
  difference -= trace;
  EXPECT_GT(difference.normFrobenius(), 0.0);
  EXPECT_LT(difference.normFrobenius(), 10.0 * error * trace.normFrobenius());
}

/// A x of columns x, by themselves.
base::Matrix change(Stage& stage, const base::Matrix& x, substructure::Precision precision) {
  base::Matrix image(x.numRows(), x.numCols());
  stage.linear.select(std::vector<int>(static_cast<std::size_t>(x.numCols()), BodyOperators::withoutLoads));
  stage.linear.solve(x, image, precision);
  stage.linear.select(allSteps(steps));
  return image;
}

/// A pull on the upper cube whose size is found: so that the joint opens as far as it is told to.
assembly::Assembly pulledCubes() {
  BoxAssembly cubes =
      twoCubes(laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 100.0}, {"Tangential Stiffness", 300.0}}),
               laws::makeLaw("Pressure", {{"Pressure", -2.0}}), steps);
  assembly::Assembly assembly = cubes.assembly();
  const auto numberOf = [&](bool hasTwoSides) {
    const auto found =
        std::find_if(assembly.interfaces.begin(), assembly.interfaces.end(), [&](const assembly::Interface& interface) {
          return hasTwoSides ? interface.law->sides() == laws::Sides::two : interface.law->prescribesTraction();
        });
    return static_cast<int>(found - assembly.interfaces.begin());
  };
  const int joint = numberOf(true);
  const std::vector<base::Vector3> along(assembly.interfaces[joint].pairs(), base::Vector3{0.0, 0.0, 1.0});
  assembly.path = assembly::PathControl{{numberOf(false)}, {{joint, along}}, {0.1, 0.3, 0.2, 0.4}};
  return assembly;
}

void expectChangesByThemselves(const assembly::Assembly& assembly, bool withMacroProblem, bool inverts) {
  substructure::SolverOptions options;
  options.invertTrace = inverts;
  Stage stage(assembly, withMacroProblem, Formulation::displacement, options);
  base::Matrix x(stage.alpha);
  randomize(x, 3);
  base::Matrix further(stage.alpha), whole(stage.beta), again(stage.beta);
  further += x;
  stage.linear.solve(further, whole);
  base::Matrix image = change(stage, x, substructure::Precision::exact);
  stage.linear.solve(further, again);
  EXPECT_EQ(again, whole) << "loads are there again";
  const double size = image.normInf();
  image += stage.beta;
  image -= whole;
  EXPECT_LT(image.normInf(), roundOff * size);
}

TEST(LinearStage, KnowsWhatChangesDoWithoutLoads) {
  for (const bool withMacroProblem : {false, true}) {
    for (const bool inverts : {false, true}) {
      expectChangesByThemselves(loadedCubes(), withMacroProblem, inverts);
      expectChangesByThemselves(pulledCubes(), withMacroProblem, inverts);
    }
  }
}

// Loads would leave their own round-off, however small the change is.
TEST(LinearStage, ErrsInSinglePrecisionAsFarAsChangesGo) {
  if (substructure::availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD solves in single precision";
  substructure::SolverOptions options;
  options.invertTrace = true;
  Stage stage(loadedCubes(), true, Formulation::displacement, options);
  const double error = stage.linear.prepareSingle();
  for (const double size : {1.0, 1e-6, 1e-12}) {
    base::Matrix x(stage.alpha);
    x *= size;
    const base::Matrix exact = change(stage, x, substructure::Precision::exact);
    base::Matrix difference = change(stage, x, substructure::Precision::single);
    difference -= exact;
    EXPECT_GT(difference.normFrobenius(), 0.0);
    EXPECT_LT(difference.normFrobenius(), 10.0 * error * exact.normFrobenius()) << size;
  }
}

TEST(LinearStage, TakesTheTraceFromTheBodies) {
  const Stage stage(loadedCubes());
  for (const TraceLayout::Block& block : stage.layout.blocks()) {
    const mesh::TraceOperator& trace = stage.assembly.interfaces[block.interface].trace(block.side);
    for (int p = 0; p < block.pairs; ++p) {
      const base::Vector3 u = stage.linear.displacement(block.body, trace.node(p), 2);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(stage.linear.trace()(block.begin + 3 * p + c, 2), u[c], 1e-12);
    }
  }
}

// E-: f + k w = alpha, and beta = f - k w is what goes on to the local stage.
TEST(LinearStage, StaysOnTheSearchDirection) {
  const Stage stage(loadedCubes(), false);
  for (int t = 0; t < steps; ++t) {
    for (int row = 0; row < stage.layout.rows(); ++row) {
      const double kw = stage.layout.stiffness()[row] * stage.linear.trace()(row, t);
      const double size = std::abs(kw) + 1.0;
      EXPECT_NEAR(stage.linear.traction()(row, t) + kw, stage.alpha(row, t), 1e-14 * size);
      EXPECT_NEAR(stage.linear.traction()(row, t) - kw, stage.beta(row, t), 1e-14 * size);
    }
  }
}

TEST(LinearStage, StaysOnTheSearchDirectionOfIncrements) {
  const Stage stage(loadedCubes(), false, Formulation::velocity);
  for (int t = 0; t < steps; ++t) {
    for (int row = 0; row < stage.layout.rows(); ++row) {
      const double before = t > 0 ? stage.linear.trace()(row, t - 1) : 0.0;
      const double kdw = stage.layout.stiffness()[row] * (stage.linear.trace()(row, t) - before);
      const double size = std::abs(stage.linear.traction()(row, t)) + std::abs(kdw) + 1.0;
      EXPECT_NEAR(stage.linear.traction()(row, t) + kdw, stage.alpha(row, t), 1e-13 * size);
      EXPECT_NEAR(stage.linear.traction()(row, t) - kdw, stage.beta(row, t), 1e-13 * size);
    }
  }
}

// With the macro problem f + k w = alpha + k P c: the shift is a rigid motion of the interface, the same on both sides.
TEST(LinearStage, ShiftsTheSearchDirectionOfAnInterfaceRigidly) {
  const Stage stage(loadedCubes());
  const assembly::Interface& joint = stage.assembly.interfaces[1];
  const auto shift = [&](int interfaceIndex, int side, int pair, int t) {
    base::Vector3 d{};
    for (int c = 0; c < 3; ++c) {
      const int row = stage.layout.begin(interfaceIndex, side) + 3 * pair + c;
      const double k = stage.layout.stiffness()[row];
      d[c] = (stage.linear.traction()(row, t) - stage.alpha(row, t)) / k + stage.linear.trace()(row, t);
    }
    return d;
  };
  double largest = 0.0;
  for (int p = 0; p < joint.pairs(); ++p) {
    const base::Vector3 one = shift(1, 0, p, 1), two = shift(1, 1, p, 1);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(one[c], two[c], 1e-12);
      largest = std::max(largest, std::abs(one[c]));
    }
    // The distance to the other nodes does not change.
    const base::Vector3 first = shift(1, 0, 0, 1);
    double stretch = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      stretch += (one[c] - first[c]) * (joint.position[p][c] - joint.position[0][c]);
    }
    EXPECT_NEAR(stretch, 0.0, 1e-12);
  }
  EXPECT_GT(largest, 1e-3);
  // Boundaries stay where they are.
  for (double d : shift(0, 0, 0, 1)) EXPECT_NEAR(d, 0.0, 1e-12);
}

/// Force and moment of f1 + f2 about the origin.
std::array<double, 6> resultant(const Stage& stage, int interfaceIndex, int t) {
  const assembly::Interface& joint = stage.assembly.interfaces[interfaceIndex];
  std::array<double, 6> sum{};
  std::vector<double> force(3 * joint.pairs());
  for (int side = 0; side < 2; ++side) {
    applyMass(joint, 3, stage.linear.traction()[t] + stage.layout.begin(interfaceIndex, side), force.data());
    for (int p = 0; p < joint.pairs(); ++p) {
      const base::Vector3& x = joint.position[p];
      const double* f = force.data() + 3 * p;
      for (std::size_t c = 0; c < 3; ++c) sum[c] += f[c];
      sum[3] += x[1] * f[2] - x[2] * f[1];
      sum[4] += x[2] * f[0] - x[0] * f[2];
      sum[5] += x[0] * f[1] - x[1] * f[0];
    }
  }
  return sum;
}

TEST(LinearStage, BalancesForcesAndMomentsOfInterfaces) {
  for (Formulation formulation : {Formulation::displacement, Formulation::velocity}) {
    for (bool isConsistent : {false, true}) {
      const Stage stage(loadedCubes(isConsistent), true, formulation);
      EXPECT_EQ(stage.linear.macroUnknowns(), 6);
      for (int t = 0; t < steps; ++t) {
        for (double component : resultant(stage, 1, t)) EXPECT_NEAR(component, 0.0, 1e-10);
      }
    }
  }
  // Without the macro problem there is no such balance; otherwise this test would test nothing.
  double unbalanced = 0.0;
  for (double component : resultant(Stage(loadedCubes(), false), 1, 0)) unbalanced += std::abs(component);
  EXPECT_GT(unbalanced, 1e-3);
}

TEST(LinearStage, SolvesAChoiceOfLoadSteps) {
  Stage stage(loadedCubes());
  base::Matrix alpha(stage.layout.rows(), 2), beta(stage.layout.rows(), 2);
  const std::vector<int> chosen{1, 3};
  for (int t = 0; t < 2; ++t) std::copy_n(stage.alpha[chosen[t]], alpha.numRows(), alpha[t]);
  EXPECT_EQ(stage.linear.stages(), 1);
  stage.linear.select(chosen);
  stage.linear.solve(alpha, beta);
  stage.linear.solve(alpha, beta);
  EXPECT_EQ(stage.linear.stages(), 2);  // two halves
  for (int t = 0; t < 2; ++t) {
    for (int row = 0; row < beta.numRows(); ++row) {
      EXPECT_NEAR(beta(row, t), stage.beta(row, chosen[t]), 1e-11);
    }
  }
}

// Laws that prescribe tractions may be replaced: as if the stage had been built with the new ones.
TEST(LinearStage, TakesNewLoads) {
  Stage stage(loadedCubes());
  assembly::Assembly other = loadedCubes();
  for (assembly::Assembly* assembly : {&stage.assembly, &other}) {
    for (assembly::Interface& joint : assembly->interfaces) {
      if (joint.law->prescribesTraction())
        joint.law = laws::makeLaw("Pressure", {{"Pressure", -3.0}}, {{"Pressure", {4, 1, 2, 1}}});
    }
  }
  stage.linear.updateLoads();
  stage.linear.solve(stage.alpha, stage.beta);
  const Stage fresh(other);
  for (int t = 0; t < steps; ++t) {
    for (int row = 0; row < stage.layout.rows(); ++row) EXPECT_NEAR(stage.beta(row, t), fresh.beta(row, t), 1e-11);
  }
}

}  // namespace
}  // namespace harmos::latin
