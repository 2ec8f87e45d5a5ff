#include <cmath>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/PairFields.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr int steps = 2;
constexpr double accuracy = 1e-9;
// Both ways end within the accuracy of the same state; the matrices have a condition of 1e4.
constexpr double agreement = 1e-7;

std::shared_ptr<const laws::InterfaceLaw> foundation(double normal, double tangential) {
  return laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", normal}, {"Tangential Stiffness", tangential}});
}
std::shared_ptr<const laws::InterfaceLaw> symmetry() {
  return laws::makeLaw("Symmetry");
}

/// Two cubes in contact, with boundaries of all affine kinds that meet at edges and corners; the upper one is turned,
/// so that no normal of its faces lies along an axis.
BoxAssembly heldCubes(bool isConsistent = false) {
  BoxAssembly cubes({{"lower", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {"upper", {0, 0, 1}, {1, 1, 2}, {2, 2, 2}}}, steps);
  for (const std::string box : {"lower", "upper"}) {
    cubes.deform(box, [](const base::Vector3& x) {
      return base::Vector3{0.8 * x[0] - 0.6 * x[1], 0.6 * x[0] + 0.8 * x[1], x[2]};
    });
  }
  cubes.hold("bottom", "lower_zmin",
             laws::makeLaw("Prescribed Displacement", {{"X", 0.02}, {"Z", 0.01}}, {{"X", {1, 2}}, {"Z", {1, -1}}}),
             isConsistent);
  cubes.hold("side", "lower_ymin", symmetry(), isConsistent);
  cubes.join("joint", "lower_zmax", "upper_zmin", laws::makeLaw("Unilateral Contact"), isConsistent);
  cubes.hold("spring", "upper_xmin", foundation(200.0, 30.0), isConsistent);
  cubes.hold("plane", "upper_ymin", symmetry(), isConsistent);
  cubes.hold("top", "upper_zmax", laws::makeLaw("Pressure", {{"Pressure", 20.0}}), isConsistent);
  return cubes;
}

struct Solved {
  explicit Solved(const assembly::Assembly& given, Elimination elimination) : assembly(given) {
    LatinOptions options;
    options.accuracy = accuracy;
    options.stages.elimination = elimination;
    solver = std::make_unique<LatinSolver>(assembly, options, self(), timers);
    result = solver->solve();
    EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
  }
  base::Vector3 resultant(int interface, int step) const {
    base::Vector3 sum{};
    const std::vector<base::Vector3> f = solver->state().tractions(interface, step);
    for (std::size_t p = 0; p < f.size(); ++p) sum = sum + assembly.interfaces[interface].area[p] * f[p];
    return sum;
  }
  assembly::Assembly assembly;
  base::Timers timers;
  std::unique_ptr<LatinSolver> solver;
  LatinResult result;
};

std::vector<bool> eliminated(const assembly::Assembly& assembly, Elimination which = Elimination::affine) {
  const assembly::SearchDirection k(assembly, 1.0, *self());
  const EliminatedBoundaries boundaries(assembly, k, which, resistedInPlane(assembly, *self()));
  std::vector<bool> result;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i)
    result.push_back(boundaries.contains(static_cast<int>(i)));
  return result;
}

// Neither loads nor motions of boundaries stand in what a change does.
TEST(EliminatedBoundaries, StayWhereTheyAreWhenOnlyAlphaChanges) {
  for (const Elimination elimination : {Elimination::none, Elimination::rigid, Elimination::affine}) {
    BoxAssembly cubes = heldCubes();
    base::Timers timers;
    StageOptions options;
    options.elimination = elimination;
    FixedPoint fixedPoint(cubes.assembly(), options, self(), timers);
    base::Matrix x(fixedPoint.layout().rows(), steps), image(x), before(x), after(x);
    randomize(x);
    fixedPoint.solveLinear(base::Matrix(x.numRows(), steps), before);
    fixedPoint.solveLinear(x, after);
    after -= before;
    fixedPoint.solveChange(x, image, substructure::Precision::exact);
    fixedPoint.selectAll();
    image -= after;
    EXPECT_LT(image.normInf(), accuracy * after.normInf());
  }
}

TEST(EliminatedBoundaries, GiveTheStateThatIteratingOnThemGives) {
  const Solved with(heldCubes().assembly(), Elimination::affine), without(heldCubes().assembly(), Elimination::none);
  EXPECT_LT(with.solver->fixedPoint().layout().rows(), without.solver->fixedPoint().layout().rows());
  for (int body = 0; body < 2; ++body) {
    for (int node = 0; node < static_cast<int>(with.assembly.bodies[body].nodes.size()); ++node) {
      for (int t = 0; t < steps; ++t) {
        const base::Vector3 a = with.solver->state().displacement(body, node, t);
        const base::Vector3 b = without.solver->state().displacement(body, node, t);
        EXPECT_LT(base::distance(a, b), agreement * 0.05) << body << " " << node;
      }
    }
  }
  // How boundaries share the reaction of a node that they hold both is not determined; on the springs it is.
  for (int t = 0; t < steps; ++t) {
    const PairFields a = pairFields(with.solver->state(), 3), b = pairFields(without.solver->state(), 3);
    for (int p = 0; p < a.pairs; ++p) {
      EXPECT_LT(base::distance(a.traction[a.at(t, p)], b.traction[b.at(t, p)]), agreement * 20.0);
      EXPECT_LT(base::distance(a.jump[a.at(t, p)], b.jump[b.at(t, p)]), agreement * 0.05);
    }
  }
}

