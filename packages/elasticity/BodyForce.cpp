#include <harmos/elasticity/BodyForce.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/elasticity/detail/Axis.hpp>

namespace harmos::elasticity {

namespace {

/// The part as its stiffness sees it, cold.
ElasticPart plainOf(const ElasticPart& part) {
  return {part.mesh, part.piece, part.material, Formulation::fullIntegration, part.kinematics, part.thickness};
}

[[noreturn]] void refuseOutOfPlane(const std::string& part, double z) {
  throw base::Error(
      "The body force of part \"" + part + "\" has a z component of " + base::toText(z) + "; in 2-D it must be 0.",
      base::ExitCode::input);
}

}  // namespace

BodyForce::BodyForce(const ElasticPart& part)
    : name_(part.piece.part),
      components_(componentsOf(part.kinematics)),
      moments_(part.piece.nodes.size(), std::array<double, 4>{}),
      isOnAxis_(nodesOnAxis(part.mesh, part.piece, part.kinematics)) {
  visitElements(plainOf(part), PointSet::integration, [&](const ElementPoints& at) {
    for (int p = 0; p < at.points; ++p) {
      for (int a = 0; a < at.nodes; ++a) {
        std::array<double, 4>& moments = moments_[at.node[a]];
        const double weight = at.volume[p] * at.value[p * at.nodes + a];
        moments[0] += weight;
        for (std::size_t i = 0; i < 3; ++i) moments[i + 1] += weight * at.position[p][i];
      }
    }
  });
}

void BodyForce::addTo(base::Matrix& forces, const ElasticPart& part, const Field& b) {
  const int components = componentsOf(part.kinematics);
  const std::vector<bool> isOnAxis = nodesOnAxis(part.mesh, part.piece, part.kinematics);
  const auto add = [&](const ElementPoints& at, int p, int t) {
    const base::Vector3 here = b(t, at, p), force = at.volume[p] * here;
    if (components == 2 && here[2] != 0.0) refuseOutOfPlane(part.piece.part, here[2]);
    for (int a = 0; a < at.nodes; ++a) {
      const int node = at.node[a];
      for (int c = 0; c < components; ++c) {
        if (isOnAxis[node] && !isFreeOnAxis(c)) continue;
        forces(components * node + c, t) += at.value[p * at.nodes + a] * force[c];
      }
    }
  };
  visitElements(plainOf(part), PointSet::integration, [&](const ElementPoints& at) {
    for (int p = 0; p < at.points; ++p) {
      for (int t = 0; t < forces.numCols(); ++t) add(at, p, t);
    }
  });
}

void BodyForce::addTo(double* forces, const AffineField& b) const {
  if (components_ == 2 && (b.constant[2] != 0.0 || b.slope[2][0] != 0.0 || b.slope[2][1] != 0.0)) {
    refuseOutOfPlane(name_, b.constant[2]);
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
