#pragma once

#include <string>
#include <vector>

#include <harmos/latin/Iterate.hpp>
#include <harmos/latin/Response.hpp>

namespace harmos::scene {

/// An interface with friction that is about to slide as a whole.
struct NearSliding {
  std::string name;                       ///< in the scene
  double reserve = 0.0;                   ///< 1 - sum of h |t_t| / sum of h mu |t_n| [-]
  double clamping = 0.0;                  ///< sum of h |t_n| [force]
  latin::ResponseGradient gradient = {};  ///< of the clamping at the load step
};

/// Those interfaces at a load step of `state` that have less than a fifth of their friction left; of several the two
/// that carry most. Collective, all load steps selected.
std::vector<NearSliding> findNearSliding(const latin::Iterate& state, int step);

/// For the user: interface "seat" has 5 % left to sliding, its clamping is 9 % uncertain.
std::string describe(const NearSliding& interface, double uncertainty);

}  // namespace harmos::scene
