#pragma once

#include <vector>

#include <harmos/latin/NaturalSizes.hpp>
#include <harmos/stochastic/ResponseSampler.hpp>

namespace harmos::stochastic {

/// The quantities whose accuracy is promised, at one state on modal columns: the coefficients of all responses and of
/// the fields of interface forces and displacements.
class ChaosSnapshot {
 public:
  /// Collective. `state`: on all modal columns; its metric must outlive this object. `terms`: polynomials.
  ChaosSnapshot(const latin::Iterate& state, const ResponseSampler& sampler,
                const std::vector<std::shared_ptr<const latin::Response>>& responses, int terms);

  /// Collective. Relative distances [-] to another snapshot: one per response, then force field, then displacement
  /// field.
  ///
  /// Each is the larger of two: the difference of the means over the largest mean of all load steps, and the standard
  /// deviation of the difference over the largest standard deviation. A mean does not count as less than its floor in
  /// latin::NaturalSizes, and a standard deviation not as less than 1e-3 of the mean.
  std::vector<double> distance(const ChaosSnapshot& other) const;
  /// Terms x load steps of a response, in its unit.
  const base::Matrix& response(std::size_t i) const { return quantities_[i].coefficients; }

 private:
  struct Quantity {
    base::Matrix coefficients;   // (terms x rows) x load steps: row r of polynomial a is number a * rows + r
    double floor = 0.0;          // of the mean
    bool isDistributed = false;  // every rank has its rows
  };

  double distance(const Quantity& mine, const Quantity& other) const;

  const latin::StateMetric& metric_;
  int terms_;
  std::vector<Quantity> quantities_;
};

}  // namespace harmos::stochastic
