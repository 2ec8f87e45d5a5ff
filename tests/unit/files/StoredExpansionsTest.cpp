#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include <harmos/base/Error.hpp>
#include <harmos/files/StoredExpansions.hpp>
#include <harmos/files/detail/StudyFile.hpp>
#include <harmos/probability/Beta.hpp>
#include <harmos/probability/Lognormal.hpp>
#include <harmos/probability/Normal.hpp>
#include <harmos/probability/Uniform.hpp>

namespace harmos::files {
namespace {

class StoredExpansionsTest : public ::testing::Test {
 protected:
  StoredExpansionsTest() {
    std::filesystem::remove(path);
    description.name = "joint";
  }
  ~StoredExpansionsTest() override { std::filesystem::remove(path); }

  static std::vector<probability::Variable> variables() {
    return {{"k", std::make_shared<probability::Normal>(500.0, 100.0)},
            {"mu", std::make_shared<probability::Lognormal>(0.3, 0.06)},
            {"gap", std::make_shared<probability::Uniform>(-0.1, 0.4)},
            {"load", std::make_shared<probability::Beta>(2.0, 7.0, 2.0, 3.0)}};
  }

  /// With one response that has no expansion and one with any coefficients.
  probability::Expansion write(std::shared_ptr<const probability::RandomVector> vector) const {
    const auto basis = std::make_shared<probability::Basis>(std::move(vector), 3);
    std::vector<double> coefficients;
    for (int a = 0; a < basis->size(); ++a) coefficients.push_back(std::cos(a));
    auto summary = std::make_shared<results::StochasticSummary>();
    summary->variables = {"k", "mu", "gap", "load"};
    summary->distributions = {"", "", "", ""};
    summary->responses.resize(2);
    summary->responses[0].name = "u";
    summary->responses[1].name = "F";
    summary->responses[1].expansion = std::make_shared<probability::Expansion>(basis, coefficients);
    summary->responses[1].standardDeviation = 2.0;
    summary->responses[1].predictionError = 0.5;
    results::StudyResults results(description);
    results.setStatistics(summary);
    writeStudyFile(path, results, "complete");
    return {basis, coefficients};
  }

  const std::string path = "stored_expansions.h5";
  results::StudyDescription description;
};

TEST_F(StoredExpansionsTest, AreThoseThatWereWritten) {
  const auto vector = std::make_shared<probability::RandomVector>(variables());
  const probability::Expansion written = write(vector);
  const auto stored = StoredExpansions::read(path);
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->parameters(), (std::vector<std::string>{"k", "mu", "gap", "load"}));
  EXPECT_EQ(stored->responses(), std::vector<std::string>{"F"});
  EXPECT_DOUBLE_EQ(stored->deviation(0), 0.5);
  for (const double u : {0.02, 0.4, 0.9}) {
    const std::vector<double> germs = vector->germs({u, 1.0 - u, u, u * u});
    const std::vector<double> values = stored->evaluate(vector->values(germs));
    ASSERT_EQ(values.size(), 1U);
    EXPECT_NEAR(values[0], written.evaluate(germs), 1e-12 * std::abs(values[0]));
  }
}

TEST_F(StoredExpansionsTest, KnowWhereTheyExtrapolate) {
  write(std::make_shared<probability::RandomVector>(variables()));
  const auto stored = StoredExpansions::read(path);
  ASSERT_TRUE(stored);
  EXPECT_TRUE(stored->isInside({500.0 + 233.0, 0.3, 0.0, 4.0}));  // the outermost of four Gauss points is at 2.334
  EXPECT_FALSE(stored->isInside({500.0 + 234.0, 0.3, 0.0, 4.0}));
  EXPECT_FALSE(stored->isInside({500.0, 0.3, 0.399, 4.0}));
  EXPECT_THROW(stored->evaluate({500.0, 0.0, 0.0, 4.0}), base::Error);
}

TEST_F(StoredExpansionsTest, OfCorrelatedParametersAreRefused) {
  base::Matrix correlation(4, 4);
  for (int i = 0; i < 4; ++i) correlation(i, i) = 1.0;
  correlation(0, 1) = correlation(1, 0) = 0.5;
  write(std::make_shared<probability::RandomVector>(variables(), correlation));
  EXPECT_THROW(StoredExpansions::read(path), base::Error);
}

TEST_F(StoredExpansionsTest, AreNoneWithoutStatistics) {
  writeStudyFile(path, results::StudyResults(description), "complete");
  EXPECT_FALSE(StoredExpansions::read(path));
}

}  // namespace
}  // namespace harmos::files
