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

bool Calibration::add(const std::vector<Observation>& run) {
  ++runs_;
  const double forceBefore = forceRatio_;
  const double responseBefore = responseRatio_;
  const auto counts = [this](double error) {
    return error >= smallestError * accuracy_ && error <= largestError * accuracy_;
  };
  for (const Observation& state : run) {
    if (counts(state.forceError)) forceRatio_ = std::min(forceRatio_, state.indicators.force / state.forceError);
    if (counts(state.responseError)) {
      responseRatio_ = std::min(responseRatio_, state.indicators.response / state.responseError);
    }
  }
  return forceRatio_ < forceBefore || responseRatio_ < responseBefore;
}

double Calibration::estimate(const Indicators& indicators) const {
  const auto error = [](double indicator, double ratio) {
    if (indicator == 0.0) return 0.0;
    return ratio > 0.0 ? indicator / ratio : std::numeric_limits<double>::infinity();
  };
  if (runs_ == 0) return std::numeric_limits<double>::infinity();
  return std::max(error(indicators.force, forceRatio_), error(indicators.response, responseRatio_));
}

Indicators Calibration::target() const {
  const double share = accuracy_ / (runs_ < runsOfExperience ? safetyAtFirst : safety);
  return {share * forceRatio_, share * responseRatio_};
}

bool Calibration::accepts(const Indicators& indicators) const {
  return (runs_ < runsOfExperience ? safetyAtFirst : safety) * estimate(indicators) <= accuracy_;
}

}  // namespace harmos::parametric
