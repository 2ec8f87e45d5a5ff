#include <harmos/latin/SafetyResponse.hpp>

#include <algorithm>

#include <harmos/latin/Safety.hpp>

namespace harmos::latin {

double SafetyResponse::start() const {
  return where_ == Where::point ? largestSafety : 0.0;
}

void SafetyResponse::include(const assembly::Interface& interface, const PairFields& fields,
                             std::vector<double>& values) const {
  if (where_ == Where::whole) {
    for (int t = 0; t < fields.steps; ++t) {
      double* sums = values.data() + static_cast<std::ptrdiff_t>(3) * t;
      ContactSums sum;
      add(interface, fields, t, sum);
      sums[0] += sum.pressure;
      sums[1] += sum.capacity;
      sums[2] += sum.shear;
    }
    return;
  }
  const Safety all = safety(interface, fields);
  const std::vector<double>& field = against_ == Against::slip ? all.slip : all.gaping;
  for (int t = 0; t < fields.steps; ++t) {
    for (int p = 0; p < fields.pairs; ++p) {
      const std::size_t at = fields.at(t, p);
      if (all.counts[at]) values[t] = std::min(values[t], field[at]);
    }
  }
}

std::vector<double> SafetyResponse::finish(std::vector<double> values) const {
  if (where_ == Where::point) return values;
  std::vector<double> result;
  ContactSums sums;
  for (std::size_t first = 0; first < values.size(); first += 3) {
    sums.pressure = values[first];
    sums.capacity = values[first + 1];
    sums.shear = values[first + 2];
    sums.largestPressure = std::max(sums.largestPressure, sums.pressure);
    result.push_back(against_ == Against::slip ? sums.slip() : sums.gaping());
  }
  return result;
}

}  // namespace harmos::latin
