#include <harmos/probability/Sample.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <harmos/probability/detail/Require.hpp>

namespace harmos::probability {

Sample::Sample(std::vector<double> values) : values_(std::move(values)) {
  std::sort(values_.begin(), values_.end());
  require(std::all_of(values_.begin(), values_.end(), [](double x) { return std::isfinite(x); }),
          "Sample distribution: every value must be a finite number.");
  require(
      !values_.empty() && values_.front() < values_.back(),
      "Sample distribution: give at least two different values; a parameter that does not vary is given by its value "
      "alone.");
  const auto count = static_cast<double>(values_.size());
  mean_ = std::accumulate(values_.begin(), values_.end(), 0.0) / count;
  double squares = 0.0;
  for (const double x : values_) squares += (x - mean_) * (x - mean_);
  deviation_ = std::sqrt(squares / count);
  std::vector<double> germs;
  for (const double x : values_) germs.push_back((x - mean_) / deviation_);
  polynomials_ = Polynomials::discrete(germs, std::vector<double>(germs.size(), 1.0 / count));
}

double Sample::germ(double u) const {
  const double position = std::ceil(requireProbability(u) * static_cast<double>(values_.size())) - 1.0;
  return (values_[position] - mean_) / deviation_;
}

double Sample::germExceeded(double v) const {
  const auto above = static_cast<std::size_t>(requireProbability(v) * static_cast<double>(values_.size()));
  return (values_[values_.size() - 1 - std::min(above, values_.size() - 1)] - mean_) / deviation_;
}

double Sample::cumulative(double x) const {
  const auto notAbove = std::upper_bound(values_.begin(), values_.end(), x) - values_.begin();
  return static_cast<double>(notAbove) / static_cast<double>(values_.size());
}

}  // namespace harmos::probability
