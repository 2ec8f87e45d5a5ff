#pragma once

#include <limits>

#include <harmos/base/Vector3.hpp>

namespace harmos::laws {

/// The tractions that a law can give at a load step, whatever the jump, the gap and the history: a box, and friction.
///
/// t lies in it when lower <= (t_n, t_t1, t_t2) <= upper, where the tangential part may go beyond by a vector of at
/// most friction |t_n|. Made without arguments it holds every traction. 0 lies in it.
struct AdmissibleTractions {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();  ///< [stress]

  base::Vector3 lower{-unlimited, -unlimited, -unlimited};  ///< [stress], in the law's frame, <= 0
  base::Vector3 upper{unlimited, unlimited, unlimited};     ///< [stress], the same, >= 0
  double friction = 0.0;  ///< most of |t_t| per |t_n|, where t_n < 0 and the frame is that of the interface [-]
  /// Whether a pair that sticks admits all that friction allows, and one that slides has all of it. Of other laws
  /// direction, velocity or pressure tells how much of it there is.
  bool isCone = true;

  /// Each component takes any value or none.
  static AdmissibleTractions components(bool n, bool t1, bool t2) {
    const double a = n ? unlimited : 0.0, b = t1 ? unlimited : 0.0, c = t2 ? unlimited : 0.0;
    return {{-a, -b, -c}, {a, b, c}, 0.0, true};
  }
  /// t_n <= 0 of any size, |t_t| <= mu |t_n|.
  static AdmissibleTractions pressure(double mu) { return {{-unlimited, 0.0, 0.0}, {0.0, 0.0, 0.0}, mu, true}; }
  /// t_n <= 0 of any size, |t_t| <= mu |t_n| at most.
  static AdmissibleTractions pressureAtMost(double mu) { return {{-unlimited, 0.0, 0.0}, {0.0, 0.0, 0.0}, mu, false}; }

  /// Whether component i takes any value.
  bool isAny(std::size_t i) const { return lower[i] == -unlimited && upper[i] == unlimited; }
  /// Whether every traction is admissible.
  bool isAny() const { return isAny(0) && isAny(1) && isAny(2); }
};

}  // namespace harmos::laws
