#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <hdf5.h>
#include <sys/wait.h>
#include <unistd.h>

#include <harmos/base/Error.hpp>
#include <harmos/files/StoredSurfaceData.hpp>
#include <harmos/files/StudyWriter.hpp>
#include <harmos/files/detail/StudyFile.hpp>
#include <harmos/files/detail/StudyTables.hpp>

namespace harmos::files {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

class StudyFilesTest : public ::testing::Test {
 protected:
  StudyFilesTest() {
    std::filesystem::remove_all(directory);
    std::filesystem::create_directory(directory);
    description.name = "joint";
    description.title = "Title";
    description.parameters = {{"mu", "-", "", {"Values/mu"}, "local stage"}, {"twice", "", "2*mu", {}, ""}};
    description.configurations = {{1, {0.1, 0.2}}, {2, {0.3, 0.6}}, {3, {1.0 / 3.0, 2.0 / 3.0}}};
    description.curves = {"reaction", "bolt"};
    description.times = {1.0, 2.0};
    results::ScalarResponse largest;
    largest.name = "F_max";
    description.responses = {largest};
    description.identity = {{"Scene / Values / mu", "0.3"}, {"Study / Title", "Title"}};
  }
  ~StudyFilesTest() override { std::filesystem::remove_all(directory); }

  results::ConfigurationResult solved(int id) const {
    results::ConfigurationResult result;
    result.id = id;
    result.status = results::Status::calibrated;
    result.reason = "because \"of\" this,\nor that";
    result.curves = {{1.0 / 3.0, 7.25}, {2.0, -1e-300}};
    result.curveErrors = {1e-3, none};
    result.errorEstimate = 0.1;
    result.iterations = 3;
    result.linearStages = 4;
    result.starts = {1, 7};
    result.cpuSeconds = 0.25;
    result.meshErrors = {{"bolt", -0.5, 0.2, "uncertain", {"head", "shank"}}};
    result.evidence = {results::Indicators{1.0 / 7.0, 0.25, {1e-300, 2.0}}, results::Ratios{0.3, {1.0, 0.0}},
                       2.0 / 3.0};
    return result;
  }

  std::string messageOf(const std::function<void()>& action) const {
    try {
      action();
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ExitCode::input);
      return error.what();
    }
    return "accepted";
  }

