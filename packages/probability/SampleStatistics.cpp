#include <harmos/probability/SampleStatistics.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <harmos/base/Error.hpp>

namespace harmos::probability {

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

SampleStatistics::SampleStatistics(std::vector<double> values)
    : values_(std::move(values)), deviation_(notANumber), skewness_(notANumber), kurtosis_(notANumber) {
  if (values_.empty()) throw base::Error("a sample needs at least one value");
  if (!std::all_of(values_.begin(), values_.end(), [](double x) { return std::isfinite(x); }))
    throw base::Error("a value of a sample is not a finite number");
  std::sort(values_.begin(), values_.end());
  const auto n = static_cast<double>(values_.size());
  // About the middle value, so that equal values have exactly their own mean.
  const double middle = values_[values_.size() / 2];
  mean_ = middle + std::accumulate(values_.begin(), values_.end(), 0.0, [middle](double sum, double x) {
                     return sum + (x - middle);
                   }) / n;
  if (values_.size() < 2) return;
  double second = 0.0, third = 0.0, fourth = 0.0;
  for (const double x : values_) {
    const double square = (x - mean_) * (x - mean_);
    second += square / n;
    third += square * (x - mean_) / n;
    fourth += square * square / n;
  }
  deviation_ = std::sqrt(second * n / (n - 1.0));
  if (second > 0.0) {
    skewness_ = third / std::pow(second, 1.5);
    kurtosis_ = fourth / (second * second);
  }
}

double SampleStatistics::meanError() const {
  return deviation_ / std::sqrt(static_cast<double>(count()));
}

double SampleStatistics::standardDeviationError() const {
  const double n = count();
  return 0.5 * deviation_ * std::sqrt((kurtosis_ - (n - 3.0) / (n - 1.0)) / n);
}

double SampleStatistics::quantile(double p) const {
  if (!(p >= 0.0 && p <= 1.0)) throw base::Error("a quantile of a sample needs a probability from 0 to 1");
  const double position = p * (count() - 1);
  const auto below = std::min(static_cast<std::size_t>(position), values_.size() - 1);
  const std::size_t above = std::min(below + 1, values_.size() - 1);
  return values_[below] + (position - static_cast<double>(below)) * (values_[above] - values_[below]);
}

double SampleStatistics::cumulative(double x) const {
  return static_cast<double>(std::upper_bound(values_.begin(), values_.end(), x) - values_.begin()) / count();
}

DensityCurve SampleStatistics::density(int points) const {
  if (points < 2) throw base::Error("a density needs at least two points");
  if (!(deviation_ > 0.0)) return {};
  constexpr double reach = 4.0, kernelReach = 9.0;
  const double middleHalf = (quantile(0.75) - quantile(0.25)) / 1.34;
  const double spread = middleHalf > 0.0 ? std::min(deviation_, middleHalf) : deviation_;
  const double width = 0.9 * spread * std::pow(count(), -0.2);
  const double from = values_.front() - reach * width, to = values_.back() + reach * width;
  const double scale = 1.0 / (width * count() * std::sqrt(2.0 * std::acos(-1.0)));
  DensityCurve curve;
  for (int i = 0; i < points; ++i) {
    const double x = from + (to - from) * i / (points - 1);
    double sum = 0.0;
    for (auto at = std::lower_bound(values_.begin(), values_.end(), x - kernelReach * width);
         at != values_.end() && *at < x + kernelReach * width; ++at) {
      sum += std::exp(-0.5 * std::pow((x - *at) / width, 2));
    }
    curve.points.push_back(x);
    curve.values.push_back(scale * sum);
  }
  return curve;
}

double largestDifference(const SampleStatistics& a, const SampleStatistics& b) {
  double largest = 0.0;
  for (const SampleStatistics* sample : {&a, &b}) {
    for (const double x : sample->values()) largest = std::max(largest, std::abs(a.cumulative(x) - b.cumulative(x)));
  }
  return largest;
}

}  // namespace harmos::probability
