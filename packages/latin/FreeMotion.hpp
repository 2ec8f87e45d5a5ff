#pragma once

#include <optional>

#include <harmos/latin/EquilibriumCheck.hpp>
#include <harmos/latin/FixedPoint.hpp>

namespace harmos::latin {

/// What a body that lacks a reaction meets on its way.
struct FreeMotion {
  /// Nothing stops it: the interface laws cannot carry the load, whatever the iteration does.
  bool isFree = false;
  /// Where it is stopped: the state in which it has moved on until the answer is one to two times what it lacks. None
  /// when it is free, or held by less than that.
  std::optional<base::Matrix> landing;
  /// That of the state from which the body was followed, once more.
  const Iterate* iterate = nullptr;
};

/// Follows the body of `imbalance`, if there is one, along the force (or about the moment) that is not balanced.
/// Collective. `rigidBodies` as in largestImbalance(): bodies that move as one are moved together.
///
/// The body is moved so far that interfaces as stiff as the search direction would answer with a million times the
/// imbalance, and a hundred times its own size at least; the local stage tells what they answer. A contact that the way
/// meets at a grazing angle is slid along; bodies that resist are moved as well; where the ground resists, the body is
/// held, and the way is searched for the place. `image` must be T(alpha), `iterate`
/// that of alpha, and `image` is so again afterwards; costs one linear stage per body, turn and place that is looked
/// at, and one.
FreeMotion followImbalance(const Imbalance& imbalance, const std::vector<int>& rigidBodies, FixedPoint& fixedPoint,
                           const Iterate& iterate, const base::Matrix& alpha, base::Matrix& image);

}  // namespace harmos::latin
