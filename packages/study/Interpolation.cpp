#include <harmos/study/detail/Interpolation.hpp>

#include <algorithm>
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

}  // namespace

Interpolation::Interpolation(const Study& study, const results::StudyResults& results)
    : function_(makeFunction(study)) {
  const std::size_t heldOut = study.stochastic->germs.size();
  while (true) {
    const auto batch = function_.next();
    if (batch.empty()) break;
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const int id = static_cast<int>(heldOut + static_cast<std::size_t>(count_) + i) + 1;
      if (id > static_cast<int>(results.configurations().size())) {
        wanted_.assign(batch.begin() + static_cast<std::ptrdiff_t>(i), batch.end());
        return;
      }
      const results::ConfigurationResult* result = results.find(id);
      if (!result) return;
      if (!results::isSolved(result->status)) {
        summary_ = "configuration " + std::to_string(id) + " has no solution, without which it cannot go on";
        return;
      }
      values.push_back(results.responses(id));
    }
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
