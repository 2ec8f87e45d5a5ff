#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <tuple>

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
  EXPECT_STREQ(scene.cutLaw->name(), "Perfect");
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

TEST(Scene, IterativePartsNeedMultigrid) {
  const char* const before = std::getenv("HARMOS_MULTIGRID");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("HARMOS_MULTIGRID", "no/such/multigrid.so", 1);
  EXPECT_NO_THROW(sample({"Parts/lower/Linear Solver=Direct"}));
  try {
    sample({"Parts/lower/Linear Solver=Iterative"});
    ADD_FAILURE();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    const std::string message = error.what();
    EXPECT_EQ(message.rfind("--set: Parts / lower / Linear Solver: ", 0), 0u) << message;
    EXPECT_NE(message.find("libtrilinos-muelu-dev"), std::string::npos) << message;
  }
  if (before != nullptr) {
    ::setenv("HARMOS_MULTIGRID", kept.c_str(), 1);
  } else {
    ::unsetenv("HARMOS_MULTIGRID");
  }
}

TEST(Scene, EffectiveInputIsTheSameScene) {
  const std::string effective = input::effectiveInput(sample().input);
  const Scene again =
      makeScene(input::InputTree::fromText(effective, "again.xml"), "again.xml", {}, laws::builtInLaws());
  EXPECT_EQ(input::effectiveInput(again.input), effective);
}

TEST(Scene, AsksAboutMaterialsThatNoSolidHasInItsUnits) {
  const auto warnings = [](const std::string& units, const std::string& modulus) {
    return sample({"Units=" + units, "Materials/steel/Young's Modulus=" + modulus}).warnings;
  };
  EXPECT_TRUE(warnings("mm N s", "210000").empty());
  EXPECT_TRUE(warnings("m N s", "2.1e11").empty());
  EXPECT_TRUE(sample({"Materials/steel/Young's Modulus=2.1e11"}).warnings.empty()) << "nothing is declared";
  const auto stiff = warnings("mm N s", "2.1e11"), soft = warnings("m N s", "210000");
  ASSERT_EQ(stiff.size(), 1u);
  EXPECT_NE(stiff[0].find("Materials / steel / Young's Modulus: in the units \"mm N s\" this is 2.1e+17 Pa, more than "
                          "diamond has. It is a usual one in \"m N s\": change the number or the units."),
            std::string::npos)
      << stiff[0];
  ASSERT_EQ(soft.size(), 1u);
  EXPECT_NE(soft[0].find("less than soft rubber has. It is a usual one in \"mm N s\", "), std::string::npos) << soft[0];
}

TEST(Scene, AsksAboutDensitiesThatNoSolidHasInItsUnits) {
  std::string text = sampleScene();
  const std::string poisson = "<Parameter name=\"Poisson's Ratio\"";
  text.insert(text.find(poisson), R"(<Parameter name="Density" type="double" value="7.85e-9"/>)");
  const auto warnings = [&](const std::string& units, const std::string& modulus, const std::string& density) {
    return makeScene(
               input::InputTree::fromText(text, "sample.xml"), "sample.xml",
               {"Units=" + units, "Materials/steel/Young's Modulus=" + modulus, "Materials/steel/Density=" + density},
               laws::builtInLaws())
        .warnings;
  };
  for (const auto& [units, modulus, density] :
       {std::tuple("mm N s", "210000", "7.85e-9"), std::tuple("m N s", "2.1e11", "7850"),
        std::tuple("mm kN s", "210", "7.85e-12"), std::tuple("in lbf s", "3e7", "7.35e-4"),
        std::tuple("um uN s", "210000", "7.85e-15"), std::tuple("cm N s", "2.1e7", "7.85e-5")}) {
    EXPECT_TRUE(warnings(units, modulus, density).empty()) << units;
  }
  const auto heavy = warnings("mm N s", "210000", "7850");
  ASSERT_EQ(heavy.size(), 1u);
  EXPECT_NE(
      heavy[0].find("Materials / steel / Density: in the units \"mm N s\" this is 7.85e+15 kg/m^3, more than osmium "
                    "has. It is a usual one in \"m N s\": change the number or the units."),
      std::string::npos)
      << heavy[0];
}

