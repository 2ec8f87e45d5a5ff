#include <harmos/parametric/Delivery.hpp>

#include <string>
#include <vector>

#include <harmos/latin/Snapshot.hpp>

namespace harmos::parametric {

void Delivery::estimate(const results::Indicators& indicators, results::ConfigurationResult& result) const {
  result.errorEstimate = calibration_.estimate(indicators);
  result.curveErrors.clear();
  for (std::size_t r = 0; r < solver_.responses().size(); ++r)
    result.curveErrors.push_back(calibration_.estimateOf(r, indicators));
}

bool Delivery::addRanges(results::ConfigurationResult& result) const {
  const double accuracy = solver_.options().accuracy;
  const latin::Indeterminacy found = solver_.iteration().indeterminacy(solver_.responses());
  const std::vector<latin::ResponseRange>& ranges = found.responses;
  const latin::Snapshot last(solver_.iteration().state(), solver_.responses());
  bool isUnique = found.pressures.empty();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!(ranges[i].width() > accuracy * last.size(i))) continue;
    isUnique = false;
    result.reason += "; " + latin::describe(solver_.responses()[i]->name(), ranges[i], result.curves[i]);
  }
  if (!found.pressures.empty()) result.reason += "; " + latin::describePressures(found.pressures);
  return isUnique;
}

void Delivery::deliver(const results::Indicators& indicators, results::ConfigurationResult& result) const {
  if (const std::string falseGraph = solver_.iteration().falseGraph(); !falseGraph.empty()) {
    result.status = results::Status::notConverged;
    result.reason = falseGraph;
    return;
  }
  result.reason = "the calibrated error estimate is below the accuracy asked for";
  result.curves.clear();
  for (const auto& response : solver_.responses())
    result.curves.push_back(response->evaluate(solver_.iteration().state()));
  estimate(indicators, result);
  result.evidence.indicators = indicators;
  result.status = addRanges(result) ? results::Status::calibrated : results::Status::calibratedNotUnique;
}

}  // namespace harmos::parametric
