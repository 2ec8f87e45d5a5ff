#include <harmos/parametric/AcceptedResults.hpp>

#include <utility>

namespace harmos::parametric {

void AcceptedResults::add(const design::Configuration& configuration, const results::ConfigurationResult& result) {
  accepted_[configuration.id] = {configuration, result};
}

void AcceptedResults::update(const results::ConfigurationResult& result) {
  if (const auto accepted = accepted_.find(result.id); accepted != accepted_.end()) accepted->second.result = result;
}

results::ConfigurationResult AcceptedResults::take(int id) {
  if (auto accepted = accepted_.extract(id)) return std::move(accepted.mapped().result);
  if (auto withdrawn = withdrawn_.extract(id)) return std::move(withdrawn.mapped());
  return {};
}

std::vector<design::Configuration> AcceptedResults::review(results::ResultSink& sink) {
  std::vector<design::Configuration> open;
  for (auto& [id, one] : accepted_) {
    const results::Indicators& indicators = *one.result.evidence.indicators;
    const bool isReopened = !calibration_.accepts(indicators);
    if (isReopened) open.push_back(one.configuration);
    const double before = one.result.errorEstimate;
    const std::vector<double> curvesBefore = one.result.curveErrors;
    delivery_.estimate(indicators, one.result);
    const bool isAsBefore = one.result.errorEstimate == before && one.result.curveErrors == curvesBefore;
    if (std::exchange(one.isReopened, isReopened) == isReopened && isAsBefore) continue;
    results::ConfigurationResult result = one.result;
    if (isReopened) {
      result.status = results::Status::reopened;
      result.reason = "it was accepted, but a ratio of indicator to error that was found since says less of it";
    }
    sink.record(result);
  }
  return open;
}

}  // namespace harmos::parametric
