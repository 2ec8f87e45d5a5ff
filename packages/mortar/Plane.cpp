#include <harmos/mortar/detail/Plane.hpp>

#include <harmos/mesh/InterfaceFrame.hpp>

namespace harmos::mortar {

Plane::Plane(const base::Vector3& origin, const base::Vector3& normal, int dimension)
    : origin_(origin), normal_(normal) {
  const base::Frame frame = mesh::frameFromNormal(normal, dimension);
  first_ = frame[1];
  second_ = frame[2];
}

double Plane::heightOf(const base::Vector3& point, const base::Vector3& other, const Flat& at) const {
  const base::Vector3 place = origin_ + at[0] * first_ + at[1] * second_;
  return dot(point - place, other) / dot(normal_, other);
}

}  // namespace harmos::mortar
