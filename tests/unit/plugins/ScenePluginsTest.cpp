#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include <harmos/base/Error.hpp>
#include <harmos/study/StudyReader.hpp>
#include <harmos/study/detail/StudyIdentity.hpp>

#include "../scene/Sample.hpp"

namespace harmos::study {
namespace {

namespace fs = std::filesystem;

/// A scene and a study beside a copy of the plugin, which the scene names with a path relative to itself.
class ScenePlugins : public ::testing::Test {
 protected:
  ScenePlugins() {
    fs::create_directories(directory + "/laws");
    fs::copy_file(PLUGIN_FOLDER "/DampedGlue.so", directory + "/laws/glue.so");
  }
  ~ScenePlugins() override { fs::remove_all(directory); }

  std::string sceneWith(const std::string& plugins) const {
    std::string text = scene::sampleScene();
    const std::string friction = "\"Coulomb Friction\"/>", mu = "Friction Coefficient\" type=\"double\" value=\"0.3";
    text.replace(text.find(friction), friction.size(), "\"Damped Glue\"/>");
    text.replace(text.find(mu), mu.size(), "Stiffness\" type=\"double\" value=\"5");
    text.insert(text.find("  <ParameterList name=\"Mesh\">"),
                "  <Parameter name=\"Plugins\" type=\"Array(string)\" value=\"" + plugins + "\"/>\n");
    std::string path = directory + "/scene.xml";
    std::ofstream(path) << text;
    return path;
  }

  std::string refusalOf(const std::string& plugins, const std::vector<std::string>& overrides = {}) const {
    try {
      scene::readScene(sceneWith(plugins), overrides, laws::builtInLaws());
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ExitCode::input);
      return error.what();
    }
    return "no error";
  }

  Study studyOf(const std::string& entry) const {
    sceneWith("{laws/glue.so}");
    const std::string path = directory + "/study.xml";
    std::ofstream(path) << "<ParameterList name=\"Harmos Study\">\n"
                           "  <Parameter name=\"Scene\" type=\"string\" value=\"scene.xml\"/>\n"
                           "  <ParameterList name=\"Parameters\"><ParameterList name=\"loss\">\n"
                           "    <Parameter name=\"Entry\" type=\"string\" value=\"" +
                               entry +
                               "\"/>\n    <Parameter name=\"Values\" type=\"Array(double)\" value=\"{0.1, 0.2}\"/>\n"
                               "  </ParameterList></ParameterList>\n</ParameterList>\n";
    return readStudy(path, {"Scene/Interfaces/seal/Law/Stiffness=7"}, "", laws::builtInLaws());
  }

  const std::string directory = "scene_plugins_test." + std::to_string(::getpid());
};

bool has(const std::string& message, const std::string& words) {
  return message.find(words) != std::string::npos;
}

TEST_F(ScenePlugins, GiveTheirLawsToTheScene) {
  const scene::Scene scene = scene::readScene(sceneWith("{laws/glue.so}"), {}, laws::builtInLaws());
  EXPECT_STREQ(scene.laws.at("seal")->name(), "Damped Glue");
  const auto files = scene::inputFiles(scene);
  EXPECT_EQ(files.back(), directory + "/laws/glue.so");
}

TEST_F(ScenePlugins, MayBeOverridden) {
  const scene::Scene scene =
      scene::readScene(sceneWith("{nowhere.so}"), {"Plugins = {laws/glue.so}"}, laws::builtInLaws());
  EXPECT_STREQ(scene.laws.at("seal")->name(), "Damped Glue");
}

TEST_F(ScenePlugins, AreCheckedAllAtOnceAndBeforeTheRest) {
  const std::string message = refusalOf("{nowhere.so, laws/glue.so, ./laws/glue.so}");
  EXPECT_TRUE(has(message, "scene.xml:2: Harmos / Plugins: \"" + directory + "/nowhere.so\" does not exist"))
      << message;
  EXPECT_TRUE(has(message, "laws/glue.so\" is named twice")) << message;
  EXPECT_TRUE(has(message, "2 errors; nothing was run.")) << message;
}

TEST_F(ScenePlugins, AreReportedByTheCheckWhenTheyAreNoPaths) {
  const std::string message = refusalOf("{laws/glue.so", {"Solver/Acuracy=1"});
  EXPECT_TRUE(has(message, "scene.xml:2: Plugins: ")) << message;
  EXPECT_TRUE(has(message, "Acuracy")) << message;
}

TEST_F(ScenePlugins, ReachStudies) {
  const Study study = studyOf("Interfaces/seal/Law/Loss");
  ASSERT_EQ(study.configurations.size(), 2U);
  const scene::Scene scene = study.sceneFor(study.configurations[1].values, laws::builtInLaws());
  EXPECT_DOUBLE_EQ(scene.input.lists("Interfaces")[0].list("Law").number("Loss"), 0.2);
  EXPECT_DOUBLE_EQ(scene.input.lists("Interfaces")[0].list("Law").number("Stiffness"), 7.0);
  EXPECT_THROW(studyOf("Interfaces/seal/Law/Gain"), base::Error);
}

// A journal is not continued with another plugin.
TEST_F(ScenePlugins, BelongToTheIdentityOfAStudy) {
  const auto before = identityOf(studyOf("Interfaces/seal/Law/Loss"));
  const Study study = studyOf("Interfaces/seal/Law/Loss");
  std::ofstream(directory + "/laws/glue.so", std::ios::app) << "newer";
  EXPECT_NE(before, identityOf(study));
}

}  // namespace
}  // namespace harmos::study
