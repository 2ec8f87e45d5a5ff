#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include <harmos/files/detail/Hdf5Source.hpp>
#include <harmos/files/detail/StudyFile.hpp>

namespace harmos::files {
namespace {

class StochasticGroupTest : public ::testing::Test {
 protected:
  StochasticGroupTest() {
    std::filesystem::remove(path);
    description.name = "joint";
    summary->variables = {"k"};
    summary->distributions = {""};
    summary->responses.resize(1);
    summary->responses[0].name = "u";
  }
  ~StochasticGroupTest() override { std::filesystem::remove(path); }

  Hdf5Source written() const {
    results::StudyResults study(description);
    study.setStatistics(summary);
    writeStudyFile(path, study, "complete");
    return Hdf5Source::open(path).group("joint").group("statistics");
  }

  const std::string path = "stochastic_group.h5";
  results::StudyDescription description;
  const std::shared_ptr<results::StochasticSummary> summary = std::make_shared<results::StochasticSummary>();
};

TEST_F(StochasticGroupTest, SaysWhetherItsFiguresAreThoseOfASample) {
  EXPECT_EQ(written().integer("sample"), 0);
  summary->isSample = true;
  EXPECT_EQ(written().integer("sample"), 1);
}

}  // namespace
}  // namespace harmos::files
