#include <harmos/results/ScalarResponse.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::results {

namespace {

double interpolate(const std::vector<double>& times, const std::vector<double>& values, double time) {
  const auto after = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
  if (after == times.size()) return values.back();
  const double begin = after == 0 ? 0.0 : times[after - 1];
  const double old = after == 0 ? 0.0 : values[after - 1];
  return old + (values[after] - old) * (time - begin) / (times[after] - begin);
}

}  // namespace

double ScalarResponse::evaluate(const std::vector<double>& times, const std::vector<double>& values) const {
  switch (kind) {
    case Kind::maximum:
      return *std::max_element(values.begin(), values.end());
    case Kind::minimum:
      return *std::min_element(values.begin(), values.end());
    case Kind::final:
      return values.back();
    case Kind::largestMagnitude:
      return *std::max_element(values.begin(), values.end(),
                               [](double a, double b) { return std::abs(a) < std::abs(b); });
    case Kind::atTime:
      return interpolate(times, values, time);
  }
  return values.back();
}

}  // namespace harmos::results
