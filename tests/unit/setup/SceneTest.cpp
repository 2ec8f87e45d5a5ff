#include <gtest/gtest.h>

#include <harmos/base/EffectiveInput.hpp>
#include <harmos/setup/SceneSpec.hpp>

#include "Sample.hpp"

namespace harmos::setup {
namespace {

TEST(Scene, TimesFollowTheSteps) {
  EXPECT_EQ(sample().times, (std::vector<double>{1.0, 1.5, 2.0, 2.5, 3.0}));
}

TEST(Scene, HistoriesReachTheParts) {
  const Scene scene = sample();
  const base::Schedule force = scene.input.lists("Parts")[1].list("Body Force").schedule("Z");
  EXPECT_EQ(force[0], -1.5);
  EXPECT_EQ(force[1], -2.25);
  EXPECT_EQ(force[4], -3.0);
}

TEST(Scene, HasALawPerInterfaceAndBoundary) {
  const Scene scene = sample();
  EXPECT_STREQ(scene.laws.at("seal")->name(), "Coulomb Friction");
  EXPECT_STREQ(scene.laws.at("pressed")->name(), "Pressure");
  EXPECT_EQ(scene.cutLaw, nullptr);
  EXPECT_STREQ(sample({"Parts/lower/Pieces=2"}).cutLaw->name(), "Perfect");
}

TEST(Scene, EffectiveInputIsTheSameScene) {
  const std::string effective = base::effectiveInput(sample().input);
  const Scene again =
      makeScene(base::InputTree::fromText(effective, "again.xml"), "again.xml", {}, laws::builtInLaws());
  EXPECT_EQ(base::effectiveInput(again.input), effective);
}

}  // namespace
}  // namespace harmos::setup
