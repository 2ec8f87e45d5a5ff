#include <harmos/design/Axis.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace harmos::design {

double Axis::at(double fraction) const {
  if (levels.empty()) return lower + fraction * (upper - lower);
  const auto position = static_cast<std::size_t>(fraction * static_cast<double>(levels.size()));
  return levels[std::min(position, levels.size() - 1)];
}

std::vector<double> evenLevels(double from, double to, int count) {
  std::vector<double> levels;
  for (int i = 0; i < count; ++i) {
    const double level = count == 1 ? from : from + (to - from) * i / (count - 1);
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.12g", level);
    levels.push_back(std::strtod(digits, nullptr));
  }
  return levels;
}

}  // namespace harmos::design
