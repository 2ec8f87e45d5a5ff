#include <harmos/design/SurrogateFit.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::design {

namespace {

// Time grows with the third power of the number, and more tell hardly more.
constexpr std::size_t mostPointsOfSurface = 2000;

}  // namespace

std::optional<Surrogate> fitSurrogate(const std::vector<std::vector<double>>& points, const std::vector<double>& values,
                                      double accuracy) {
  std::vector<std::size_t> known;
  double largest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    known.push_back(i);
    largest = std::max(largest, std::abs(values[i]));
  }
  std::vector<std::vector<double>> chosen;
  std::vector<double> chosenValues;
  const std::size_t count = std::min(known.size(), mostPointsOfSurface);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = known[i * known.size() / count];
    chosen.push_back(points[at]);
    chosenValues.push_back(values[at]);
  }
  if (count < 3 || chosen.front().empty()) return std::nullopt;
  for (std::size_t p = 0; p < chosen.front().size(); ++p) {
    const double first = chosen.front()[p];
    if (std::all_of(chosen.begin(), chosen.end(), [&](const auto& point) { return point[p] == first; }))
      return std::nullopt;
  }
  return Surrogate(std::move(chosen), std::move(chosenValues), accuracy * largest);
}

}  // namespace harmos::design
