#pragma once

#include <string>

#include <harmos/scene/Problem.hpp>

namespace harmos::scene {

/// What helps a part whose fully integrated elements lock because its material is nearly incompressible (from Poisson's
/// ratio 0.49 on), to be said after the part's name; empty: it is not, or nothing is to be done. `body`: one of the
/// part.
std::string lockingRemedy(const Problem& problem, int body);

}  // namespace harmos::scene
