#pragma once

#include <harmos/laws/detail/RigidTool.hpp>

namespace harmos::laws {

/// A rigid tool whose surface has one distance from its middle: from the outside g = r - R and n leads to the middle,
/// for a part inside of the tool g = R - r and n leads away from it, r being the distance of the place from the middle.
class RoundTool : public RigidTool {
 public:
  /// Between nodes on a circle the mean is none of its places: with the mean of their distances, a part that fits the
  /// tool touches it everywhere. Independent of the radius.
  double distanceBeyondMean(const std::vector<base::Vector3>& places, const std::vector<double>& weights,
                            const base::Vector3& mean) const final;

 protected:
  /// Declares Radius, Part Inside, and what all tools have.
  static void describeRound(input::ParameterSpec& p);
  /// Of what describeRound() declares.
  explicit RoundTool(const input::Parameters& p);
  /// From the nearest point of the middle to a place [length].
  virtual base::Vector3 armTo(const base::Vector3& place) const = 0;
  Side sideAt(const base::Vector3& place) const final;

 private:
  double radius_;
  bool isPartInside_;
};

}  // namespace harmos::laws
