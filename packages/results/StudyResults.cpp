#include <harmos/results/StudyResults.hpp>

#include <algorithm>
#include <limits>

#include <harmos/results/StatusName.hpp>

namespace harmos::results {

StudyResults::StudyResults(const StudyDescription& description)
    : description_(description),
      configurations_(description.configurations),
      results_(description.configurations.size()) {}

void StudyResults::add(const design::Configuration& configuration) {
  if (configuration.id != static_cast<int>(configurations_.size()) + 1) return;
  configurations_.push_back(configuration);
  results_.emplace_back();
}

void StudyResults::set(const ConfigurationResult& result) {
  if (result.id < 1 || result.id > static_cast<int>(results_.size())) return;
  auto& place = results_[result.id - 1];
  if (!place) ++count_;
  place = result;
}

const ConfigurationResult* StudyResults::find(int id) const {
  const auto& place = results_[id - 1];
  return place ? &*place : nullptr;
}

bool StudyResults::fallsShort() const {
  return std::any_of(notes_.begin(), notes_.end(), [](const auto& each) { return each.second.isUnmet; });
}

int StudyResults::count(Status status) const {
  return static_cast<int>(std::count_if(results_.begin(), results_.end(),
                                        [&](const auto& place) { return place && place->status == status; }));
}

int StudyResults::solved() const {
  return static_cast<int>(std::count_if(results_.begin(), results_.end(),
                                        [](const auto& place) { return place && isSolved(place->status); }));
}

std::vector<double> StudyResults::responses(int id) const {
  const ConfigurationResult* result = find(id);
  const bool isSolved = result && results::isSolved(result->status) && !result->curves.empty();
  std::vector<double> values;
  for (const ScalarResponse& response : description_.responses) {
    if (isSolved) {
      values.push_back(response.evaluate(description_.times, result->curves[response.curve]));
    } else if (result && result->status != Status::reopened && !description_.recovery.empty()) {
      values.push_back(description_.recovery[values.size()]);
    } else {
      values.push_back(std::numeric_limits<double>::quiet_NaN());
    }
  }
  return values;
}

std::vector<ConfigurationResult> StudyResults::all() const {
  std::vector<ConfigurationResult> results;
  for (const auto& place : results_) {
    if (place) results.push_back(*place);
  }
  return results;
}

}  // namespace harmos::results
