#pragma once

#include <harmos/laws/detail/NormalSpring.hpp>
#include <harmos/laws/detail/SlidingLaw.hpp>

namespace harmos::laws {

/// Tangential elastoplasticity beside a normal spring: t_t = k_t (delta_t - s), |t_t - h_k s| <= tau + h_i p, with the
/// slip s along t_t - h_k s and p the length of its way. History: SlipMemory.
struct ElasticSlider : SlidingLaw {
  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    SlipLimit limit = slider;
    limit.limit += slider.isotropic * SlipMemory::way(old);
    const SlipState slip = slipOnLine(line, compliance, SlipMemory::slip(old), limit);
    SlipMemory::keep(slip.slip, slip.distance, old, now);
    return {{normal.traction(line, at.gap), slip.traction.t1, slip.traction.t2},
            slip.slides ? Status::slip : Status::stick};
  }

  /// All but what the slider takes; what hardens by kinematic h_k stays as energy, what hardens by h_i is lost.
  double keptWork(const PairStep& step) const { return step.work() - SlipMemory::lostWork(step, slider.kinematic); }
  double storedEnergy(const PairStep& step) const {
    const double shear = Tangential::of(step.traction).norm(), slip = SlipMemory::slip(step.history).norm();
    return normal.energy(step.traction[0]) + 0.5 * (compliance * shear * shear + slider.kinematic * slip * slip);
  }

  ElasticSlider(const NormalSpring& spring, double springCompliance, const SlipLimit& limit)
      : normal(spring), compliance(springCompliance), slider(limit) {}

  NormalSpring normal;
  double compliance;  ///< 1 / k_t [length/stress]
  SlipLimit slider;   ///< tau, h_i, h_k
};

}  // namespace harmos::laws
