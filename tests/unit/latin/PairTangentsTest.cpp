#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/FixedPoint.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

// Along any direction the tangent is what the local stage does, at every load step with the history before it.
TEST(PairTangents, AreThoseOfTheLocalStage) {
  constexpr int steps = 3;
  BoxAssembly cubes =
      twoCubes(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}),
               laws::makeLaw("Prescribed Displacement", {{"X", 0.002}, {"Y", 0.0}, {"Z", -0.004}}), steps);
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  PointwiseLocalStage& local = fixedPoint.pointwiseStage();
  InterfaceLines lines(cubes.assembly(), fixedPoint.searchDirection(), fixedPoint.layout());
  PairTangents tangents(cubes.assembly(), lines);
  const int rows = fixedPoint.layout().rows();
  base::Matrix beta(rows, steps), directions(rows, 4), shifted(rows, steps), found(rows, 4);
  base::Matrix traction(rows, steps), moved(rows, steps);
  randomize(beta);
  randomize(directions, 2);
  constexpr double length = 1e-7;
  local.begin();
  for (int t = 0; t < steps; ++t) {
    local.solveColumn(t, beta, traction);
    local.differentiateColumn(t, tangents);
    tangents.apply(directions, found);
    for (int j = 0; j < directions.numCols(); ++j) {
      shifted.assign(beta);
      for (int row = 0; row < rows; ++row) shifted[t][row] += length * directions[j][row];
      local.solveColumn(t, shifted, moved);
      for (int row = 0; row < rows; ++row) {
        EXPECT_NEAR(found[j][row], (moved[t][row] - traction[t][row]) / length, 1e-5) << t << " " << row;
      }
    }
    local.solveColumn(t, beta, moved);
    for (int row = 0; row < rows; ++row) EXPECT_EQ(moved[t][row], traction[t][row]);
    local.accept();
  }
}

// Before anything has moved there is no size to take a share of.
TEST(PairTangents, AreKnownAtRest) {
  const assembly::Assembly assembly =
      twoChains(laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 30.0}, {"Tangential Stiffness", 20.0}}), clamp());
  base::Timers timers;
  FixedPoint fixedPoint(assembly, {}, self(), timers);
  PointwiseLocalStage& local = fixedPoint.pointwiseStage();
  InterfaceLines lines(assembly, fixedPoint.searchDirection(), fixedPoint.layout());
  PairTangents tangents(assembly, lines);
  base::Matrix beta(fixedPoint.layout().rows(), 1), traction(beta), unit(beta), found(beta);
  local.begin();
  local.solveColumn(0, beta, traction);
  local.differentiateColumn(0, tangents);
  randomize(unit);
  tangents.apply(unit, found);
  local.solveColumn(0, unit, traction);
  for (int row = 0; row < unit.numRows(); ++row) EXPECT_NEAR(found[0][row], traction[0][row], 1e-6);
}

}  // namespace
}  // namespace harmos::latin
