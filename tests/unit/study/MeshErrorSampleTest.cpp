#include <gtest/gtest.h>

#include <harmos/study/MeshErrorSample.hpp>

namespace harmos::study {
namespace {

class Notes : public results::ResultSink {
 public:
  void record(const results::ConfigurationResult& /*result*/) override {}
  void note(const std::string& name, const results::Note& note) override { all[name] = note.text; }
  std::map<std::string, std::string> all;
};

/// A grid of 5 x 5 over two parameters; the second response of the scene is that of the study.
class MeshErrorSampleTest : public ::testing::Test {
 protected:
  MeshErrorSampleTest() {
    description.parameters = {{"mu", "", "", {}, ""}, {"preload", "", "", {}, ""}};
    for (int i = 0; i < 25; ++i) {
      const int row = i / 5, column = i % 5;
      description.configurations.push_back({i + 1, {0.1 * row, 100.0 * column}});
    }
    description.curves = {"u", "force"};
    results::ScalarResponse force;
    force.curve = 1;
    description.responses = {force};
  }
  const design::Configuration& at(int id) const { return description.configurations[static_cast<std::size_t>(id - 1)]; }

  results::StudyDescription description;
};

TEST_F(MeshErrorSampleTest, TakesFewConfigurationsFarApart) {
  const results::StudyResults results(description);
  MeshErrorSample sample(results);
  EXPECT_EQ(sample.curves(), std::vector<std::size_t>{1});
  std::vector<int> taken;
  for (const design::Configuration& configuration : description.configurations) {
    if (!sample.wants(configuration)) continue;
    taken.push_back(configuration.id);
    sample.add(configuration, {});
    EXPECT_FALSE(sample.wants(configuration));
  }
  EXPECT_EQ(taken, (std::vector<int>{1, 3, 5, 11, 13}));
  design::Configuration between = at(25);
  between.id = -1;
  EXPECT_FALSE(MeshErrorSample(results).wants(between));
}

TEST_F(MeshErrorSampleTest, GoesOnWhereAnEarlierRunHasEnded) {
  results::StudyResults results(description);
  results::ConfigurationResult first;
  first.id = 1;
  first.meshErrors = {{"force", 1.0, 0.04, "estimated", {"bolt"}}};
  results.set(first);
  const MeshErrorSample sample(results);
  EXPECT_FALSE(sample.wants(at(1)));
  EXPECT_FALSE(sample.wants(at(2)));
  EXPECT_TRUE(sample.wants(at(3)));
  EXPECT_EQ(sample.errorsOf(1).front().relative, 0.04);
  EXPECT_TRUE(sample.errorsOf(2).empty());
}

TEST_F(MeshErrorSampleTest, SaysWhatIsKnown) {
  const results::StudyResults results(description);
  MeshErrorSample sample(results);
  Notes notes;
  sample.report(notes);
  EXPECT_TRUE(notes.all.empty());
  sample.add(at(1), {{"force", 1.0, 0.04, "estimated", {"bolt"}}});
  sample.add(at(25), {{"force", 1.0, 0.2, "uncertain", {"head"}}});
  sample.report(notes);
  EXPECT_EQ(notes.all["error of the mesh"],
            "at 2 of 25 configurations: force about 4 to 20 % (uncertain at 1); refine bolt, head");
}

}  // namespace
}  // namespace harmos::study
