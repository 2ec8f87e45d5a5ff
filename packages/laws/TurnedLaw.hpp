#pragma once

#include <harmos/base/Tensor3.hpp>
#include <harmos/base/Vector3.hpp>

namespace harmos::laws {

/// What an InterfaceLaw is besides that sees jumps and tractions in axes of its own, which turn from place to place:
/// these stand for (n, t1, t2) of Frame::interface, whoever puts it on an interface.
class TurnedLaw {
 public:
  virtual ~TurnedLaw() = default;
  /// Rows: its axes at an undeformed place [length]. Throws base::Error(input), without a place, where there are none.
  virtual base::Frame axesAt(const base::Vector3& place) const = 0;
};

}  // namespace harmos::laws
