#pragma once

#include <vector>

#include <harmos/assembly/Assembly.hpp>

namespace harmos::latin {

/// Resultant, moment about the first node and sum of absolute forces of a body at a load step.
inline constexpr std::size_t sumsPerStep = 7;

/// Per load step of an assembly a number that those have in common at which all laws can carry the same; they are
/// counted from 0 in the order in which they come.
std::vector<int> sameLaws(const assembly::Assembly& assembly);

/// Per load step the sum of absolute forces on all bodies [force]. `sums`: as of largestLike().
std::vector<double> sizesOfLoads(const assembly::Assembly& assembly, const std::vector<double>& sums);

/// Per load step the largest of those with the same laws whose loads are the same but for a factor, the first of those
/// that are equally large; -1: no loads. The time grows little faster than the number of load steps. `laws`: as of
/// sameLaws(); `sums`: sumsPerStep of every body and load step.
std::vector<int> largestLike(const assembly::Assembly& assembly, const std::vector<int>& laws,
                             const std::vector<double>& sums);

}  // namespace harmos::latin
