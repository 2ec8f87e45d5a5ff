#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include <harmos/base/Error.hpp>
#include <harmos/files/StoredInterpolant.hpp>
#include <harmos/files/detail/StudyFile.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/probability/PiecewiseLinear.hpp>

namespace harmos::files {
namespace {

class StoredInterpolantTest : public ::testing::Test {
 protected:
  StoredInterpolantTest() {
    std::filesystem::remove(path);
    description.name = "joint";
  }
  ~StoredInterpolantTest() override { std::filesystem::remove(path); }

  static std::vector<probability::Variable> variables() {
    return {{"gap", std::make_shared<probability::Normal>(0.1, 0.02)},
            {"k", std::make_shared<probability::Lognormal>(1000.0, 200.0)}};
  }

  /// Of two responses, one of which bends.
  results::Interpolant write(const std::shared_ptr<const probability::RandomVector>& vector) const {
    probability::PiecewiseLinear::Options options;
    options.tolerance = 1e-9;
    options.largestCount = 80;
    probability::PiecewiseLinear function(vector, options);
    for (auto points = function.next(); !points.empty(); points = function.next()) {
      std::vector<std::vector<double>> values;
      for (const auto& germs : points) values.push_back({std::max(0.0, germs[0] + germs[1]), germs[1]});
      function.tell(values);
    }
    auto summary = std::make_shared<results::StochasticSummary>();
    summary->variables = {"gap", "k"};
    summary->distributions = {"", ""};
    summary->responses.resize(2);
    summary->responses[0].name = "N";
    summary->responses[1].name = "u";
    summary->randomness = vector;
    results::Interpolant interpolant{function.function(), function.doubt(), {2.0, 1.0}, {0.25, 0.5}};
    summary->interpolant = std::make_shared<results::Interpolant>(interpolant);
    results::StudyResults results(description);
    results.setStatistics(summary);
    writeStudyFile(path, results, "complete");
    return interpolant;
  }

  const std::string path = "stored_interpolant.h5";
  results::StudyDescription description;
};

TEST_F(StoredInterpolantTest, IsTheOneThatWasWritten) {
  const auto vector = std::make_shared<probability::RandomVector>(variables());
  const results::Interpolant written = write(vector);
  const auto stored = StoredInterpolant::read(path);
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->parameters(), (std::vector<std::string>{"gap", "k"}));
  EXPECT_EQ(stored->responses(), (std::vector<std::string>{"N", "u"}));
  for (const double u : {0.02, 0.4, 0.55, 0.9}) {
    const std::vector<double> germs = vector->germs({u, 1.0 - u * u});
    const auto found = stored->evaluate(vector->values(germs));
    for (std::size_t r = 0; r < 2; ++r) {
      EXPECT_NEAR(found.values[r], written.values.evaluate(germs)[r], 1e-10);
      const double deviation = written.calibrations[r] * written.doubt.evaluate(germs)[r] + written.floors[r];
      EXPECT_NEAR(found.deviations[r], deviation, 1e-10);
    }
    EXPECT_TRUE(found.isInside);
  }
}

TEST_F(StoredInterpolantTest, KnowsWhereItEnds) {
  write(std::make_shared<probability::RandomVector>(variables()));
  const auto stored = StoredInterpolant::read(path);
  ASSERT_TRUE(stored);
  EXPECT_TRUE(stored->evaluate({0.1 + 4.9 * 0.02, 1000.0}).isInside);
  EXPECT_FALSE(stored->evaluate({0.1 + 5.1 * 0.02, 1000.0}).isInside);
  EXPECT_THROW(stored->evaluate({0.1, 0.0}), base::Error);
}

TEST_F(StoredInterpolantTest, OfCorrelatedParametersIsRefused) {
  base::Matrix correlation(2, 2);
  correlation(0, 0) = correlation(1, 1) = 1.0;
  correlation(0, 1) = correlation(1, 0) = 0.5;
  write(std::make_shared<probability::RandomVector>(variables(), correlation));
  EXPECT_THROW(StoredInterpolant::read(path), base::Error);
}

TEST_F(StoredInterpolantTest, IsNoneWithoutStatistics) {
  writeStudyFile(path, results::StudyResults(description), "complete");
  EXPECT_FALSE(StoredInterpolant::read(path));
}

}  // namespace
}  // namespace harmos::files
