#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <harmos/base/Error.hpp>
#include <harmos/plugins/LoadPlugin.hpp>
#include <harmos/plugins/PluginDescription.hpp>

namespace harmos::plugins {
namespace {

std::string pathOf(const std::string& plugin) {
  return PLUGIN_FOLDER "/" + plugin + ".so";
}

/// What is said when a plugin is refused; what the registry holds must not change.
std::string refusalOf(const std::string& path) {
  laws::LawRegistry laws = laws::builtInLaws();
  const std::size_t before = laws.forms().size();
  try {
    loadPlugin(path, laws);
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    EXPECT_EQ(laws.forms().size(), before);
    return error.what();
  }
  return "loaded";
}

void expectRefused(const std::string& plugin, const std::vector<std::string>& words) {
  const std::string message = refusalOf(pathOf(plugin));
  EXPECT_EQ(message.rfind("\"" + pathOf(plugin) + "\"", 0), 0U) << message;
  for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << "\n" << message;
}

TEST(LoadPlugin, AddsLawsThatWorkAsThoseOfHarmosDo) {
  laws::LawRegistry laws = laws::builtInLaws();
  const std::size_t before = laws.forms().size();
  loadPlugin(pathOf("DampedGlue"), laws);
  ASSERT_EQ(laws.forms().size(), before + 1);
  EXPECT_EQ(laws.forms().back().name(), "Damped Glue");
  input::Parameters parameters("law");
  parameters.set("Type", std::string("Damped Glue")).set("Stiffness", 2.0).set("Loss", 0.5);
  const auto law = laws.create(parameters);
  EXPECT_EQ(law->historySize(), 1);
  const laws::LocalLine line{{3.0, 0.0, 0.0}, 0.25};
  const double gap = 0.0, old = 1.0;
  double now = 0.0;
  laws::LocalState state;
  laws::NodeArrays pair;
  pair.count = 1;
  pair.line = &line;
  pair.gap = &gap;
  pair.oldHistory = &old;
  pair.newHistory = &now;
  pair.state = &state;
  law->solve(0, pair);
  EXPECT_DOUBLE_EQ(state.traction[0], 3.0 / 1.25);
  EXPECT_EQ(now, 2.0);
}

// An exception passes from the plugin's code to ours with its type.
TEST(LoadPlugin, HandsOnWhatALawThrows) {
  laws::LawRegistry laws = laws::builtInLaws();
  loadPlugin(pathOf("DampedGlue"), laws);
  input::Parameters parameters("law");
  parameters.set("Type", std::string("Damped Glue")).set("Stiffness", 2.0).set("Loss", 1.0);
  try {
    laws.create(parameters);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    EXPECT_NE(std::string(error.what()).find("nothing would be left"), std::string::npos);
  }
}

// The loader would end the process, or wait.
TEST(LoadPlugin, RefusesLibrariesThatWereCutShortAndPipes) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("harmos_cut_plugins_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::uintmax_t size = fs::file_size(pathOf("DampedGlue"));
  for (const double share : {0.02, 0.3, 0.6, 0.9, 0.999}) {
    const fs::path cut = folder / ("cut_" + std::to_string(share) + ".so");
    fs::copy_file(pathOf("DampedGlue"), cut);
    fs::resize_file(cut, static_cast<std::uintmax_t>(share * static_cast<double>(size)));
    EXPECT_NE(refusalOf(cut.string()).find("cut short"), std::string::npos) << share;
  }
  const fs::path pipe = folder / "pipe.so";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_NE(refusalOf(pipe.string()).find("is no file"), std::string::npos);
  fs::remove_all(folder);
}

TEST(LoadPlugin, RefusesWhatIsNotThere) {
  EXPECT_NE(refusalOf("no_such.so").find("\"no_such.so\" does not exist"), std::string::npos);
  EXPECT_NE(refusalOf(PLUGIN_FOLDER).find("cannot be loaded"), std::string::npos);
}

TEST(LoadPlugin, RefusesWhatIsNoLibrary) {
  const std::string path = "not_a_library.so";
  std::ofstream(path) << "text";
  EXPECT_NE(refusalOf(path).find("\"not_a_library.so\" cannot be loaded: "), std::string::npos);
  std::filesystem::remove(path);
}

TEST(LoadPlugin, RefusesOtherLibraries) {
  expectRefused("NoPlugin", {"no Harmos plugin", "HARMOS_LAW_PLUGIN"});
}

TEST(LoadPlugin, RefusesOtherInterfaces) {
  expectRefused("OtherVersion", {"built against Harmos 0.0.9, but this is " HARMOS_INTERFACE_VERSION, "anew"});
  expectRefused("OtherCompiler", {"\"gnu++ 1002, strings 0\"", "Build the plugin with the compiler"});
  expectRefused("OtherHeaders", {"other headers", "0123456789abcdef", "anew"});
  expectRefused("OtherDescription", {"describes itself in another way", "anew"});
}

TEST(LoadPlugin, RefusesNamesThatAreTaken) {
  expectRefused("TakenName", {"\"Linear Elastic\" is registered already", "unique"});
  laws::LawRegistry laws = laws::builtInLaws();
  loadPlugin(pathOf("DampedGlue"), laws);
  EXPECT_THROW(loadPlugin(pathOf("DampedGlue"), laws), base::Error);
}

TEST(LoadPlugin, SaysWhatThePluginThrows) {
  expectRefused("Throws", {"cannot register its laws: the table of constants is missing"});
}

}  // namespace
}  // namespace harmos::plugins
