#include <gtest/gtest.h>

#include <harmos/latin/detail/OtherSolutions.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

/// The largest pressure between two cubes that are pressed and dragged, which is determined, looked for from a wild
/// start with these search directions: what is said of its range.
ResponseRange rangeFromWildStart(double searchDirectionScale) {
  BoxAssembly cubes = twoCubes(
      laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}),
      laws::makeLaw("Prescribed Displacement", {{"X", 0.1}, {"Y", 0.0}, {"Z", -0.05}}, {{"X", {0.3, 1.0}}}), 2);
  StageOptions options;
  options.searchDirectionScale = searchDirectionScale;
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), options, self(), timers);
  const std::vector<std::shared_ptr<const Response>> responses = {
      std::make_shared<MaximumResponse>("largest", std::vector<int>{0}, MaximumResponse::Field::contactPressure)};
  const base::Matrix known(fixedPoint.layout().rows(), 2);
  Indeterminacy found;
  found.responses.resize(1);
  found.ways.emplace_back(known);
  randomize(found.ways[0]);
  LatinResult result;
  result.linearStages = 1000;
  result.responses.resize(1);
  result.responses[0].values = {0.0, 0.0};
  result.responses[0].size = 1.0;
  OtherSolutions(fixedPoint, 1, 1e-3, [] { return false; }).extend(found, known, responses, result);
  EXPECT_TRUE(found.ways[0].empty());
  return found.responses[0];
}

// What a march has left on its way is no solution, however far from the known one.
TEST(OtherSolutions, AreSolutions) {
  EXPECT_GT(rangeFromWildStart(1.0).width(), 0.0);
  EXPECT_EQ(rangeFromWildStart(1e6).width(), 0.0);
}

}  // namespace
}  // namespace harmos::latin
