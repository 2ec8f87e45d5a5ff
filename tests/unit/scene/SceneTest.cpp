#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/input/EffectiveInput.hpp>
#include <harmos/scene/SceneSpec.hpp>

#include "Sample.hpp"

namespace harmos::scene {
namespace {

TEST(Scene, TimesFollowTheSteps) {
  EXPECT_EQ(sample().times, (std::vector<double>{1.0, 1.5, 2.0, 2.5, 3.0}));
}

TEST(Scene, HistoriesReachTheParts) {
  const Scene scene = sample();
  const input::Schedule force = scene.input.lists("Parts")[1].list("Body Force").schedule("Z");
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

TEST(Scene, ItsDirectSolverExists) {
  EXPECT_NO_THROW(sample({"Solver/Linear Solver/Name=KLU2"}));
  EXPECT_NO_THROW(sample({"Solver/Linear Solver/Name=amesos2_klu2"}));
  try {
    sample({"Solver/Linear Solver/Name=tachho"});
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    const std::string message = error.what();
    EXPECT_EQ(message.rfind("--set: Solver / Linear Solver / Name: there is no "
                            "direct solver \"tachho\" in this build.\n  Did you mean \"tacho\"? Available: ",
                            0),
              0u)
        << message;
  }
}

TEST(Scene, EffectiveInputIsTheSameScene) {
  const std::string effective = input::effectiveInput(sample().input);
  const Scene again =
      makeScene(input::InputTree::fromText(effective, "again.xml"), "again.xml", {}, laws::builtInLaws());
  EXPECT_EQ(input::effectiveInput(again.input), effective);
}

}  // namespace
}  // namespace harmos::scene
