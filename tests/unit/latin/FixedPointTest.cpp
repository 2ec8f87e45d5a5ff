#include <string>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/latin/FixedPoint.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

// A restart with softer search directions may be too soft for a body that nothing else holds; what puts load steps back
// then has no operators to select them of.
TEST(FixedPoint, SaysWhatCannotBeFactoredAlsoWhileStepsArePutBack) {
  BoxAssembly cubes = twoCubes(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}),
                               laws::makeLaw("Pressure", {{"Pressure", 2.0}}), 1);
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  const auto rescale = [&] {
    const FixedPoint::AllStepsAtEnd restore(fixedPoint);
    fixedPoint.rescale(1e-30);
  };
  try {
    rescale();
    FAIL() << "the upper cube is held by nothing else";
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("The operator of part \""), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace harmos::latin
