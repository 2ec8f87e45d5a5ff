#pragma once

#include <vector>

#include <harmos/laws/InterfaceLaw.hpp>
#include <harmos/laws/detail/TangentialSlip.hpp>

namespace harmos::laws {

/// What laws have in common that lose work in one slider and nowhere else. History: SlipMemory, and what a law adds.
struct SlidingLaw {
  static constexpr int historySize = SlipMemory::size;
  static constexpr Sides sides = Sides::any;
  static constexpr bool dissipates = true;

  /// All but the traction times the slip [stress length].
  static double keptWork(const PairStep& step) { return step.work() - SlipMemory::lostWork(step); }
  /// The way of the slider.
  static std::vector<OutputField> outputs() { return {{"accumulated_slip", "length", "way that the slider has slid"}}; }
  static void output(const PairStep& step, double* values) { values[0] = SlipMemory::way(step.history); }

  /// The same before fields of a law's own.
  static std::vector<OutputField> outputsAnd(const std::vector<OutputField>& fields) {
    std::vector<OutputField> all = outputs();
    all.insert(all.end(), fields.begin(), fields.end());
    return all;
  }
};

}  // namespace harmos::laws