  static std::string contentOf(const std::string& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  const std::string directory = "study_files_test." + std::to_string(::getpid());
  const StudyFiles files{directory, "somewhere/joint.xml"};
  results::StudyDescription description;
};

TEST_F(StudyFilesTest, JournalKeepsResultsExactly) {
  { StudyJournal(files.journal, description.identity, false).append(solved(2)); }
  const StudyJournal again(files.journal, description.identity, false);
  ASSERT_EQ(again.results().size(), 1u);
  const results::ConfigurationResult& result = again.results()[0];
  EXPECT_EQ(resultToJson(result), resultToJson(solved(2)));
  EXPECT_EQ(result.curves, solved(2).curves);
  EXPECT_EQ(result.reason, solved(2).reason);
  EXPECT_TRUE(std::isnan(result.curveErrors[1]));
  EXPECT_EQ(result.starts, solved(2).starts);
  ASSERT_EQ(result.meshErrors.size(), 1u);
  EXPECT_EQ(result.meshErrors[0].change, -0.5);
  EXPECT_EQ(result.meshErrors[0].parts, (std::vector<std::string>{"head", "shank"}));
  EXPECT_EQ(result.evidence.indicators->force, 1.0 / 7.0);
  EXPECT_EQ(result.evidence.indicators->balance, 0.25);
  EXPECT_EQ(result.evidence.indicators->responses, (std::vector<double>{1e-300, 2.0}));
  EXPECT_EQ(result.evidence.ratios->force, 0.3);
  EXPECT_EQ(result.evidence.ratios->responses, (std::vector<double>{1.0, 0.0}));
  EXPECT_EQ(result.evidence.audit, 2.0 / 3.0);
  EXPECT_EQ(again.damaged(), 0);
}

// As results are that no indicators were accepted for, and those of files of before.
TEST_F(StudyFilesTest, ResultsMayHaveNoEvidence) {
  results::ConfigurationResult plain = solved(1);
  plain.evidence = {};
  const results::ConfigurationResult again = resultFromJson(resultToJson(plain));
  EXPECT_FALSE(again.evidence.indicators || again.evidence.ratios || again.evidence.audit);
}

// Whatever prefix of the file a sudden end leaves: all complete lines are read and writing goes on after them.
TEST_F(StudyFilesTest, JournalSurvivesBeingCutAnywhere) {
  {
    StudyJournal journal(files.journal, description.identity, false);
    journal.append(solved(1));
    journal.append(solved(2));
  }
  const std::string whole = contentOf(files.journal);
  std::size_t most = 0;
  for (std::size_t length = 0; length < whole.size() + 41; length += 41) {
    std::ofstream(files.journal, std::ios::binary) << whole.substr(0, length);
    {
      StudyJournal journal(files.journal, description.identity, false);
      EXPECT_GE(journal.results().size(), most);
      most = journal.results().size();
      EXPECT_EQ(journal.damaged(), 0);
      journal.append(solved(3));
    }
    EXPECT_EQ(StudyJournal(files.journal, description.identity, false).results().size(), most + 1) << length;
  }
  EXPECT_EQ(most, 2u);
}

TEST_F(StudyFilesTest, AJournalThatWasRemovedIsMissed) {
  StudyJournal journal(files.journal, description.identity, false);
  journal.append(solved(1));
  std::filesystem::remove_all(directory);
  EXPECT_THROW(journal.append(solved(2)), base::Error);
}

TEST_F(StudyFilesTest, JournalPassesOverDamage) {
  {
    StudyJournal journal(files.journal, description.identity, false);
    journal.append(solved(1));
    journal.append(solved(2));
  }
  std::string text = contentOf(files.journal);
  text[text.find("\"id\":1") + 5] = '9';
  std::ofstream(files.journal, std::ios::binary) << text;
  const StudyJournal journal(files.journal, description.identity, false);
  ASSERT_EQ(journal.results().size(), 1u);
  EXPECT_EQ(journal.results()[0].id, 2);
  EXPECT_EQ(journal.damaged(), 1);
}

TEST_F(StudyFilesTest, JournalRefusesAnotherStudy) {
  { StudyJournal(files.journal, description.identity, false).append(solved(1)); }
  const results::Identity changed = {{"Scene / Values / mu", "0.4"}, {"Study / Accuracy", "0.01"}};
  EXPECT_EQ(messageOf([&] { StudyJournal(files.journal, changed, false); }),
            files.journal +
                " belongs to a study with another input:\n"
                "  Scene / Values / mu = 0.4, was 0.3\n"
                "  Study / Accuracy = 0.01, which was not there before\n"
                "  Study / Title is not there any more, was Title\n"
                "  Undo the change, write into another folder (--output DIR), or start over with --restart.\n"
                "  Nothing was run.");
  EXPECT_TRUE(StudyJournal(files.journal, changed, true).results().empty());
}

TEST_F(StudyFilesTest, JournalRefusesEntriesInAnotherOrder) {
  { StudyJournal(files.journal, description.identity, false).append(solved(1)); }
  const results::Identity turned(description.identity.rbegin(), description.identity.rend());
  const std::string message = messageOf([&] { StudyJournal(files.journal, turned, false); });
  EXPECT_NE(message.find("  Study / Title stands before Scene / Values / mu, was behind it\n"), std::string::npos)
      << message;
}

TEST_F(StudyFilesTest, JournalRefusesWhatIsNoJournal) {
  std::filesystem::create_directories(directory);
  std::ofstream(files.journal) << "something else\n";
  EXPECT_EQ(messageOf([&] { StudyJournal(files.journal, description.identity, false); }),
            files.journal + " is not the journal of a study.\n  Remove it, or write into another folder.");
  EXPECT_EQ(contentOf(files.journal), "something else\n");
}

TEST_F(StudyFilesTest, SecondProcessIsRefused) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const ::pid_t child = ::fork();
  if (child == 0) {
    const StudyJournal journal(files.journal, description.identity, false);
    if (::write(ready[1], "x", 1) == 1) ::pause();
    ::_exit(0);
  }
  char letter = 0;
  ASSERT_EQ(::read(ready[0], &letter, 1), 1);
  const std::string message = messageOf([&] { StudyJournal(files.journal, description.identity, false); });
  EXPECT_EQ(message.find(files.journal + " is in use by process " + std::to_string(child) + " on "), 0u) << message;
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(messageOf([&] { StudyJournal(files.journal, description.identity, false); }), "accepted");
}

