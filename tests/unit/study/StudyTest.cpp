#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <harmos/base/Error.hpp>
#include <harmos/study/PointsFile.hpp>
#include <harmos/study/StudyGroup.hpp>
#include <harmos/study/StudyReader.hpp>
#include <harmos/study/detail/StudyIdentity.hpp>

#include "../scene/Sample.hpp"

namespace harmos::study {
namespace {

class StudyTest : public ::testing::Test {
 protected:
  StudyTest() {
    std::filesystem::create_directories(directory);
    std::string scene = scene::sampleScene();
    // A number that is shared, to be varied by its name.
    scene.replace(scene.find("value=\"0.3\""), 11, "value=\"$mu\"");
    scene.insert(
        scene.find("  <ParameterList name=\"Mesh\">"),
        "  <ParameterList name=\"Values\"><Parameter name=\"mu\" type=\"double\" value=\"0.3\"/></ParameterList>\n");
    std::ofstream(directory + "/scene.xml") << scene;
  }
  ~StudyTest() override { std::filesystem::remove_all(directory); }

  Study study(const std::string& parameters, const std::vector<std::string>& overrides = {},
              const std::string& points = "") const {
    const std::string path = directory + "/study.xml";
    std::ofstream(path) << "<ParameterList name=\"Harmos Study\">\n"
                           "  <Parameter name=\"Scene\" type=\"string\" value=\"scene.xml\"/>\n"
                           "  <ParameterList name=\"Parameters\">\n"
                        << parameters << "  </ParameterList>\n</ParameterList>\n";
    return readStudy(path, overrides, points, laws::builtInLaws());
  }

  static std::string parameter(const std::string& name, const std::string& entry, const std::string& values) {
    return "<ParameterList name=\"" + name + "\"><Parameter name=\"Entry\" type=\"string\" value=\"" + entry +
           "\"/><Parameter name=\"Values\" type=\"Array(double)\" value=\"" + values + "\"/></ParameterList>\n";
  }

  static std::vector<std::vector<design::Configuration>> groupsOf(const Study& found) {
    return groupByOperators(found.parameters, found.configurations);
  }

