#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/study/ParametricStudy.hpp>

#include "../latin/Chains.hpp"

namespace harmos::study {
namespace {

/// Keeps the last result of every configuration.
class Results : public ResultSink {
 public:
  void record(const ConfigurationResult& result) override {
    for (ConfigurationResult& one : all) {
      if (one.id != result.id) continue;
      one = result;
      return;
    }
    all.push_back(result);
  }
  std::vector<ConfigurationResult> all;
};

std::vector<Configuration> row(const std::vector<double>& values) {
  std::vector<Configuration> configurations;
  for (double value : values) configurations.push_back({static_cast<int>(configurations.size()) + 1, {value}});
  return configurations;
}

constexpr double left = 10.0, right = 20.0, both = left * right / (left + right);

/// Two chains in series; the parameter is what the law of one interface takes.
class Chains {
 public:
  explicit Chains(interface::Assembly assembly, double accuracy) : assembly_(std::move(assembly)) {
    options_.accuracy = accuracy;
  }

  Results run(const std::vector<Configuration>& configurations, const ParametricStudy::Install& install) {
    const auto force =
        std::make_shared<latin::ResultantResponse>("force", std::vector<int>{1}, std::vector<mesh::Point>{});
    ParametricStudy study(assembly_, install, {force}, options_, latin::self(), timers_);
    Results results;
    study.run(configurations, {}, results);
    return results;
  }
  void setLaw(std::size_t interface, std::shared_ptr<const laws::InterfaceLaw> law) {
    assembly_.interfaces[interface].law = std::move(law);
  }

 private:
  interface::Assembly assembly_;
  latin::LatinOptions options_;
  base::Timers timers_;
};

std::shared_ptr<const laws::InterfaceLaw> pull(double force) {
  return laws::makeLaw("Prescribed Traction", {{"X", force}}, {{"X", {0.5, 1.0}}});
}
std::shared_ptr<const laws::InterfaceLaw> hold() {
  return laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}});
}
std::shared_ptr<const laws::InterfaceLaw> preload(double jump) {
  return laws::makeLaw("Preload Jump", {{"Jump", jump}}, {{"Jump", {0.5, 1.0}}});
}

TEST(ParametricStudy, VariesAPreload) {
  Chains chains(latin::twoChains(preload(1.0), hold(), 2), 1e-6);
  const Results results =
      chains.run(row({0.1, 0.2, 0.3}), [&](const auto& values) { chains.setLaw(1, preload(values[0])); });
  ASSERT_EQ(results.all.size(), 3u);
  for (const ConfigurationResult& result : results.all) {
    const double jump = 0.1 * result.id;
    EXPECT_EQ(result.status, Status::certified) << result.reason;
    EXPECT_LE(result.errorEstimate, 1e-6);
    EXPECT_NEAR(result.curves[0][0], 0.5 * both * jump, 1e-6 * both * jump);
    EXPECT_NEAR(result.curves[0][1], both * jump, 1e-6 * both * jump);
    EXPECT_EQ(result.starts.empty(), result.id == 1);
  }
}

TEST(ParametricStudy, VariesATraction) {
  Chains chains(latin::twoChains(laws::makeLaw("Perfect"), pull(1.0), 2), 1e-6);
  const Results results = chains.run(row({1.0, 4.0}), [&](const auto& values) { chains.setLaw(2, pull(values[0])); });
  ASSERT_EQ(results.all.size(), 2u);
  EXPECT_NEAR(results.all[0].curves[0][1], 1.0, 1e-6);
  EXPECT_NEAR(results.all[1].curves[0][0], 2.0, 4e-6);
  EXPECT_NEAR(results.all[1].curves[0][1], 4.0, 4e-6);
}

TEST(ParametricStudy, RecordsFailuresAndGoesOn) {
  Chains chains(latin::twoChains(preload(1.0), hold(), 2), 1e-6);
  const Results results = chains.run(row({-1.0, 0.2}), [&](const auto& values) {
    if (values[0] < 0.0) throw base::Error("the preload is negative", base::ExitCode::input);
    chains.setLaw(1, preload(values[0]));
  });
  ASSERT_EQ(results.all.size(), 2u);
  EXPECT_EQ(results.all[0].status, Status::inadmissible);
  EXPECT_EQ(results.all[0].reason, "the preload is negative");
  EXPECT_TRUE(results.all[0].curves.empty());
  EXPECT_EQ(results.all[1].status, Status::certified);
}

}  // namespace
}  // namespace harmos::study
