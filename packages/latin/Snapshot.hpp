#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/latin/NaturalSizes.hpp>
#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// The quantities whose accuracy is promised, at one state: all responses, and the fields of interface forces and
/// displacements.
/// The forces are those of nodalForces().
class Snapshot {
 public:
  /// Collective. All load steps must be selected. Keeps nothing of the iterate but the metric of its FixedPoint, which
  /// must outlive it. Throws base::Error (not converged) naming response and load step when a value is not finite.
  Snapshot(const Iterate& state, const std::vector<std::shared_ptr<const Response>>& responses);

  /// Collective. Relative distances [-] to another snapshot, largest over the load steps: one per response, then force
  /// field, then displacement field. Each is measured against its own largest value over the steps, but not against
  /// less than its floor in NaturalSizes. `factors`: of each load step, times which its differences count; empty: 1.
  std::vector<double> distance(const Snapshot& other, const std::vector<double>& factors = {}) const;
  /// What the error of a response, from 0, is relative to [its unit]: its largest value, or its floor.
  double size(std::size_t response) const;
  /// Whether all its values are below its floor.
  bool isSmall(std::size_t response) const { return size(response) <= floors_[response]; }
  /// Per response and load step, in the unit of the response.
  const std::vector<std::vector<double>>& responses() const { return responses_; }

 private:
  const StateMetric* metric_;
  NaturalSizes sizes_;
  std::vector<std::vector<double>> responses_;
  std::vector<double> floors_;
  base::ColumnStore force_;         // sum of h f^ over the interfaces at a node, over the square root of its area
  base::ColumnStore displacement_;  // w times the square root of h, all rows
};

}  // namespace harmos::latin
