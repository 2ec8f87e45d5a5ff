#pragma once

#include <array>
#include <memory>
#include <vector>

#include <harmos/laws/FaceMotions.hpp>
#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::laws {

/// What a joint makes of one of the six motions q of its face about a point: it acts on the face with the resultant
/// R = force + stiffness (value - q), or holds q = value where the stiffness is infinite.
struct JointComponent {
  double stiffness = 0.0;  ///< [force/length], or [force length] per radian; >= 0, 0: the motion is free
  double value = 0.0;      ///< [length], or radians
  double force = 0.0;      ///< [force], or [force length]
};

/// A face of a joint on its lines delta_p = free_p - H_p t_p of an outer boundary, delta = -w.
///
/// distributing: q is the mean motion of the face, which stays free to deform, and t = sum of c_i v_i with the motions
/// v_i that have the resultant 1 in component i about the point, q_i = sum of h v_i.w; c = R. rigid: the face moves as
/// a rigid body, w = sum of c_i phi_i with the rigid motions phi_i about the point; c = q. Either way one linear system
/// of six unknowns is left, made of sums over all points of all faces of the joint.
class FaceJoint {
 public:
  /// Whether the face may deform.
  enum class Kind { distributing, rigid };
  using Six = FaceMotions::Six;
  using Components = std::array<JointComponent, 6>;
  /// How many sums it needs: six, and a symmetric matrix.
  static constexpr int numberOfSums = 27;

  /// Along the axes, which are orthonormal, about a point. `sign`: -1 for a face that is moved against the others.
  FaceJoint(Kind kind, const FaceMotions& face, const base::Vector3& point, const base::Frame& axes, double sign);

  /// See CoupledLaw; areas and positions are needed.
  void addToSums(const NodeArrays& nodes, double* sums) const;
  /// The six c of the joint, by the sums over all its faces. Throws base::Error when they are not determined.
  Six solve(const Components& components, const double* sums) const;
  /// q of the six components, given c.
  Six motions(const double* sums, const Six& c) const;
  /// Writes the tractions of some points.
  void meet(const NodeArrays& nodes, const Six& c) const;
  /// Tractions at a place that have the resultant 1 in one component: v_i, whatever the kind.
  std::array<base::Vector3, 6> unitTractions(const base::Vector3& place) const;
  /// The vectors v_i or phi_i at a place.
  std::array<base::Vector3, 6> vectors(const base::Vector3& place) const;

 private:
  std::array<base::Vector3, 6> fieldsAt(const std::array<Six, 6>& fields, const base::Vector3& place) const;

  Kind kind_;
  FaceMotions face_;
  double sign_;
  std::vector<int> used_;      // components that there are in this dimension
  std::array<Six, 6> motion_;  // about the centre of the face, of c_i = 1
  std::array<Six, 6> unit_;    // the same of v_i
};

}  // namespace harmos::laws
