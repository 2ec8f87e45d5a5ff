#include <harmos/latin/detail/FixedPlaces.hpp>

#include <algorithm>

namespace harmos::latin {
namespace {

// Extent of nodes across a line (in the plane across a point), over that along it, that fixes no rotation.
constexpr double flat = 1e-6;

}  // namespace

bool areFixed(const std::vector<base::Vector3>& places, int dimension) {
  const base::Vector3& origin = places.front();
  const auto farthest = std::max_element(places.begin(), places.end(), [&](const auto& a, const auto& b) {
    return base::distance(a, origin) < base::distance(b, origin);
  });
  const double length = base::distance(*farthest, origin);
  if (dimension == 2 || length == 0.0) return length > 0.0;
  const base::Vector3 along = (1.0 / length) * (*farthest - origin);
  return std::any_of(places.begin(), places.end(), [&](const base::Vector3& x) {
    return base::norm(base::cross(along, x - origin)) > flat * length;
  });
}

}  // namespace harmos::latin
