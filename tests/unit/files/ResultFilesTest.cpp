#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/files/HistoryFile.hpp>
#include <harmos/files/ResultFiles.hpp>
#include <harmos/files/RunRecord.hpp>

#include "TwoBoxes.hpp"

using namespace harmos::files;

namespace {

std::string contentOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST(ResultFiles, AreNamedAfterTheScene) {
  const ResultFiles files("out", "xml/bolted_joint.xml");
  EXPECT_EQ(files.parts, "out/bolted_joint.e");
  EXPECT_EQ(files.interfaces, "out/bolted_joint_interfaces.e");
  EXPECT_EQ(files.history, "out/bolted_joint_history.csv");
  EXPECT_EQ(files.effectiveInput, "out/bolted_joint_effective.xml");
  EXPECT_EQ(files.record, "out/bolted_joint_result.json");
}

TEST(ResultFiles, OldOnesAreRemovedAndOthersStay) {
  const auto directory = temporaryFile("directory");
  const ResultFiles files(directory, "scene.xml");
  files.removeOld();  // creates the directory
  const std::string other = directory + "/scene_notes.txt";
  for (const auto& path : files.all()) std::ofstream(path) << "old";
  std::ofstream(other) << "mine";
  files.removeOld();
  for (const auto& path : files.all()) EXPECT_FALSE(std::filesystem::exists(path)) << path;
  EXPECT_TRUE(std::filesystem::exists(other));
}

TEST(ResultFiles, ADirectoryThatCannotBeMadeIsNamed) {
  const auto file = temporaryFile("file");
  std::ofstream(file) << "in the way";
  try {
    ResultFiles(file + "/below", "scene.xml").removeOld();
    FAIL() << "made a directory below a file";
  } catch (const harmos::base::Error& error) {
    EXPECT_NE(std::string(error.what()).find(file), std::string::npos);
  }
}

TEST(ResultFiles, HistoryHasOneRowPerStep) {
  const auto path = temporaryFile("history.csv");
  writeHistory(path, {{"u_load", "force, total"}, {0.0, 1.0}, {{0.0, 0.0}, {0.1, -3.0}}});
  EXPECT_EQ(contentOf(path), "step,time,u_load,\"force, total\"\n0,0,0,0\n1,1,0.1,-3\n");
}

TEST(ResultFiles, RecordIsJsonAlsoWithoutNumbers) {
  const auto path = temporaryFile("result.json");
  RunRecord record;
  record.scene = "a \"quoted\" \xff name.xml";
  record.status = "not converged";
  record.responseErrors = {{"u_load", 2e-3}};
  record.phases = {{"factor", 0.5, 0.25, 1}};
  writeRunRecord(path, record);
  const auto text = contentOf(path);
  EXPECT_NE(text.find("\"status\": \"not converged\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"error_estimate\": null"), std::string::npos) << text;
  EXPECT_NE(text.find("\"u_load\": 0.002"), std::string::npos) << text;
  EXPECT_NE(text.find("\"cpu_seconds\": 0.25"), std::string::npos) << text;
}
