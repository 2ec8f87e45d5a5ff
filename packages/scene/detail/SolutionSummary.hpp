#pragma once

#include <harmos/files/SolutionRecord.hpp>
#include <harmos/latin/Iterate.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/scene/detail/InterfaceFields.hpp>

namespace harmos::scene {

/// What a state says of interfaces and parts at load step `step`, from 0, but for stresses. Interfaces between the
/// pieces of a part are left out. Collective; the same on every rank.
files::SolutionRecord summarise(const Problem& problem, const latin::Iterate& state, const InterfaceFields& fields,
                                int step);

}  // namespace harmos::scene
