#include <harmos/study/detail/Interpolation.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <harmos/results/StatusName.hpp>

namespace harmos::study {

namespace {

probability::PiecewiseLinear makeFunction(const Study& study) {
  const InterpolationOptions& design = *study.design.as<InterpolationOptions>();
  probability::PiecewiseLinear::Options options;
  options.tolerance = design.tolerance;
  options.largestCount = design.largestCount;
  if (design.response) {
    const auto found = std::find_if(study.responses.begin(), study.responses.end(),
                                    [&](const auto& response) { return response.name == *design.response; });
    options.response = static_cast<int>(found - study.responses.begin());
  }
  return {study.stochastic->variables, options};
}

/// Where the configurations are that were solved for an interpolation.
class SolvedPoints {
 public:
  /// Of the configurations from number `first` on, from 0. Both must outlive it.
  SolvedPoints(const Study& study, const results::StudyResults& results, std::size_t first)
      : study_(study), configurations_(results.configurations()), first_(first) {}

  /// The id of the configuration with these values of random parameters; 0: none. `place`: where it is looked for
  /// first, from 0.
  int idAt(const std::vector<double>& values, std::size_t place) const {
    if (first_ + place < configurations_.size() && isAt(first_ + place, values)) return idOf(first_ + place);
    for (std::size_t i = first_; i < configurations_.size(); ++i) {
      if (isAt(i, values)) return idOf(i);
    }
    return 0;
  }

 private:
  // What writing a value and reading it again may change of it.
  static constexpr double roundOff = 1e-12;

  bool isAt(std::size_t configuration, const std::vector<double>& values) const {
    const std::vector<std::size_t>& places = study_.stochastic->places;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double own = configurations_[configuration].values[places[k]];
      if (!(std::abs(own - values[k]) <= roundOff * std::max(std::abs(own), std::abs(values[k])))) return false;
    }
    return true;
  }
  int idOf(std::size_t configuration) const { return configurations_[configuration].id; }

  const Study& study_;
  const std::vector<design::Configuration>& configurations_;
  std::size_t first_;
};

}  // namespace

Interpolation::Interpolation(const Study& study, const results::StudyResults& results)
    : function_(makeFunction(study)) {
  const SolvedPoints points(study, results, study.stochastic->germs.size());
  while (true) {
    const auto batch = function_.next();
    if (batch.empty()) break;
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      // Results that were found anew may have changed the order in which points are asked for.
      const int id = points.idAt(study.stochastic->variables->values(batch[i]), static_cast<std::size_t>(count_) + i);
      if (id == 0) {
        wanted_.push_back(batch[i]);
        continue;
      }
      const results::ConfigurationResult* result = results.find(id);
      if (result && !results::isSolved(result->status))
        summary_ = "configuration " + std::to_string(id) + " has no solution, without which it cannot go on";
      if (!result || !results::isSolved(result->status)) {
        wanted_.clear();
        return;
      }
      values.push_back(results.responses(id));
    }
    if (!wanted_.empty()) return;
    count_ += static_cast<int>(batch.size());
    function_.tell(values);
  }
  isComplete_ = true;
  std::ostringstream text;
  text << (function_.isReached() ? "reached: " : "not reached: ") << count_
       << " configurations, estimated error of mean and standard deviation " << std::setprecision(2)
       << function_.errorIndicator() << " of the standard deviation, asked for "
       << study.design.as<InterpolationOptions>()->tolerance;
  summary_ = text.str();
}

}  // namespace harmos::study
