#include <harmos/study/detail/Interpolation.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <harmos/results/StatusName.hpp>
#include <harmos/study/detail/StochasticErrors.hpp>

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

// Of a value: what writing it and reading it again may change.
constexpr double roundOff = 1e-12;

/// Id of the configuration that was added at these values of the random parameters, after those that are held out; 0:
/// none. `place` among the added ones, from 0: where it is looked for first.
int idAt(const std::vector<double>& values, std::size_t place, const Study& study,
         const results::StudyResults& results) {
  const std::vector<std::size_t>& places = study.stochastic->places;
  const auto isThere = [&](const design::Configuration& configuration) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double own = configuration.values[places[k]];
      if (!(std::abs(own - values[k]) <= roundOff * std::max(std::abs(own), std::abs(values[k])))) return false;
    }
    return true;
  };
  const std::vector<design::Configuration>& all = results.configurations();
  const std::size_t heldOut = study.stochastic->germs.size();
  if (heldOut + place < all.size() && isThere(all[heldOut + place])) return all[heldOut + place].id;
  const auto found = std::find_if(all.begin() + static_cast<std::ptrdiff_t>(heldOut), all.end(), isThere);
  return found == all.end() ? 0 : found->id;
}

}  // namespace

Interpolation::Interpolation(const Study& study, const results::StudyResults& results)
    : function_(makeFunction(study)) {
  while (true) {
    const auto batch = function_.next();
    if (batch.empty()) break;
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      // Results that were found anew may have changed the order in which points are asked for.
      const std::vector<double> point = study.stochastic->variables->values(batch[i]);
      const int id = idAt(point, static_cast<std::size_t>(count_) + i, study, results);
      if (id == 0) {
        wanted_.push_back(batch[i]);
        continue;
      }
      const results::ConfigurationResult* result = results.find(id);
      if (!result || !results::isSolved(result->status)) {
        if (result)
          summary_ = "configuration " + std::to_string(id) + " has no solution, without which it cannot go on";
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
  double ofSolutions = 0.0;
  for (std::size_t r = 0; r < study.responses.size(); ++r) {
    const double deviation = function_.standardDeviation(static_cast<int>(r));
    const std::optional<std::string>& driving = study.design.as<InterpolationOptions>()->response;
    const double mean = function_.mean(static_cast<int>(r));
    const bool isConstant = !(deviation > leastSpread * std::abs(mean));
    if (isConstant || (driving && *driving != study.responses[r].name)) continue;
    const double error = solverError(study, results, r, mean, deviation);
    ofSolutions = std::max(ofSolutions, error / deviation);
  }
  const double tolerance = study.design.as<InterpolationOptions>()->tolerance;
  isReached_ = function_.errorIndicator() + ofSolutions <= tolerance;
  std::ostringstream text;
  text << (isReached_ ? "reached: " : "not reached: ") << count_
       << " configurations, estimated error of mean and standard deviation " << std::setprecision(2)
       << function_.errorIndicator() + ofSolutions << " of the standard deviation, asked for " << tolerance;
  if (!isReached_ && ofSolutions > function_.errorIndicator())
    text << "; most of it is that of the solutions: ask for a smaller Accuracy";
  summary_ = text.str();
}

}  // namespace harmos::study
