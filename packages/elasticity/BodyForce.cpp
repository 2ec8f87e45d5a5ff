#include <harmos/elasticity/BodyForce.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/elasticity/detail/Axis.hpp>

namespace harmos::elasticity {

BodyForce::BodyForce(const ElasticPart& part)
    : name_(part.piece.name),
      components_(componentsOf(part.kinematics)),
      moments_(part.piece.nodes.size(), std::array<double, 4>{}),
      isOnAxis_(nodesOnAxis(part.mesh, part.piece, part.kinematics)) {
  const ElasticPart plain{part.mesh,       part.piece,    part.material, Formulation::fullIntegration,
                          part.kinematics, part.thickness};
  const base::Matrix rest(components_ * static_cast<int>(moments_.size()), 1);
  forEachPoint(plain, PointSet::integration, rest, [&](const ElementPoint& point) {
    for (int a = 0; a < point.nodes; ++a) {
      std::array<double, 4>& moments = moments_[point.node[a]];
      const double weight = point.volume * point.value[a];
      moments[0] += weight;
      for (std::size_t i = 0; i < 3; ++i) moments[i + 1] += weight * point.position[i];
    }
  });
}

void BodyForce::addTo(double* forces, const AffineField& b) const {
  if (components_ == 2 && (b.constant[2] != 0.0 || b.slope[2][0] != 0.0 || b.slope[2][1] != 0.0)) {
    throw base::Error("The body force of part \"" + name_ + "\" has a z component of " + base::toText(b.constant[2]) +
                          "; in 2-D it must be 0.",
                      base::ExitCode::input);
  }
  for (std::size_t node = 0; node < moments_.size(); ++node) {
    const std::array<double, 4>& moments = moments_[node];
    const base::Vector3 force = moments[0] * b.constant + base::product(b.slope, {moments[1], moments[2], moments[3]});
    for (int c = 0; c < components_; ++c) {
      if (!isOnAxis_[node] || isFreeOnAxis(c)) forces[components_ * node + c] += force[c];
    }
  }
}

}  // namespace harmos::elasticity
