// Periodic cells under a mean strain against laminate theory.
#include <gtest/gtest.h>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

constexpr double soft = 1000.0, hard = 20000.0, xx = 1e-3, yy = 2e-3, xy = 5e-4;

/// Force on opposite faces, shared among interfaces that meet at corners.
double force(const SolvedScene& run, const char* faces, const char* component) {
  const std::string x = faces;
  const bool isX = x == "x";
  return run.value((isX ? "x_low_" : "y_soft_") + std::string(component)) +
         run.value((isX ? "x_up_" : "y_hard_") + std::string(component));
}

// Layers of 1 and 3 across x: in series across, in parallel along; nu = 0.
TEST(Periodic, LaminateUnderMeanStrain) {
  const SolvedScene run(SceneInput::fromFile("periodic/laminate.xml"));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double series = 4.0 / (1.0 / soft + 3.0 / hard);
  EXPECT_NEAR(force(run, "x", "x"), 2.0 * series * xx, 1e-5);
  EXPECT_NEAR(force(run, "y", "y"), (soft + 3.0 * hard) * yy, 1e-4);
  EXPECT_NEAR(force(run, "x", "y"), 2.0 * (0.5 * series) * 2.0 * xy, 1e-5);
  EXPECT_NEAR(force(run, "y", "x"), 4.0 * (0.5 * series) * 2.0 * xy, 1e-5);
}

// Patch test: a cell of one material is strained as it is told, and its stress is Hooke's.
TEST(Periodic, PatchTest) {
  const SolvedScene run(SceneInput::fromFile("periodic/laminate.xml")
                            .set(assignment("Materials/soft/Young's Modulus", hard))
                            .set("Materials/soft/Poisson's Ratio=0.3")
                            .set("Materials/hard/Poisson's Ratio=0.3"));
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  const double plane = hard / (1.0 - 0.09), shear = hard / 2.6;
  EXPECT_NEAR(force(run, "x", "x"), 2.0 * plane * (xx + 0.3 * yy), 1e-3);
  EXPECT_NEAR(force(run, "y", "y"), 4.0 * plane * (yy + 0.3 * xx), 1e-3);
  EXPECT_NEAR(force(run, "x", "y"), 2.0 * shear * 2.0 * xy, 1e-3);
}

}  // namespace
}  // namespace harmos::verification
