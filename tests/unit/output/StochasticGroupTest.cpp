#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include <harmos/output/Hdf5.hpp>
#include <harmos/output/StudyFile.hpp>

namespace harmos::output {
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
    StudyResults results(description);
    results.setStatistics(summary);
    writeStudyFile(path, results, "complete");
    return Hdf5Source::open(path).group("joint").group("statistics");
  }

  const std::string path = "stochastic_group.h5";
  StudyDescription description;
  const std::shared_ptr<study::StochasticSummary> summary = std::make_shared<study::StochasticSummary>();
};

TEST_F(StochasticGroupTest, SaysWhetherItsFiguresAreThoseOfASample) {
  EXPECT_EQ(written().integer("sample"), 0);
  summary->isSample = true;
  EXPECT_EQ(written().integer("sample"), 1);
}

}  // namespace
}  // namespace harmos::output
