#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <harmos/base/Vector3.hpp>

namespace harmos::laws {

/// The six rigid motions phi_i of a face about its centre c: translations along x, y and z, and rotations e_i x (x -
/// c).
///
/// A displacement w of the face has the mean motion q = G^-1 sum of h phi_i.w, G_ij = sum of h phi_i.phi_j, over the
/// pairs with areas h: that which is nearest to it. Tractions t = sum of lambda_i phi_i have the resultant force and
/// moment about c R = G lambda; they do the work R.q, so that forces on the mean motion are spread in this way. In the
/// plane only the translations along x and y and the rotation about z count; the others are 0.
class FaceMotions {
 public:
  /// Translation or force, then rotation or moment.
  using Six = std::array<double, 6>;

  /// Of points with these places [length] and areas. Nothing when they do not determine all motions, as points on one
  /// line in space. `dimension`: 2 or 3.
  static std::optional<FaceMotions> of(const std::vector<std::pair<base::Vector3, double>>& points, int dimension);

  /// Which of the six there are: all, or in the plane 0, 1 and 5.
  std::vector<int> components() const;
  /// c [length].
  const base::Vector3& centre() const { return centre_; }
  /// sum of motion_i phi_i at a place.
  base::Vector3 at(const Six& motion, const base::Vector3& place) const;
  /// G^-1 x.
  Six divided(const Six& x) const;
  /// What the six numbers of a force in a point and the moment about it are about the centre.
  Six fromPoint(const base::Vector3& point, const Six& resultant) const;

 private:
  /// Adds phi_i.v to the sums.
  void addProjection(const base::Vector3& place, const base::Vector3& v, Six& sums) const;

  base::Vector3 centre_{};
  std::array<Six, 6> inverse_{};
};

}  // namespace harmos::laws
