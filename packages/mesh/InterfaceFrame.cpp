#include <harmos/mesh/InterfaceFrame.hpp>

#include <cmath>

namespace harmos::mesh {

base::Frame frameFromNormal(const base::Vector3& normal, int dimension) {
  const double length = norm(normal);
  const base::Vector3 n = length > 0.0 ? (1.0 / length) * normal : base::Vector3{1.0, 0.0, 0.0};
  if (dimension == 2) return {n, base::Vector3{-n[1], n[0], 0.0}, base::Vector3{0.0, 0.0, 1.0}};
  // A margin decides between axes that are equally far from n but for rounding.
  constexpr double margin = 1e-6;
  std::size_t axis = 0;
  for (std::size_t d = 1; d < 3; ++d) {
    if (std::abs(n[d]) < std::abs(n[axis]) - margin) axis = d;
  }
  base::Vector3 t1 = (-n[axis]) * n;
  t1[axis] += 1.0;
  t1 = (1.0 / norm(t1)) * t1;
  return {n, t1, cross(n, t1)};
}

}  // namespace harmos::mesh
