#include <harmos/latin/OverlapResponse.hpp>

namespace harmos::latin {

void OverlapResponse::include(const assembly::Interface& interface, const PairFields& fields,
                              std::vector<double>& values) const {
  for (int t = 0; t < fields.steps; ++t) {
    double* sums = values.data() + 2 * t;
    for (int p = 0; p < fields.pairs; ++p) {
      sums[0] -= interface.area[p] * fields.jump[fields.at(t, p)][0];
      sums[1] += interface.area[p];
    }
  }
}

std::vector<double> OverlapResponse::finish(std::vector<double> values) const {
  std::vector<double> means;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
    means.push_back(values[i + 1] > 0.0 ? values[i] / values[i + 1] : 0.0);
  }
  return means;
}

}  // namespace harmos::latin
