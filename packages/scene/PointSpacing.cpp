#include <harmos/scene/detail/PointSpacing.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::scene {

double largestSpacing(const assembly::Interface& interface, int dimension, const Model& model) {
  const mesh::Depth depth = depthOf(model);
  double largest = 0.0;
  for (std::size_t p = 0; p < interface.area.size(); ++p) {
    const double area = interface.area[p], width = depth.at(interface.position[p]);
    if (dimension == 3) {
      largest = std::max(largest, std::sqrt(area));
    } else if (width > 0.0) {
      largest = std::max(largest, area / width);
    }
  }
  return largest;
}

}  // namespace harmos::scene
