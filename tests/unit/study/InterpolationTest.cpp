#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <harmos/study/detail/Interpolation.hpp>

#include "RandomStudy.hpp"

namespace harmos::study {
namespace {

using Germs = std::vector<double>;
using InterpolationTest = RandomStudy;

/// Alike in both germs, so that many points matter as much as others.
double kinked(const Germs& germs, int id, double error) {
  return std::max(0.0, germs[0] + germs[1] - 0.1) + (id % 3 - 1) * error;
}

/// Gives all configurations, whose germs are given, results that are off by about `error`.
void solve(const std::vector<Germs>& germs, double error, results::StudyResults& results) {
  for (std::size_t i = 0; i < germs.size(); ++i) {
    results::ConfigurationResult result;
    result.id = static_cast<int>(i) + 1;
    result.status = results::Status::certified;
    result.curves = {{kinked(germs[i], result.id, error)}};
    results.set(result);
  }
}

// What is found anew, as claims that are taken back, differs within the accuracy: enough to ask in another order.
TEST_F(InterpolationTest, GoesThroughItsPointsWhateverOrderTheyWereSolvedIn) {
  const Study study = this->study({"Design/Type=Adaptive Collocation", "Design/Maximum Count=120"});
  results::StudyDescription description;
  description.configurations = study.configurations;
  description.times = {1.0};
  description.responses = {{"r", 0, results::ScalarResponse::Kind::final}};
  results::StudyResults results(description);
  std::vector<Germs> all = study.stochastic->germs;
  double error = 1e-6;
  for (;;) {
    const Interpolation interpolation(study, results);
    if (interpolation.wanted().empty()) break;
    for (const Germs& germs : interpolation.wanted()) {
      all.push_back(germs);
      results.add({static_cast<int>(all.size()), *study.plan->complete(study.stochastic->variables->values(germs))});
    }
    error = -error;
    solve(all, error, results);
  }
  const Interpolation interpolation(study, results);
  ASSERT_TRUE(interpolation.isComplete());
  ASSERT_GT(interpolation.count(), 100);
  int passed = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double value = kinked(all[i], static_cast<int>(i) + 1, error);
    passed += std::abs(interpolation.function().evaluate(all[i])[0] - value) < 1e-9 ? 1 : 0;
  }
  EXPECT_GE(passed, interpolation.count());
}

}  // namespace
}  // namespace harmos::study
