#include <harmos/parametric/Calibration.hpp>

#include <algorithm>
#include <limits>

namespace harmos::parametric {
namespace {

constexpr double smallestError = 0.1;  // times the accuracy
constexpr double largestError = 10.0;
constexpr int runsOfExperience = 5;
constexpr double safety = 1.5;
constexpr double safetyAtFirst = 2.0;

double error(double indicator, double ratio) {
  if (indicator == 0.0) return 0.0;
  return ratio > 0.0 ? indicator / ratio : std::numeric_limits<double>::infinity();
}

}  // namespace

results::Ratios Calibration::ratiosOf(const std::vector<Observation>& run) const {
  results::Ratios ratios;
  ratios.responses.assign(ratios_.responses.size(), 1.0);
  const double smallest = smallestError * accuracy_, largest = largestError * accuracy_;
  for (const Observation& state : run) {
    if (state.forceError >= smallest && state.forceError <= largest)
      ratios.force = std::min(ratios.force, state.indicators.force / state.forceError);
    const std::vector<double>& errors = state.responseErrors;
    if (std::all_of(errors.begin(), errors.end(), [&](double each) { return each < smallest; })) continue;
    for (std::size_t r = 0; r < errors.size(); ++r) {
      const double indicator = state.indicators.responses[r];
      if (errors[r] > largest || indicator == 0.0) continue;
      ratios.responses[r] = std::min(ratios.responses[r], indicator / std::max(errors[r], smallest));
    }
  }
  return ratios;
}

bool Calibration::add(const results::Ratios& ofRun) {
  ++runs_;
  bool hasFallen = false;
  const auto take = [&](double& ratio, double another) {
    hasFallen = hasFallen || another < ratio;
    ratio = std::min(ratio, another);
  };
  take(ratios_.force, ofRun.force);
  for (std::size_t r = 0; r < std::min(ofRun.responses.size(), ratios_.responses.size()); ++r)
    take(ratios_.responses[r], ofRun.responses[r]);
  return hasFallen;
}

double Calibration::estimateOf(std::size_t response, const results::Indicators& indicators) const {
  if (runs_ == 0) return std::numeric_limits<double>::infinity();
  return std::max(indicators.balance, error(indicators.responses[response], ratios_.responses[response]));
}

double Calibration::estimate(const results::Indicators& indicators) const {
  if (runs_ == 0) return std::numeric_limits<double>::infinity();
  double largest = std::max(indicators.balance, error(indicators.force, ratios_.force));
  for (std::size_t r = 0; r < ratios_.responses.size(); ++r) largest = std::max(largest, estimateOf(r, indicators));
  return largest;
}

results::Indicators Calibration::target() const {
  const double share = accuracy_ / (runs_ < runsOfExperience ? safetyAtFirst : safety);
  results::Indicators target{share * ratios_.force, share};
  for (const double ratio : ratios_.responses) target.responses.push_back(share * ratio);
  return target;
}

bool Calibration::accepts(const results::Indicators& indicators) const {
  return (runs_ < runsOfExperience ? safetyAtFirst : safety) * estimate(indicators) <= accuracy_;
}

results::Indicators tightened(double share, const results::Indicators& aimed, const results::Indicators& reached) {
  results::Indicators target{share * std::min(aimed.force, reached.force),
                             share * std::min(aimed.balance, reached.balance)};
  for (std::size_t r = 0; r < aimed.responses.size(); ++r)
    target.responses.push_back(share * std::min(aimed.responses[r], reached.responses[r]));
  return target;
}

}  // namespace harmos::parametric
