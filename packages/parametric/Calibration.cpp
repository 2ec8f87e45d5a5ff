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

}  // namespace

results::Ratios Calibration::ratiosOf(const std::vector<Observation>& run) const {
  results::Ratios ratios;
  const auto counts = [this](double error) {
    return error >= smallestError * accuracy_ && error <= largestError * accuracy_;
  };
  for (const Observation& state : run) {
    if (counts(state.forceError)) ratios.force = std::min(ratios.force, state.indicators.force / state.forceError);
    if (counts(state.responseError)) {
      ratios.response = std::min(ratios.response, state.indicators.response / state.responseError);
    }
  }
  return ratios;
}

bool Calibration::add(const results::Ratios& ofRun) {
  ++runs_;
  const results::Ratios before = ratios_;
  ratios_ = {std::min(before.force, ofRun.force), std::min(before.response, ofRun.response)};
  return ratios_.force < before.force || ratios_.response < before.response;
}

double Calibration::estimate(const results::Indicators& indicators) const {
  const auto error = [](double indicator, double ratio) {
    if (indicator == 0.0) return 0.0;
    return ratio > 0.0 ? indicator / ratio : std::numeric_limits<double>::infinity();
  };
  if (runs_ == 0) return std::numeric_limits<double>::infinity();
  return std::max(error(indicators.force, ratios_.force), error(indicators.response, ratios_.response));
}

results::Indicators Calibration::target() const {
  const double share = accuracy_ / (runs_ < runsOfExperience ? safetyAtFirst : safety);
  return {share * ratios_.force, share * ratios_.response};
}

bool Calibration::accepts(const results::Indicators& indicators) const {
  return (runs_ < runsOfExperience ? safetyAtFirst : safety) * estimate(indicators) <= accuracy_;
}

}  // namespace harmos::parametric
