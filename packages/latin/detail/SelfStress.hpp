#pragma once

#include <optional>
#include <vector>

#include <harmos/latin/detail/RedundantGroup.hpp>
#include <harmos/latin/detail/TractionSet.hpp>

namespace harmos::latin {

/// The tractions of a redundant group at one load step that no body can tell from those that were found: they differ
/// by a self-stress, a field in equilibrium with itself at every node, and are admitted by the laws at the same jumps.
class SelfStress {
 public:
  /// `sets` of the pairs of the group, in their order, which hold `tractions` [stress], global components on side 1.
  /// `group` must outlive it.
  SelfStress(const RedundantGroup& group, std::vector<TractionSet> sets, const std::vector<base::Vector3>& tractions);

  /// Whether there is another field.
  bool exists() const { return !free_.empty(); }
  /// An orthonormal basis of those within the hulls of the sets: t sqrt(h), pair by pair.
  const std::vector<std::vector<base::Vector3>>& basis() const { return free_; }
  /// Whether self-stresses within the hulls of the sets act on a pair along a unit vector.
  bool actsOn(std::size_t pair, const base::Vector3& direction) const;
  /// Whether friction at a pair, with the normal n, depends on its pressure.
  bool hasFriction(std::size_t pair, const base::Vector3& n) const { return sets_[pair].hasFriction(n); }
  /// Whether a self-stress within the hulls changes the sum of weight.t, `weights` per pair.
  bool changes(const std::vector<base::Vector3>& weights) const;
  /// The one with the least sum of h t^2 [stress]: a convex programme, solved by alternating directions to 1e-10 of the
  /// largest. What was found where these do not get there.
  std::vector<base::Vector3> least() const;
  /// The one with the largest sum of weight.t, `weights` per pair: a linear programme, exact in the plane; in space
  /// within cones of 16 generators, of which one is the friction that was found. Nothing when it has no end; what was
  /// found when the programme fails, so that nothing is claimed.
  std::optional<std::vector<base::Vector3>> farthest(const std::vector<base::Vector3>& weights) const;

 private:
  using Field = std::vector<base::Vector3>;  // t sqrt(h), pair by pair

  /// The nearest field in equilibrium with the nodal forces of what was found.
  Field balanced(const Field& field) const;
  Field admitted(const Field& field) const;
  /// Tractions of t sqrt(h).
  std::vector<base::Vector3> unscaled(Field field) const;

  const RedundantGroup& group_;
  std::vector<TractionSet> sets_;
  Field found_;
  std::vector<Field> free_;   // orthonormal self-stresses within the hulls
  std::vector<Field> bound_;  // orthonormal basis of what changes nodal forces, within the hulls
};

}  // namespace harmos::latin
