#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <harmos/base/Error.hpp>
#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/HistoryFile.hpp>
#include <harmos/files/OutputGuard.hpp>
#include <harmos/files/PendingResults.hpp>
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

TEST(PendingResults, OldOnesStayUntilNewOnesAreComplete) {
  const auto directory = temporaryFile("directory");
  const ResultFiles files(directory, "scene.xml");
  const auto writeAll = [](const ResultFiles& to, const std::string& content) {
    for (const auto& path : to.all()) std::ofstream(path) << content;
  };
  {
    const PendingResults pending(files);  // creates the directory
    writeAll(pending.files(), "old");
    pending.commit();
  }
  const auto isWrittenByItself = [&](const std::string& path) {
    return path == files.record || path == files.derivatives;  // when the others are complete
  };
  for (const auto& path : {files.record, files.derivatives}) std::ofstream(path) << "old";
  const std::string other = directory + "/scene_notes.txt";
  std::ofstream(other) << "mine";
  {
    const PendingResults pending(files);
    writeAll(pending.files(), "new");
    for (const auto& path : files.all()) EXPECT_EQ(contentOf(path), "old") << path;
  }  // without commit()
  for (const auto& path : files.all()) EXPECT_EQ(contentOf(path), "old") << path;
  {
    const PendingResults pending(files);
    writeAll(pending.files(), "new");
    pending.commit();
  }
  for (const auto& path : files.all()) EXPECT_EQ(contentOf(path), isWrittenByItself(path) ? "old" : "new") << path;
  {
    const PendingResults pending(files);
    for (const auto& path : {pending.files().history, pending.files().effectiveInput}) std::ofstream(path) << "newest";
    pending.commit(false);
  }
  EXPECT_EQ(contentOf(files.history), "newest");
  EXPECT_FALSE(std::filesystem::exists(files.parts));
  EXPECT_FALSE(std::filesystem::exists(files.interfaces));
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) count += entry.exists() ? 1 : 0;
  EXPECT_EQ(count, 5) << "something is left over";
}

TEST(PendingResults, WhatKilledRunsLeftIsRemovedButNotThatOfLivingOnes) {
  const auto directory = temporaryFile("directory");
  const ResultFiles files(directory, "scene.xml");
  std::filesystem::create_directories(directory + "/scene.partial.1234");
  std::filesystem::create_directories(directory + "/scene.partial.5678");
  std::filesystem::create_directories(directory + "/scene2.partial.1234");
  const int living = ::open((directory + "/scene.partial.5678").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(living, LOCK_EX), 0);
  { const PendingResults pending(files); }
  EXPECT_FALSE(std::filesystem::exists(directory + "/scene.partial.1234"));
  EXPECT_TRUE(std::filesystem::exists(directory + "/scene.partial.5678"));
  EXPECT_TRUE(std::filesystem::exists(directory + "/scene2.partial.1234"));
  ::close(living);
}

TEST(PendingResults, AFolderThatIsRemovedMeanwhileIsNotMadeAnew) {
  const auto directory = temporaryFile("directory");
  const PendingResults pending(ResultFiles(directory, "scene.xml"));
  std::filesystem::remove_all(directory);
  EXPECT_THROW(replaceFile(pending.files().history, "t"), harmos::base::Error);
  EXPECT_THROW(pending.commit(), harmos::base::Error);
  EXPECT_FALSE(std::filesystem::exists(directory));
}

TEST(PendingResults, ADirectoryThatCannotBeMadeIsNamed) {
  const auto file = temporaryFile("file");
  std::ofstream(file) << "in the way";
  try {
    const PendingResults pending(ResultFiles(file + "/below", "scene.xml"));
    FAIL() << "made a directory below a file";
  } catch (const harmos::base::Error& error) {
    EXPECT_NE(std::string(error.what()).find(file), std::string::npos);
  }
}

TEST(Unfinished, IsRemovedWhenAProcessIsEnded) {
  const auto directory = temporaryFile("directory");
  std::filesystem::create_directories(directory);
  std::ofstream(directory + "/kept") << "old";
  const LastWords words(directory + "/record", "interrupted");
  { const LastWords forgotten(directory + "/other", "interrupted"); }
  AtomicFile file(directory + "/kept");
  std::ofstream(file.temporaryPath()) << "new";
  removeUnfinished();
  EXPECT_FALSE(std::filesystem::exists(file.temporaryPath()));
  EXPECT_EQ(contentOf(directory + "/kept"), "old");
  EXPECT_EQ(contentOf(directory + "/record"), "interrupted");
  EXPECT_FALSE(std::filesystem::exists(directory + "/other"));
}