TEST_F(StudyFilesTest, TablesHaveARowPerConfiguration) {
  results::StudyResults results(description);
  results.set(solved(2));
  results::ConfigurationResult failed;
  failed.id = 3;
  failed.errorEstimate = none;
  results.set(failed);
  writeStudyTable(files.table, results);
  EXPECT_EQ(contentOf(files.table),
            "id,mu,twice,status,iterations,error_estimate,start,F_max\n"
            "1,0.1,0.2,open,,,,\n"
            "2,0.3,0.6,calibrated,3,0.1,1,7.25\n"
            "3,0.3333333333333333,0.6666666666666666,failed,0,,0,\n");
  writeDakotaTable(files.dakota, results);
  EXPECT_EQ(contentOf(files.dakota),
            "%eval_id interface mu twice F_max\n"
            "1 NO_ID 0.1 0.2 nan\n"
            "2 NO_ID 0.3 0.6 7.25\n"
            "3 NO_ID 0.3333333333333333 0.6666666666666666 nan\n");
}

TEST_F(StudyFilesTest, RecoveryStandsInForFailures) {
  description.recovery = {-1.0};
  results::StudyResults results(description);
  results::ConfigurationResult failed;
  failed.id = 3;
  results.set(failed);
  EXPECT_EQ(results.responses(3), std::vector<double>{-1.0});
  EXPECT_TRUE(std::isnan(results.responses(2)[0]));
  results::ConfigurationResult reopened = solved(1);
  reopened.status = results::Status::reopened;
  results.set(reopened);
  EXPECT_TRUE(std::isnan(results.responses(1)[0]));
}

TEST_F(StudyFilesTest, Hdf5HoldsEverything) {
  results::StudyResults results(description);
  results.set(solved(2));
  writeStudyFile(files.file, results, "running");
  const hid_t file = H5Fopen(files.file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  double curve[3][2];
  const hid_t array = H5Dopen2(file, "/joint/curves/reaction", H5P_DEFAULT);
  ASSERT_GE(array, 0);
  ASSERT_GE(H5Dread(array, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, curve), 0);
  EXPECT_TRUE(std::isnan(curve[0][0]));
  EXPECT_EQ(curve[1][1], 7.25);
  H5Dclose(array);
  for (const auto& [name, expected] :
       {std::pair{"/joint/mesh_errors/bolt", 0.2}, std::pair{"/joint/mesh_changes/bolt", -0.5}}) {
    double errors[3];
    const hid_t ofMesh = H5Dopen2(file, name, H5P_DEFAULT);
    ASSERT_GE(ofMesh, 0);
    ASSERT_GE(H5Dread(ofMesh, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, errors), 0);
    EXPECT_TRUE(std::isnan(errors[0]));
    EXPECT_EQ(errors[1], expected);
    H5Dclose(ofMesh);
  }
  H5Fclose(file);
  // Equal results give equal files.
  const std::string before = contentOf(files.file);
  writeStudyFile(files.file, results, "running");
  EXPECT_EQ(contentOf(files.file), before);
}

TEST_F(StudyFilesTest, ResponseSurfacesAreMadeOfWhatIsSolved) {
  description.configurations.clear();
  for (int i = 0; i < 8; ++i) description.configurations.push_back({i + 1, {0.1 * i, 0.2 * i}});
  description.recovery = {-1.0};
  results::StudyResults results(description);
  for (int id = 1; id <= 7; ++id) {
    results::ConfigurationResult result = solved(id);
    result.curves[0] = {0.0, 3.0 * id};
    if (id == 4) result.status = results::Status::notConverged;
    results.set(result);
  }
  writeStudyFile(files.file, results, "complete");
  const results::SurfaceData data = readSurfaceData(files.file);
  EXPECT_EQ(data.parameters, std::vector<std::string>{"mu"});  // the other one is derived
  EXPECT_EQ(data.responses, std::vector<std::string>{"F_max"});
  EXPECT_EQ(data.points[2], std::vector<double>{0.2});
  EXPECT_EQ(data.values[0][2], 9.0);
  EXPECT_TRUE(std::isnan(data.values[0][3]));
  EXPECT_TRUE(std::isnan(data.values[0][7]));
  EXPECT_EQ(results::surfaceDataOf(results).points, data.points);
  const auto surrogate = data.surrogate(0);
  ASSERT_TRUE(surrogate.has_value());
  EXPECT_NEAR(surrogate->evaluate({0.3}).value, 12.0, 1e-4);
  EXPECT_FALSE(surrogate->evaluate({0.7}).isInside);
}

TEST_F(StudyFilesTest, WhatIsNoStudyIsRefused) {
  std::filesystem::create_directories(directory);
  std::ofstream(files.file) << "no HDF5";
  const std::string refusal = files.file +
                              " is no file of a study, or was damaged or changed since. Run the study again to restore "
                              "it.";
  const auto message = [&] { return messageOf([&] { readSurfaceData(files.file); }); };
  EXPECT_EQ(message(), refusal);
  std::filesystem::remove(files.file);
  EXPECT_EQ(message(), "Cannot read " + files.file + ": No such file or directory.");
  writeStudyFile(files.file, results::StudyResults(description), "complete");
  EXPECT_EQ(message(), "accepted");
  const std::string whole = contentOf(files.file);
  for (std::size_t at = 0; at < whole.size(); at += whole.size() / 20) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    std::ofstream(files.file, std::ios::binary) << damaged;
    EXPECT_EQ(message(), refusal) << at;
    std::ofstream(files.file, std::ios::binary) << whole.substr(0, at);
    EXPECT_EQ(message(), refusal) << at;
  }
}

