#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/laws/PointwiseLaw.hpp>
#include <harmos/parametric/ParametricStudy.hpp>
#include <harmos/results/StatusName.hpp>

#include "../latin/Chains.hpp"

namespace harmos::parametric {
namespace {

/// Keeps the last result of every configuration.
class Results : public results::ResultSink {
 public:
  void record(const results::ConfigurationResult& result) override {
    for (results::ConfigurationResult& one : all) {
      if (one.id != result.id) continue;
      one = result;
      return;
    }
    all.push_back(result);
  }
  std::vector<results::ConfigurationResult> all;
};

std::vector<design::Configuration> row(const std::vector<double>& values) {
  std::vector<design::Configuration> configurations;
  for (double value : values) configurations.push_back({static_cast<int>(configurations.size()) + 1, {value}});
  return configurations;
}

constexpr double left = 10.0, right = 20.0, both = left * right / (left + right);

/// Two chains in series; the parameter is what the law of one interface takes.
class Chains {
 public:
  explicit Chains(assembly::Assembly assembly, double accuracy) : assembly_(std::move(assembly)) {
    options_.accuracy = accuracy;
  }

  Results run(const std::vector<design::Configuration>& configurations, const ParametricStudy::Install& install) {
    const auto force =
        std::make_shared<latin::ResultantResponse>("force", std::vector<int>{1}, std::vector<base::Vector3>{});
    ParametricStudy study(assembly_, install, {force}, options_, latin::self(), timers_);
    Results results;
    study.run(configurations, results);
    return results;
  }
  void setLaw(std::size_t interface, std::shared_ptr<const laws::InterfaceLaw> law) {
    assembly_.interfaces[interface].law = std::move(law);
  }

 private:
  assembly::Assembly assembly_;
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
  for (const results::ConfigurationResult& result : results.all) {
    const double jump = 0.1 * result.id;
    EXPECT_EQ(result.status, results::Status::certified) << result.reason;
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
  EXPECT_EQ(results.all[0].status, results::Status::inadmissible);
  EXPECT_EQ(results.all[0].reason, "the preload is negative");
  EXPECT_TRUE(results.all[0].curves.empty());
  EXPECT_EQ(results.all[1].status, results::Status::certified);
}

/// A node pressed and dragged to and fro: the shear force is that of a Jenkins element.
class JenkinsStudy {
 public:
  explicit JenkinsStudy(double accuracy) : assembly_(latin::twoChains(friction(0.3), drag(0.8), 4)) {
    options_.accuracy = accuracy;
    shear_ = std::make_shared<latin::ResultantResponse>("shear", std::vector<int>{1},
                                                        std::vector<base::Vector3>{{0.0, 1.0, 0.0}});
    study_ = std::make_unique<ParametricStudy>(
        assembly_, [this](const auto& values) { install(values); },
        std::vector<std::shared_ptr<const latin::Response>>{shear_}, options_, latin::self(), timers_);
  }
  static std::shared_ptr<const laws::InterfaceLaw> friction(double coefficient) {
    return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", coefficient}});
  }
  /// To and fro; `third` of the way at the third step.
  static std::shared_ptr<const laws::InterfaceLaw> drag(double third) {
    return laws::makeLaw("Prescribed Displacement", {{"X", -1.0 / both}, {"Y", 0.1}, {"Z", 0.0}},
                         {{"Y", {0.2, 1.0, third, -1.0}}});
  }
  /// Stick: both * way; slip at the friction coefficient times the pressure of 1.
  static std::vector<double> exact(double coefficient) {
    std::vector<double> curve;
    double force = 0.0, before = 0.0;
    for (double way : {0.02, 0.1, 0.08, -0.1}) {
      force = std::clamp(force + both * (way - before), -coefficient, coefficient);
      before = way;
      curve.push_back(force);
    }
    return curve;
  }
  void install(const std::vector<double>& values) {
    if (values[0] < 0.0) throw base::Error("negative friction", base::ExitCode::input);
    const bool isBroken = std::find(broken_.begin(), broken_.end(), values[0]) != broken_.end();
    assembly_.interfaces[1].law = friction(values[0]);
    assembly_.interfaces[2].law = drag(isBroken ? std::numeric_limits<double>::quiet_NaN() : 0.8);
  }

