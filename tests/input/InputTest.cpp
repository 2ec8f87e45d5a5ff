#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <Tpetra_Core.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/scene/Scene.hpp>
#include <harmos/study/StudyReader.hpp>

namespace harmos {
namespace {

std::vector<std::string> cases() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(".")) {
    if (entry.path().extension() == ".xml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string messageOf(const std::string& scenePath) {
  try {
    if (study::isStudyFile(scenePath)) {
      study::readStudy(scenePath, {}, "", laws::builtInLaws());
      return "no error\n";
    }
    const scene::Scene scene = scene::readScene(scenePath, {}, laws::builtInLaws());
    base::Timers timers;
    scene::makeProblem(scene, *Tpetra::getDefaultComm(), timers);
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return std::string(error.what()) + "\n";
  }
  return "no error\n";
}

class Input : public ::testing::TestWithParam<std::string> {};

TEST_P(Input, IsRefusedWithItsMessage) {
  std::ifstream file(GetParam() + ".txt");
  std::stringstream expected;
  expected << file.rdbuf();
  EXPECT_EQ(messageOf(GetParam() + ".xml"), expected.str());
}

INSTANTIATE_TEST_SUITE_P(Cases, Input, ::testing::ValuesIn(cases()), [](const auto& test) { return test.param; });

}  // namespace
}  // namespace harmos