TEST_F(StudyFilesTest, WriterResumes) {
  {
    results::StudyResults results(description);
    StudyWriter writer(files, results, false);
    writer.record(solved(1));
    writer.record(solved(2));
    writer.finish("interrupted");
    EXPECT_EQ(results.count(), 2);
  }
  EXPECT_TRUE(std::filesystem::exists(files.table));
  results::StudyResults results(description);
  StudyWriter writer(files, results, false);
  EXPECT_EQ(results.count(), 2);
  EXPECT_FALSE(std::filesystem::exists(files.table));
  writer.record(solved(3));
  writer.finish("complete");
  EXPECT_EQ(results.count(results::Status::calibrated), 3);
}

TEST_F(StudyFilesTest, WriterRemembersAddedConfigurationsAndNotes) {
  {
    results::StudyResults results(description);
    StudyWriter writer(files, results, false);
    writer.add({4, {1.0 / 7.0, 2.0 / 7.0}});
    writer.note("audit", {"none", true});
    writer.note("audit", {"1 of 1", true});
    writer.note("surface", {"not reached", true});
    writer.note("surface", {"reached"});
    writer.record(solved(4));
  }
  results::StudyResults results(description);
  const StudyWriter writer(files, results, false);
  ASSERT_EQ(results.configurations().size(), 4u);
  EXPECT_EQ(results.configurations()[3].values, (std::vector<double>{1.0 / 7.0, 2.0 / 7.0}));
  ASSERT_NE(results.find(4), nullptr);
  EXPECT_EQ(results.notes().at("audit").text, "1 of 1");
  EXPECT_EQ(results.notes().at("surface").text, "reached");
  EXPECT_TRUE(results.fallsShort());
  results.note("audit", {"0 of 1"});
  EXPECT_FALSE(results.fallsShort());
}

TEST_F(StudyFilesTest, ResultsWithoutJournalAreNotOverwritten) {
  results::StudyResults results(description);
  { StudyWriter(files, results, false); }
  std::filesystem::remove(files.journal);
  EXPECT_NE(messageOf([&] { StudyWriter(files, results, false); }).find("does not."), std::string::npos);
  EXPECT_EQ(messageOf([&] { StudyWriter(files, results, true); }), "accepted");
}

}  // namespace
}  // namespace harmos::files
