#pragma once

namespace harmos::latin {

/// Kinematic unknown of the interfaces.
enum class Formulation {
  displacement,  ///< eq. (24): all load steps at once
  velocity       ///< eqs. (19)-(23): implicit Euler, step after step
};

}  // namespace harmos::latin