TEST(EliminatedBoundaries, BalanceEveryBody) {
  const Solved solved(heldCubes().assembly(), Elimination::affine);
  for (int t = 0; t < steps; ++t) {
    const base::Vector3 upper = solved.resultant(3, t) + solved.resultant(4, t) + solved.resultant(5, t);
    const base::Vector3 joint = solved.resultant(2, t);
    const base::Vector3 lower = solved.resultant(0, t) + solved.resultant(1, t) + joint;
    EXPECT_LT(base::norm(upper - joint), agreement * 20.0);
    EXPECT_LT(base::norm(lower), agreement * 20.0);
  }
  // A symmetry plane answers along its normal only.
  const assembly::Interface& plane = solved.assembly.interfaces[4];
  const std::vector<base::Vector3> f = solved.solver->state().tractions(4, 0);
  for (std::size_t p = 0; p < f.size(); ++p) {
    EXPECT_LT(base::tangentialNorm(base::toFrame(plane.frame[p], f[p])), 1e-12 * 20.0);
  }
}

TEST(EliminatedBoundaries, NeedNoIterationWithoutInterfaces) {
  BoxAssembly cube({{"cube", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}, steps);
  cube.hold("x", "cube_xmin", symmetry());
  cube.hold("y", "cube_ymin", symmetry());
  cube.hold("z", "cube_zmin", symmetry());
  cube.hold("top", "cube_zmax", laws::makeLaw("Pressure", {{"Pressure", 10.0}}));
  const Solved solved(cube.assembly(), Elimination::affine);
  const int node = static_cast<int>(solved.assembly.bodies[0].nodes.size()) - 1;
  // Uniaxial: E = 1000, nu = 0.3.
  const base::Vector3 u = solved.solver->state().displacement(0, node, 0);
  EXPECT_NEAR(u[2], -0.01, 1e-13);
  EXPECT_NEAR(u[0], 0.003, 1e-13);
  EXPECT_EQ(solved.result.iterations, 2);  // and one by which the march sees that nothing is left
}

TEST(EliminatedBoundaries, AreThoseWhoseOperatorIsConstant) {
  using Law = std::shared_ptr<const laws::InterfaceLaw>;
  EXPECT_EQ(eliminated(heldCubes().assembly()), (std::vector<bool>{true, true, false, true, true, false}));
  EXPECT_EQ(eliminated(heldCubes().assembly(), Elimination::rigid),
            (std::vector<bool>{true, true, false, false, true, false}));
  EXPECT_EQ(eliminated(heldCubes(true).assembly()), std::vector<bool>(6, false));
  const Law varying = laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", 10.0}, {"Tangential Stiffness", 10.0}},
                                    {{"Normal Stiffness", {1.0, 2.0}}});
  BoxAssembly cubes = twoCubes(laws::makeLaw("Perfect"), varying, 2);
  EXPECT_EQ(eliminated(cubes.assembly()), (std::vector<bool>{true, false, false}));
}

// The upper cube slides on the plane: only the search direction holds it there until the joint does.
TEST(EliminatedBoundaries, LeaveABodyThatTheyWouldNotHoldAlone) {
  BoxAssembly cube({{"cube", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}, 1);
  cube.hold("plane", "cube_zmin", symmetry());
  EXPECT_EQ(eliminated(cube.assembly()), std::vector<bool>{false});
}

TEST(EliminatedBoundaries, RefuseToHoldANodeAtTwoPlaces) {
  BoxAssembly cube({{"cube", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}, 1);
  cube.hold("bottom", "cube_zmin", clamp());
  cube.hold("side", "cube_xmin", laws::makeLaw("Prescribed Displacement", {{"X", 0.1}}));
  try {
    eliminated(cube.assembly());
    FAIL() << "accepted";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    EXPECT_NE(std::string(error.what()).find("\"bottom\" and \"side\" hold the node at (0, 0, 0)"), std::string::npos)
        << error.what();
  }
}

TEST(EliminatedBoundaries, FollowLawsThatAreReplaced) {
  BoxAssembly cubes = heldCubes();
  assembly::Assembly assembly = cubes.assembly();
  base::Timers timers;
  LatinOptions options;
  options.accuracy = accuracy;
  LatinSolver solver(assembly, options, self(), timers);
  solver.solve();
  assembly.interfaces[0].law = laws::makeLaw("Prescribed Displacement", {{"X", 0.03}, {"Z", 0.02}});
  solver.fixedPoint().updateLaws();
  EXPECT_EQ(solver.solve().outcome, Outcome::certified);
  const int node = assembly.interfaces[0].trace1.node(0);
  EXPECT_NEAR(solver.state().displacement(0, node, 1)[2], 0.02, 1e-14);
  assembly.interfaces[3].law = foundation(100.0, 30.0);
  EXPECT_THROW(solver.fixedPoint().updateLaws(), base::Error);
}

}  // namespace
}  // namespace harmos::latin
