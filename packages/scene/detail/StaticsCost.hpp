#pragma once

#include <Teuchos_Comm.hpp>

#include <harmos/assembly/Assembly.hpp>

namespace harmos::scene {

/// What rigid statics (latin::LoadBalance) are asked before an iteration, and of what is held after it.
struct StaticsSize {
  double joints = 0.0;      ///< pairs between rigid bodies, and between them and the ground
  double rows = 0.0;        ///< resultants of all rigid bodies that are to be balanced
  double columns = 0.0;     ///< what a linear programme may choose: pressures, rays of friction, what it leaves over
  double programmes = 0.0;  ///< one for all load steps whose loads are the same but for a factor

  /// CPU time [s] of all of it, in a run of so many load steps.
  double seconds(double steps) const;
};

/// Collective: adds up the loads of the assembly, as a run does.
StaticsSize staticsOf(const assembly::Assembly& assembly, const Teuchos::Comm<int>& comm);

}  // namespace harmos::scene
