#include <harmos/design/GridDesign.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/design/Configuration.hpp>

namespace harmos::design {

std::vector<std::vector<double>> GridDesign::points(const std::vector<Axis>& axes) const {
  double count = 1.0;
  for (const Axis& axis : axes) {
    if (axis.levels.empty()) {
      throw base::Error("a grid needs levels of \"" + axis.name + "\".\n  Give Values, or From, To and Count.",
                        base::ExitCode::input);
    }
    count *= static_cast<double>(axis.levels.size());
  }
  if (count > mostConfigurations) {
    throw base::Error("the grid has " + base::toText(count) + " points, but a study has at most " +
                          std::to_string(mostConfigurations) + ".\n  Take fewer levels or another design.",
                      base::ExitCode::input);
  }
  std::vector<std::vector<double>> points = {{}};
  for (const Axis& axis : axes) {
    std::vector<std::vector<double>> longer;
    longer.reserve(points.size() * axis.levels.size());
    for (const auto& point : points) {
      for (const double level : axis.levels) {
        longer.push_back(point);
        longer.back().push_back(level);
      }
    }
    points = std::move(longer);
  }
  return points;
}

}  // namespace harmos::design