TEST(OutputGuard, RefusesAnInputUnderAnyName) {
  const auto directory = temporaryFile("directory");
  std::filesystem::create_directories(directory + "/below");
  const std::string input = directory + "/mesh.e";
  std::ofstream(input) << "mesh";
  std::filesystem::create_symlink(input, directory + "/symbolic.e");
  std::filesystem::create_hard_link(input, directory + "/hard.e");
  std::ofstream(directory + "/copy.e") << "mesh";
  EXPECT_NO_THROW(demandDistinct({input}, {directory + "/copy.e", directory + "/none.e", ""}));
  for (const std::string name : {"/mesh.e", "/./mesh.e", "/below/../mesh.e", "/symbolic.e", "/hard.e"}) {
    try {
      demandDistinct({directory + "/copy.e", input}, {directory + "/none.e", directory + name});
      ADD_FAILURE() << name;
    } catch (const harmos::base::Error& error) {
      EXPECT_EQ(error.code(), harmos::base::ExitCode::input);
      EXPECT_NE(std::string(error.what()).find(directory + name), std::string::npos) << error.what();
    }
  }
}

TEST(OutputGuard, RefusesWhatIsInTheWay) {
  const auto directory = temporaryFile("directory");
  std::filesystem::create_directories(directory + "/below");
  std::ofstream(directory + "/file") << "old";
  std::filesystem::create_symlink("nowhere", directory + "/dangling");
  EXPECT_NO_THROW(demandWritable({directory + "/file", directory + "/new/folder/file", "new"}));
  EXPECT_NO_THROW(demandFolder(directory));
  EXPECT_NO_THROW(demandFolder(directory + "/new/folder/"));
  EXPECT_FALSE(std::filesystem::exists(directory + "/new"));
  const auto refused = [](const std::string& text, const std::function<void()>& demand) {
    try {
      demand();
      ADD_FAILURE() << text;
    } catch (const harmos::base::Error& error) {
      EXPECT_EQ(error.code(), harmos::base::ExitCode::input);
      EXPECT_EQ(std::string(error.what()),
                text + "\n  Write into another folder or under another name (--output). Nothing was written.");
    }
  };
  const auto file = [&](const std::string& output, const std::string& reason) {
    refused("The result " + output + " cannot be written: " + reason, [&] { demandWritable({output}); });
  };
  const auto below = [&](const std::string& folder, const std::string& reason) {
    const std::string text = "No result can be written into " + folder + ": " + reason;
    refused(text, [&] { demandWritable({folder + "/new", folder + "/other"}); });
    refused(text, [&] { demandFolder(folder); });
  };
  const std::string tooLong = directory + "/" + std::string(250, 'x');
  file(directory + "/below", "it is a folder.");
  file(directory + "/below/", "it names a folder.");
  file("/dev/null", "it is no file, but a device or the like.");
  file(tooLong, "its name is too long.");
  below(directory + "/file", directory + "/file is no folder.");
  below(directory + "/file/new", directory + "/file is no folder.");
  below(directory + "/dangling", directory + "/dangling is a link to what is not there.");
  refused("No result can be written into " + tooLong + "xxxxxx: its name is too long.",
          [&] { demandFolder(tooLong + "xxxxxx"); });
}

TEST(ResultFiles, HistoryHasOneRowPerStep) {
  const auto path = temporaryFile("history.csv");
  writeHistory(path, {{"u_load", "force, total"}, {0.0, 1.0}, {{0.0, 0.0}, {0.1, -3.0}}});
  EXPECT_EQ(contentOf(path), "step,time,u_load,\"force, total\"\n0,0,0,0\n1,1,0.1,-3\n");
}

TEST(ResultFiles, HistoryHasErrorsOfTheMeshInItsLastRow) {
  const auto path = temporaryFile("history.csv");
  const std::vector<harmos::results::MeshErrorRecord> errors{{"a, b", -0.2, 0.125, "uncertain", {}}};
  writeHistory(path, {{"u", "a, b"}, {0.0, 1.0}, {{0.0, 0.0}, {0.1, -3.0}}, errors});
  EXPECT_EQ(contentOf(path), "step,time,u,\"a, b\",\"a, b_mesh_error\"\n0,0,0,0,nan\n1,1,0.1,-3,0.125\n");
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
  EXPECT_NE(text.find("\"exit_code\": null"), std::string::npos) << text;
  record.exitCode = 3;
  writeRunRecord(path, record);
  EXPECT_NE(contentOf(path).find("\"exit_code\": 3"), std::string::npos) << contentOf(path);
}
