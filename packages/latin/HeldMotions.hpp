#pragma once

#include <array>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/EliminatedBoundaries.hpp>

namespace harmos::latin {

/// Which rigid motions of each body its eliminated boundaries hold, or its own stiffness around an axis.
///
/// A motion is a translation and a rotation about the body's centre, a resultant a force and a moment about it, six
/// numbers each. With G the stiffness of search directions (sum of h k), of boundaries and of the body itself against
/// motions, held motions are those in which the latter two make up more than half of G; the others, V with V^T G V = 1,
/// are free.
class HeldMotions {
 public:
  /// Three components of translation [length] or force, three of rotation or moment.
  using Sixfold = std::array<double, 6>;

  /// Not collective; the same on every rank. `resisted`: see resistedInPlane().
  HeldMotions(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
              const EliminatedBoundaries& eliminated, const std::vector<ResistedMotions>& resisted);

  /// Centre of a body's nodes' extent [length], on the axis of a body that can turn about it alone.
  const base::Vector3& centre(int body) const { return bodies_[body].centre; }
  /// Largest extent of a body, and no less than its reach from the centre along an axis [length].
  double extent(int body) const { return bodies_[body].extent; }
  /// What of a resultant works in the free motions: G V V^T r.
  Sixfold freePart(int body, const Sixfold& resultant) const;
  /// The free part of a motion: V V^T G v.
  Sixfold freeMotion(int body, const Sixfold& motion) const;
  /// Share of a motion that is held, |v - V V^T G v| / |v|, rotations in units of the extent.
  double heldShare(int body, const Sixfold& motion) const;
  /// How many times softer than search directions at all its interfaces and boundaries a body is held, in the motion
  /// that is resisted least [-]; the largest of all bodies with eliminated boundaries, 1 at least.
  double softness() const { return softness_; }
  /// What springs of eliminated boundaries are against motions of a body, v^T S v = 2 x energy; 0 x 0: it has none.
  const base::Matrix& springs(int body) const { return bodies_[body].springs; }

 private:
  struct Body {
    base::Vector3 centre{};
    double extent = 0.0;
    bool isHeld = false;     // any motion is
    base::Matrix stiffness;  // G, rotations in units of the extent
    base::Matrix springs;    // of boundaries, rotations as they are; empty: none
    base::Matrix free;       // V
  };
  std::vector<Body> bodies_;
  double softness_ = 1.0;
};

}  // namespace harmos::latin