TEST(Scene, SaysWhatItHoldsInVain) {
  EXPECT_TRUE(sample().warnings.empty());
  std::string text = sampleScene();
  const auto insert = [&](const std::string& before, const std::string& more) { text.insert(text.find(before), more); };
  insert("<ParameterList name=\"steel\">", R"(<ParameterList name="lead">
    <Parameter name="Type" type="string" value="Isotropic"/>
    <Parameter name="Young's Modulus" type="double" value="$lead"/>
    <Parameter name="Poisson's Ratio" type="double" value="0.4"/></ParameterList>)");
  insert("<ParameterList name=\"Materials\">", R"(<ParameterList name="Values">
    <Parameter name="lead" type="double" value="16"/>
    <Parameter name="tin" type="double" value="50"/></ParameterList>)");
  insert("<ParameterList name=\"ramp\">", R"xml(<ParameterList name="late">
    <Parameter name="Type" type="string" value="Ramp"/>
    <Parameter name="Start" type="double" value="3"/>
    <Parameter name="End" type="double" value="4"/></ParameterList>
    <ParameterList name="idle">
    <Parameter name="Type" type="string" value="Table"/>
    <Parameter name="Times" type="Array(double)" value="{0}"/>
    <Parameter name="Values" type="Array(double)" value="{1}"/></ParameterList>)xml");
  const auto make = [&](const std::vector<std::string>& overrides) {
    return makeScene(input::InputTree::fromText(text, "scene.xml"), "scene.xml", overrides, laws::builtInLaws())
        .warnings;
  };
  const auto ends = [](const std::string& sentence, const std::string& end) {
    return sentence.size() > end.size() && sentence.compare(sentence.size() - end.size(), end.size(), end) == 0;
  };
  const auto warnings = make({});
  ASSERT_EQ(warnings.size(), 4u);
  EXPECT_TRUE(ends(warnings[0], "Values / tin: nothing refers to this value.")) << warnings[0];
  EXPECT_TRUE(ends(warnings[1], "Materials / lead: no part has this material.")) << warnings[1];
  EXPECT_TRUE(ends(warnings[2], "Histories / late: nothing follows this history.")) << warnings[2];
  EXPECT_TRUE(ends(warnings[3], "Histories / idle: nothing follows this history.")) << warnings[3];
  const auto changed = make({"Materials/steel/Young's Modulus=$tin", "Parts/lower/Material=lead",
                             "Parts/upper/Body Force/Z History=late", "Boundaries/pressed/Law/Pressure History=idle"});
  ASSERT_EQ(changed.size(), 2u);
  EXPECT_TRUE(ends(changed[0],
                   "Histories / late: it begins at time 3, but the last load step ends at time 3, so that what follows "
                   "it never changes."))
      << changed[0];
  EXPECT_TRUE(ends(changed[1], "Histories / ramp: nothing follows this history.")) << changed[1];
}

TEST(Scene, NamesHistoriesThatNeverBegin) {
  std::string text = sampleScene();
  const std::string ramp = R"(<Parameter name="Type" type="string" value="Ramp"/>
      <Parameter name="End" type="double" value="2"/>)";
  text.replace(text.find(ramp), ramp.size(), R"(<Parameter name="Type" type="string" value="Formula"/>
      <Parameter name="Formula" type="string" value="t > 3 ? 1 : 0"/>)");
  const auto warnings =
      makeScene(input::InputTree::fromText(text, "scene.xml"), "scene.xml", {}, laws::builtInLaws()).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "scene.xml:71: Histories / ramp: it is 0 at every load step, so that what follows it is 0 throughout.");
}

}  // namespace
}  // namespace harmos::scene
