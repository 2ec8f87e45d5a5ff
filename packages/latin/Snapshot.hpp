#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// The quantities whose accuracy is promised, at one state: all responses, and the fields of interface forces and
/// displacements.
class Snapshot {
 public:
  /// Collective. Reads the last FixedPoint::apply().
  Snapshot(const FixedPoint& state, const std::vector<std::shared_ptr<const Response>>& responses);

  /// Relative distances to another snapshot, largest over the load steps: one per response, then force field, then
  /// displacement field. A response is measured against its own largest value over the steps, but not against less than
  /// 1e-3 of the natural size of its kind (largest interface displacement, largest sum of interface forces).
  std::vector<double> distance(const Snapshot& other) const;
  const std::vector<std::vector<double>>& responses() const { return responses_; }

 private:
  double fieldDistance(const base::Matrix& a, const base::Matrix& b) const;

  const FixedPoint* state_;
  std::vector<std::vector<double>> responses_;
  std::vector<double> floors_;
  base::Matrix force_;         // f^, all rows
  base::Matrix displacement_;  // w, all rows
};

}  // namespace harmos::latin