  const std::string directory = "study_test." + std::to_string(::getpid());
  const laws::LawRegistry laws = laws::builtInLaws();
};

TEST_F(StudyTest, KnowsWhatAParameterChanges) {
  const Study found = study(parameter("mu", "Values/mu", "{0.2}") + parameter("gap", "Interfaces/seal/Law/Gap", "{0}") +
                            parameter("lift", "Boundaries/fixed/Law/Z", "{0}") +
                            parameter("p", "Boundaries/pressed/Law/Pressure", "{5}") +
                            parameter("weight", "Parts/upper/Body Force/Z", "{-3}") +
                            parameter("E", "Materials/steel/Young's Modulus", "{1000}"));
  using Kind = Effect::Kind;
  std::vector<Kind> effects;
  for (const auto& each : found.parameters) effects.push_back(each.effect);
  EXPECT_EQ(effects, (std::vector<Kind>{Kind::localStage, Kind::localStage, Kind::localStage, Kind::loads,
                                        Kind::operators, Kind::operators}));
  ASSERT_EQ(found.parameters[0].effects.size(), 1u);
  EXPECT_EQ(found.parameters[0].effects[0].entry, "Interfaces/seal/Law/Friction Coefficient");
}

TEST_F(StudyTest, KnowsWhatAnEntryBelongsTo) {
  using Kind = Effect::Kind;
  using Target = Effect::Target;
  const scene::Scene scene = study(parameter("mu", "Values/mu", "{0.2}")).scene;
  const auto expect = [&](const std::string& entry, Kind kind, Target target, const std::string& name) {
    const Effect effect = effectOf(entry, scene);
    EXPECT_EQ(effect.kind, kind) << entry;
    EXPECT_EQ(effect.target, target) << entry;
    EXPECT_EQ(effect.name, name) << entry;
    EXPECT_EQ(effect.entry, entry);
  };
  expect("Interfaces/seal/Law/Gap", Kind::localStage, Target::law, "seal");
  expect("Interfaces/seal/Law/Constants/k", Kind::localStage, Target::law, "seal");
  expect("Boundaries/pressed/Law/Pressure", Kind::loads, Target::law, "pressed");
  expect("Interfaces/seal/Side 1", Kind::operators, Target::other, "");
  expect("Histories/ramp/Values", Kind::operators, Target::history, "ramp");  // a part has a body force
  expect("Parts/upper/Body Force/Z", Kind::operators, Target::part, "upper");
  expect("Materials/steel/Young's Modulus", Kind::operators, Target::material, "steel");
  expect("Steps/wait/Duration", Kind::operators, Target::step, "wait");
  expect("Solver/Maximum Iterations", Kind::operators, Target::other, "");
}

TEST_F(StudyTest, LawsChangeByTheirOwnEntriesAndByHistories) {
  const scene::Scene scene = study(parameter("mu", "Values/mu", "{0.2}")).scene;
  EXPECT_TRUE(effectOf("Interfaces/seal/Law/Gap", scene).changesLawOf("seal"));
  EXPECT_FALSE(effectOf("Interfaces/seal/Law/Gap", scene).changesLawOf("sea"));
  EXPECT_FALSE(effectOf("Interfaces/seal/Law/Gap", scene).changesLawOf("pressed"));
  EXPECT_TRUE(effectOf("Histories/ramp/Values", scene).changesLawOf("pressed"));
  EXPECT_FALSE(effectOf("Parts/seal/Body Force/Z", scene).changesLawOf("seal"));
}

TEST_F(StudyTest, MakesTheSceneOfAConfiguration) {
  const Study found =
      study(parameter("mu", "Values/mu", "{0.2, 0.4}") + parameter("p", "Boundaries/pressed/Law/Pressure", "{5, -1}"));
  ASSERT_EQ(found.configurations.size(), 4u);
  const scene::Scene scene = found.sceneFor(found.configurations[3].values, laws);
  EXPECT_EQ(scene.input.lists("Interfaces")[0].list("Law").number("Friction Coefficient"), 0.4);
  EXPECT_EQ(scene.input.lists("Boundaries")[1].list("Law").number("Pressure"), -1.0);
  try {
    found.sceneFor({-0.5, 1.0}, laws);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(std::string(error.what()),
              directory +
                  "/scene.xml:41: Interfaces / seal / Law / Friction Coefficient: $mu = -0.5 is out of range.\n"
                  "  Allowed: at least 0 [-].");
  }
}

TEST_F(StudyTest, RefusesANumberThatTwoParametersSetByTwoNames) {
  const std::string value = parameter("mu", "Values/mu", "{0.2, 0.4}"),
                    own = parameter("own", "Interfaces/seal/Law/Friction Coefficient", "{0.1, 0.3}");
  for (const auto& [parameters, first] : {std::pair{value + own, "mu"}, std::pair{own + value, "own"}}) {
    try {
      study(parameters);
      FAIL();
    } catch (const base::Error& error) {
      const std::string text =
          std::string("\"Interfaces/seal/Law/Friction Coefficient\" is set by \"") + first + "\" already.";
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  }
}

TEST_F(StudyTest, ChangesReachStudyAndScene) {
  const Study found = study(parameter("mu", "Values/mu", "{0.2, 0.4}"),
                            {"Parameters/mu/Values={0.1}", "Accuracy=0.02", "Scene/Solver/Maximum Iterations=7"});
  EXPECT_EQ(found.configurations.size(), 1u);
  EXPECT_EQ(found.scene.input.list("Solver").number("Accuracy"), 0.02);
  EXPECT_EQ(found.scene.input.list("Solver").integer("Maximum Iterations"), 7);
}

TEST_F(StudyTest, GroupsByOperatorsAlone) {
  const std::string mu = parameter("mu", "Values/mu", "{0.2, 0.4}");
  EXPECT_EQ(groupsOf(study(mu)).size(), 1u);
  const auto groups = groupsOf(study(mu + parameter("E", "Materials/steel/Young's Modulus", "{1000, 2000, 3000}")));
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[1].size(), 2u);
  EXPECT_EQ(groups[1][0].id, 2);
  EXPECT_EQ(groups[1][1].id, 5);
}

TEST_F(StudyTest, PointsMayComeFromATable) {
  std::ofstream(directory + "/points.csv") << "\xEF\xBB\xBF p , \"mu\"\r\n\r\n 5 , 0.25\r\n6,+1e-1\r\n";
  const Study found =
      study(parameter("mu", "Values/mu", "{0.2, 0.4}") + parameter("p", "Boundaries/pressed/Law/Pressure", "{5}"), {},
            directory + "/points.csv");
  ASSERT_EQ(found.configurations.size(), 2u);
  EXPECT_EQ(found.configurations[0].values, (std::vector<double>{0.25, 5.0}));
  EXPECT_EQ(found.configurations[1].values, (std::vector<double>{0.1, 6.0}));
}

TEST_F(StudyTest, IdentityNamesWhatMatters) {
  const std::string mu = parameter("mu", "Values/mu", "{0.2}");
  const results::Identity identity = identityOf(study(mu));
  EXPECT_EQ(identityOf(study(mu)), identity);
  EXPECT_EQ(identityOf(study(mu, {"Title=Other", "Scene/Title=Other"})), identity);
  EXPECT_NE(identityOf(study(mu, {"Accuracy=0.01"})), identity);
  EXPECT_NE(identityOf(study(mu, {"Scene/Steps/wait/Duration=3"})), identity);
}

}  // namespace
}  // namespace harmos::study
