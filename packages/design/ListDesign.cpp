#include <harmos/design/ListDesign.hpp>

#include <string>

#include <harmos/base/Error.hpp>

namespace harmos::design {

std::vector<std::vector<double>> ListDesign::points(const std::vector<Axis>& axes) const {
  for (const auto& point : points_) {
    if (point.size() == axes.size()) continue;
    throw base::Error("a point has " + std::to_string(point.size()) + " values, but the study has " +
                          std::to_string(axes.size()) + " free parameters.",
                      base::ExitCode::input);
  }
  return points_;
}

}  // namespace harmos::design