  assembly::Assembly assembly_;
  latin::LatinOptions options_;
  base::Timers timers_;
  std::vector<double> broken_;  // coefficients with which the law fails
  std::shared_ptr<const latin::Response> shear_;
  std::unique_ptr<ParametricStudy> study_;
};

std::vector<design::Configuration> frictions(int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(0.1 + 0.4 * i / (count - 1.0));
  return row(values);
}

TEST(ParametricStudy, ClaimsNothingFalse) {
  for (double accuracy : {1e-2, 1e-4}) {
    JenkinsStudy jenkins(accuracy);
    Results results;
    jenkins.study_->run(frictions(60), results);
    ASSERT_EQ(results.all.size(), 60u);
    int certified = 0, stages = 0;
    for (const results::ConfigurationResult& result : results.all) {
      ASSERT_TRUE(result.status == results::Status::calibrated || result.status == results::Status::certified)
          << result.reason;
      certified += result.status == results::Status::certified ? 1 : 0;
      stages += result.linearStages;
      EXPECT_LE(result.errorEstimate, accuracy);
      const double coefficient = 0.1 + 0.4 * (result.id - 1) / 59.0;
      const std::vector<double> exact = JenkinsStudy::exact(coefficient);
      double size = 0.0;
      for (double value : exact) size = std::max(size, std::abs(value));
      for (std::size_t t = 0; t < exact.size(); ++t) EXPECT_NEAR(result.curves[0][t], exact[t], accuracy * size);
    }
    EXPECT_GE(certified, 1);
    EXPECT_GE(jenkins.study_->summary().calibrations, 4);
    EXPECT_EQ(jenkins.study_->summary().audits, 1);
    EXPECT_EQ(jenkins.study_->summary().falseClaims, 0);
    EXPECT_LT(stages, 60 * 20);
  }
}

TEST(ParametricStudy, KeepsSolutionsForLaterRuns) {
  JenkinsStudy jenkins(1e-3);
  Results results;
  jenkins.study_->run(frictions(20), results);
  jenkins.study_->run({{100, {0.333}}}, results);
  ASSERT_EQ(results.all.size(), 21u);
  EXPECT_FALSE(results.all.back().starts.empty());
  EXPECT_LT(results.all.back().linearStages, 10);
}

TEST(ParametricStudy, GoesOnAfterAFailureAmongMany) {
  JenkinsStudy jenkins(1e-3);
  std::vector<design::Configuration> configurations = frictions(15);
  configurations[3].values[0] = -1.0;
  Results results;
  jenkins.study_->run(configurations, results);
  ASSERT_EQ(results.all.size(), 15u);
  for (const results::ConfigurationResult& result : results.all) {
    if (result.id == 4) {
      EXPECT_EQ(result.status, results::Status::inadmissible);
    } else {
      EXPECT_TRUE(result.status == results::Status::calibrated || result.status == results::Status::certified)
          << result.reason;
    }
  }
}

// A law that fails on the way leaves nothing behind.
TEST(ParametricStudy, GoesOnAfterALawThatFails) {
  JenkinsStudy jenkins(1e-3);
  std::vector<design::Configuration> configurations = frictions(15);
  for (const int broken : {0, 3, 7, 11}) jenkins.broken_.push_back(configurations[broken].values[0]);
  Results results;
  jenkins.study_->run(configurations, results);
  ASSERT_EQ(results.all.size(), 15u);
  for (const results::ConfigurationResult& result : results.all) {
    if (result.id == 1 || result.id == 4 || result.id == 8 || result.id == 12) {
      EXPECT_EQ(result.status, results::Status::failed);
      continue;
    }
    ASSERT_TRUE(result.status == results::Status::calibrated || result.status == results::Status::certified)
        << result.reason;
    const std::vector<double> exact = JenkinsStudy::exact(configurations[result.id - 1].values[0]);
    for (std::size_t t = 0; t < exact.size(); ++t) EXPECT_NEAR(result.curves[0][t], exact[t], 1e-3);
  }
}

/// Glue that forgets a share of the compliance of its lines.
struct Forgetful {
  static constexpr const char* name = "Forgetful";
  static constexpr int historySize = 0;
  static constexpr laws::Sides sides = laws::Sides::two;
  Forgetful(double k, double shareOfCompliance) : stiffness(k), share(shareOfCompliance) {}
  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext&, const double*, double*) const {
    laws::LocalState state;
    state.traction = (stiffness / (1.0 + stiffness * share * line.compliance)) * line.freeJump;
    return state;
  }
  double stiffness, share;
};

// One among many, which a calibrated estimate would accept: its result depends on the search direction.
TEST(ParametricStudy, AcceptsNoLawThatSolvesOtherEquations) {
  const auto glue = [](double k, double share) { return std::make_shared<laws::PointwiseLaw<Forgetful>>(k, share); };
  Chains chains(latin::twoChains(glue(40.0, 1.0), pull(1.0), 2), 1e-3);
  std::vector<double> stiffnesses;
  for (int i = 0; i < 15; ++i) stiffnesses.push_back(40.0 + 2.0 * i);
  const Results results = chains.run(row(stiffnesses), [&](const auto& values) {
    chains.setLaw(1, glue(values[0], values[0] == stiffnesses[6] ? 0.7 : 1.0));
  });
  ASSERT_EQ(results.all.size(), stiffnesses.size());
  bool isAnyCalibrated = false;
  for (const results::ConfigurationResult& result : results.all) {
    EXPECT_EQ(results::isSolved(result.status), result.id != 7) << result.id << ": " << result.reason;
    isAnyCalibrated = isAnyCalibrated || result.status == results::Status::calibrated;
    if (result.id != 7) continue;
    EXPECT_NE(result.reason.find("law \"Forgetful\" gives another traction at the same jump"), std::string::npos)
        << result.reason;
  }
  EXPECT_TRUE(isAnyCalibrated);
}

// Rigid statics says so: no load step is solved, not even those before the one that lacks forces.
TEST(ParametricStudy, SpendsNoStagesOnWhatHasNoEquilibrium) {
  const auto load = [](double shear) {
    return laws::makeLaw("Prescribed Traction", {{"X", -1.0}, {"Y", shear}}, {{"Y", {0.0, 0.5, 1.0}}});
  };
  for (const int count : {4, 12}) {
    Chains chains(latin::twoChains(JenkinsStudy::friction(0.3), load(0.2), 3), 1e-4);
    std::vector<double> shears;
    for (int i = 0; i < count; ++i) shears.push_back(0.6 * (i + 0.5) / count);
    const Results results = chains.run(row(shears), [&](const auto& values) { chains.setLaw(2, load(values[0])); });
    ASSERT_EQ(results.all.size(), shears.size());
    int marched = 0;
    for (const results::ConfigurationResult& result : results.all) {
      if (shears[static_cast<std::size_t>(result.id - 1)] < 0.3) {
        EXPECT_TRUE(results::isSolved(result.status)) << result.reason;
        continue;
      }
      EXPECT_EQ(result.status, results::Status::noEquilibrium) << result.reason;
      marched += result.linearStages > 0 ? 1 : 0;
      EXPECT_NE(result.reason.find("load step 3"), std::string::npos) << result.reason;
    }
    // From neighbours that are solved, where none without an equilibrium is nearer.
    EXPECT_LE(marched, count == 4 ? 0 : 1);
  }
}

// Killed after any result, also shortly before the end: what is left is solved as well as it would have been, without
// calibrating anew.
TEST(ParametricStudy, GoesOnFromAnotherRun) {
  constexpr double accuracy = 1e-3;
  const std::vector<design::Configuration> all = frictions(30);
  for (const std::size_t done : {18u, 26u}) {
    JenkinsStudy first(accuracy);
    Results before;
    first.study_->setInterrupt([&] { return before.all.size() == done; });
    first.study_->run(all, before);
    ASSERT_EQ(before.all.size(), done);

    std::vector<EarlierResult> earlier;
    std::vector<design::Configuration> open;
    for (const design::Configuration& configuration : all) {
      const auto found = std::find_if(before.all.begin(), before.all.end(),
                                      [&](const auto& one) { return one.id == configuration.id; });
      if (found == before.all.end()) {
        open.push_back(configuration);
      } else {
        earlier.push_back({configuration, *found});
      }
    }
    JenkinsStudy second(accuracy);
    Results after;
    second.study_->resume(earlier);
    EXPECT_EQ(second.study_->summary().ratios.force, first.study_->summary().ratios.force);
    second.study_->run(open, after);
    ASSERT_EQ(after.all.size(), open.size());
    EXPECT_EQ(second.study_->summary().calibrations, first.study_->summary().calibrations);
    int calibrated = 0;
    for (const results::ConfigurationResult& result : after.all) {
      ASSERT_TRUE(results::isSolved(result.status)) << result.reason;
      calibrated += result.status == results::Status::calibrated ? 1 : 0;
      const std::vector<double> exact = JenkinsStudy::exact(all[result.id - 1].values[0]);
      for (std::size_t t = 0; t < exact.size(); ++t) EXPECT_NEAR(result.curves[0][t], exact[t], accuracy * 0.5);
    }
    EXPECT_GE(calibrated, 1);
  }
}

/// Keeps every record.
class Records : public results::ResultSink {
 public:
  void record(const results::ConfigurationResult& result) override { all.push_back(result); }
  std::vector<results::ConfigurationResult> all;
};

// Of a run that was killed before it learned how little its indicators say: claims that are false by far. They are
// withdrawn before what teaches it is recorded, so that another kill leaves no false claim either.
TEST(ParametricStudy, TakesUpAgainWhatAnotherRunHasAccepted) {
  constexpr double accuracy = 1e-3;
  const std::vector<design::Configuration> all = frictions(24);
  std::vector<EarlierResult> earlier;
  for (int i : {2, 9, 20}) {
    results::ConfigurationResult result;
    result.id = all[i].id;
    result.status = results::Status::calibrated;
    result.curves = {{0.0, 0.0, 0.0, 0.0}};
    result.curveErrors = {0.0};
    result.evidence.indicators = results::Indicators{accuracy / 2.001, 0.0, {0.0}};
    if (i == 2) result.evidence.ratios = results::Ratios{};
    earlier.push_back({all[i], result});
  }
  std::vector<design::Configuration> open;
  for (const design::Configuration& one : all) {
    if (one.id != 3 && one.id != 10 && one.id != 21) open.push_back(one);
  }
  JenkinsStudy jenkins(accuracy);
  Records records;
  jenkins.study_->resume(earlier);
  jenkins.study_->run(open, records);
  EXPECT_LT(jenkins.study_->summary().ratios.force, 1.0);
  EXPECT_GE(jenkins.study_->summary().reopened, 3);
  for (const EarlierResult& one : earlier) {
    const auto withdrawn = std::find_if(records.all.begin(), records.all.end(), [&](const auto& result) {
      return result.id == one.result.id && result.status == results::Status::reopened;
    });
    const auto taught = std::find_if(records.all.begin(), records.all.end(), [](const auto& result) {
      return result.evidence.ratios && result.evidence.ratios->force < 0.999;
    });
    ASSERT_TRUE(taught != records.all.end());
    EXPECT_LT(withdrawn, taught);
    const auto last = std::find_if(records.all.rbegin(), records.all.rend(),
                                   [&](const auto& result) { return result.id == one.result.id; });
    ASSERT_TRUE(last != records.all.rend());
    ASSERT_TRUE(results::isSolved(last->status)) << last->reason;
    const std::vector<double> exact = JenkinsStudy::exact(one.configuration.values[0]);
    for (std::size_t t = 0; t < exact.size(); ++t) EXPECT_NEAR(last->curves[0][t], exact[t], accuracy * 0.5);
  }
}

TEST(ParametricStudy, StopsWhenAsked) {
  JenkinsStudy jenkins(1e-3);
  Results results;
  jenkins.study_->setInterrupt([&] { return results.all.size() == 7; });
  jenkins.study_->run(frictions(20), results);
  EXPECT_EQ(results.all.size(), 7u);
}

}  // namespace
}  // namespace harmos::parametric
