#include <harmos/probability/SampledSobolIndices.hpp>

#include <cmath>

#include <harmos/probability/SampleStatistics.hpp>

namespace harmos::probability {

std::vector<std::vector<SobolIndex>> sobolIndices(const Responses& evaluate, const std::vector<std::vector<double>>& a,
                                                  const std::vector<std::vector<double>>& b) {
  const auto ofA = evaluate(a), ofB = evaluate(b);
  std::vector<std::vector<SobolIndex>> indices(ofA.size());
  for (std::size_t germ = 0; germ < a.front().size(); ++germ) {
    auto mixed = a;
    for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i][germ] = b[i][germ];
    const auto ofMixed = evaluate(mixed);
    for (std::size_t r = 0; r < ofA.size(); ++r) {
      const SampleStatistics statistics(ofA[r]);
      const double variance = std::pow(statistics.standardDeviation(), 2) * static_cast<double>(a.size());
      double main = 0.0, total = 0.0;
      for (std::size_t i = 0; i < a.size(); ++i) {
        main += (ofB[r][i] - statistics.mean()) * (ofMixed[r][i] - ofA[r][i]);
        total += 0.5 * std::pow(ofA[r][i] - ofMixed[r][i], 2);
      }
      indices[r].push_back({{static_cast<int>(germ)}, main / variance, total / variance});
    }
  }
  return indices;
}

}  // namespace harmos::probability
