#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/files/ExodusWriter.hpp>
#include <harmos/files/detail/ExodusResults.hpp>

#include "TwoBoxes.hpp"

using namespace harmos::files;

TEST(ExodusFile, KeepsMeshNamesTimesAndValues) {
  const std::string path = temporaryFile("a.e");
  writeBoxes(path, false);
  const ExodusResults file(path);
  const auto expected = twoBoxes();
  EXPECT_EQ(file.mesh().nodes, expected.nodes);
  ASSERT_EQ(file.mesh().blocks.size(), 2u);
  EXPECT_EQ(file.mesh().blocks[1].name, "upper");
  EXPECT_EQ(file.mesh().blocks[1].type, "HEX8");
  EXPECT_EQ(file.mesh().blocks[1].connectivity, expected.blocks[1].connectivity);
  ASSERT_EQ(file.mesh().sideSets.size(), 2u);
  EXPECT_EQ(file.mesh().sideSets[1].name, "contact_2");
  EXPECT_EQ(file.mesh().sideSets[1].element, expected.sideSets[1].element);
  EXPECT_EQ(file.mesh().sideSets[1].side, expected.sideSets[1].side);
  EXPECT_EQ(file.times(), (std::vector<double>{0.0, 1.0, 2.0}));
  EXPECT_EQ(file.variables().nodal, boxVariables().nodal);
  const auto step = boxStep(expected, 2.0);
  EXPECT_EQ(file.nodal(2, 0), step.nodal[0]);
  EXPECT_EQ(file.element(2, 0), step.element[0]);
  EXPECT_EQ(file.global(2, 0), step.global[0]);
  EXPECT_EQ(file.nodal(0, 0), std::vector<double>(36, 0.0));
}

TEST(ExodusFile, KeepsLongNames) {
  const std::string path = temporaryFile("long.e");
  auto mesh = twoBoxes();
  mesh.blocks[0].name = "a_block_name_that_is_longer_than_thirty_two_characters";
  ResultVariables variables{{}, {}, {"a_response_name_that_is_longer_than_thirty_two_characters"}};
  ExodusWriter writer(path, "", mesh, variables);
  writer.write(zeroStep(mesh, variables));
  writer.commit();
  const ExodusResults file(path);
  EXPECT_EQ(file.mesh().blocks[0].name, mesh.blocks[0].name);
  EXPECT_EQ(file.variables().global, variables.global);
}

TEST(ExodusFile, JoinsLongInformationLines) {
  const std::string path = temporaryFile("info.e");
  const std::vector<std::string> lines{"short", std::string(80, 'a'), std::string(81, 'b'), std::string(400, 'c'), ""};
  ExodusWriter writer(path, "", twoBoxes(), {}, lines);
  writer.commit();
  EXPECT_EQ(ExodusResults(path).information(), lines);
}

TEST(ExodusFile, AppearsOnlyWhenComplete) {
  const std::string path = temporaryFile("partial.e");
  { ExodusWriter abandoned(path, "", twoBoxes(), {}); }
  EXPECT_FALSE(std::filesystem::exists(path));
  std::ofstream(path) << "old";
  {
    ExodusWriter writer(path, "", twoBoxes(), {});
    EXPECT_EQ(std::filesystem::file_size(path), 3u);
    writer.commit();
  }
  EXPECT_EQ(ExodusResults(path).mesh().nodes.size(), 36u);
}

TEST(ExodusFile, RefusesOneNameForTwoSets) {
  auto mesh = twoBoxes();
  mesh.blocks[0].name = "upper";
  mesh.blocks[1].name = "upper";
  try {
    ExodusWriter writer(temporaryFile("twice.e"), "", mesh, {});
    FAIL() << "accepted the same name for two blocks";
  } catch (const harmos::base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("\"upper\" is used for two of its blocks"), std::string::npos)
        << error.what();
  }
}

TEST(ExodusFile, TellsKindsOfOneNameApart) {
  auto mesh = twoBoxes();
  mesh.nodeSets = {{"one", 1, {0}}};
  mesh.blocks[0].name = mesh.sideSets[0].name = "one";
  const std::string path = temporaryFile("kinds.e");
  ExodusWriter(path, "", mesh, {}).commit();
  const ResultMesh read = ExodusResults(path).mesh();
  EXPECT_EQ(read.blocks[0].name, "one");
  EXPECT_EQ(read.sideSets[0].name, "one");
  EXPECT_EQ(read.nodeSets[0].name, "one");
}

TEST(ExodusFile, RefusesValuesOfAnotherMesh) {
  ExodusWriter writer(temporaryFile("size.e"), "", twoBoxes(), boxVariables());
  auto step = boxStep(writer.mesh(), 0.0);
  step.nodal[1].pop_back();
  EXPECT_THROW(writer.write(step), harmos::base::Error);
}

TEST(ExodusFile, RefusesWhatIsNotExodus) {
  const std::string path = temporaryFile("text.e");
  std::ofstream(path) << "not an Exodus file";
  for (const auto& name : {path, path + ".absent"}) {
    try {
      const ExodusResults file(name);
      FAIL() << "read " << name;
    } catch (const harmos::base::Error& error) {
      EXPECT_EQ(error.code(), harmos::base::ExitCode::input);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
    }
  }
}
