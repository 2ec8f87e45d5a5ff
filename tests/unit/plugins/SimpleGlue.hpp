#pragma once

#include <harmos/plugins/LawPlugin.hpp>

/// A law without parameters under the name of one of Harmos's.
struct SimpleGlue {
  static constexpr const char* name = "Linear Elastic";
  static constexpr int historySize = 0;
  static constexpr harmos::laws::Sides sides = harmos::laws::Sides::two;
  static void describe(harmos::input::ParameterSpec&) {}
  explicit SimpleGlue(const harmos::input::Parameters&) {}
  harmos::laws::LocalState solve(const harmos::laws::LocalLine& line, const harmos::laws::NodeContext&, const double*,
                                 double*) const {
    harmos::laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) state.traction[c] = line.freeJump[c] / (1.0 + line.compliance);
    return state;
  }
};
