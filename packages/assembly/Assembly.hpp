#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/assembly/PathControl.hpp>
#include <harmos/substructure/Substructure.hpp>

/// Bodies joined by interfaces, and the search directions between them.
namespace harmos::assembly {

/// Elastic bodies joined by interfaces, and the times of the load steps: all that LATIN needs to know.
///
/// The lists are the same on every rank; a rank holds the stiffness matrices of the bodies that it owns.
struct Assembly {
  int dimension = 3;                               ///< 2 or 3, that of all bodies
  std::vector<substructure::Substructure> bodies;  ///< their positions are the numbers of the bodies
  std::vector<Interface> interfaces;               ///< of all bodies, whoever owns them
  std::vector<double> times;        ///< end of each load step, ascending; the unloaded start at time 0 is not listed
  std::vector<int> owner;           ///< rank that owns each body; empty: rank 0 owns all
  std::optional<PathControl> path;  ///< absent: all loads are given

  /// How many load steps there are.
  int steps() const { return static_cast<int>(times.size()); }
  /// Every law is affine, so that both stages are affine maps.
  bool isAffine() const {
    return std::all_of(interfaces.begin(), interfaces.end(), [](const Interface& one) { return one.law->isAffine(); });
  }
  /// The law of some interface is not monotone, so that there may be several solutions.
  bool softens() const {
    return std::any_of(interfaces.begin(), interfaces.end(),
                       [](const Interface& one) { return one.law->lowestSlope() < 0.0; });
  }
  /// Loads and the response to one load factor: the load steps, and the loads that a PathControl multiplies as one
  /// more.
  int loadCases() const { return steps() + (path ? 1 : 0); }
  /// Rank that owns a body.
  int ownerOf(int body) const { return owner.empty() ? 0 : owner[body]; }
};

}  // namespace harmos::assembly
