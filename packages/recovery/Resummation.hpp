#pragma once

#include <vector>

namespace harmos::recovery {

/// What one part adds to a response J and to the change dJ that a finer mesh makes in it [unit of J].
struct PartShare {
  double change = 0.0;        ///< dJ_p, of first order
  double work = 0.0;          ///< W_p = int sigma : C^-1 : zeta dV on this mesh
  double absoluteWork = 0.0;  ///< the sum over the elements of |int sigma : C^-1 : zeta dV|
};

/// A change dJ beyond first order.
struct ResummedChange {
  double change = 0.0;    ///< of J [unit of J]
  bool isBeyond = false;  ///< some part is so stiff that its change is more than what it adds: no converged value shows
};

/// What elements that are too stiff do to a response, beyond the first order.
///
/// A part whose elements are stiffer than it by one factor, K_h = (1 + b) K, shows theta_p = dJ_p / W_p = b / (1 + b):
/// the forces given, what it adds grows from W_p to W_p / (1 - theta_p). That is exact for parts in series, one or
/// many, whichever of them lock, and too much by no more than a factor of two in the estimates for parts side by side.
/// Where work of both signs cancels within a part, theta_p counts the sum of absolute values; parts that are too soft
/// keep dJ_p. With D the sum over the parts, J = J_h + D where J_h grows, and J_h / (1 - D / J_h) where it falls, which
/// is exact for the force between parts in series that are moved by a given amount.
ResummedChange resummed(double value, const std::vector<PartShare>& parts);

}  // namespace harmos::recovery
