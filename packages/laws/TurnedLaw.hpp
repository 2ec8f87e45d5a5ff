#pragma once

#include <vector>

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
  /// Whether the first axis must point out of the part at every place.
  virtual bool isOutside() const { return false; }
  /// For a point that moves by the mean of some nodes: by how much the mean of the distances that the law measures
  /// along its first axis at their undeformed `places`, with these weights, exceeds the distance at the mean of the
  /// places [all length]. The weights add up to 1 and may be negative. Becomes the gap of the point.
  virtual double distanceBeyondMean(const std::vector<base::Vector3>& /*places*/,
                                    const std::vector<double>& /*weights*/, const base::Vector3& /*mean*/) const {
    return 0.0;
  }
  /// Throws base::Error(input), without a place of the scene, in models where the law has no meaning.
  virtual void demandModel(int /*dimension*/, bool /*isAxisymmetric*/) const {}
  /// Throws base::Error(input), without a place of the scene, when the law cannot act at these undeformed places
  /// [length], in so many load steps.
  virtual void demandPlaces(const std::vector<base::Vector3>& places, int /*steps*/) const {
    for (const base::Vector3& place : places) axesAt(place);
  }
};

}  // namespace harmos::laws
