#pragma once

#include <vector>

#include <harmos/assembly/Interface.hpp>

namespace harmos::latin {

/// What a law that prescribes its traction says of all pairs of a boundary at load step `step` (from 0) of those that
/// end at `times`, in the frame of the law. Not collective.
std::vector<laws::LocalState> prescribedStates(const assembly::Interface& interface, const std::vector<double>& times,
                                               int step);

/// The tractions of all pairs [stress], global components. Not collective.
std::vector<base::Vector3> prescribedTractions(const assembly::Interface& interface, const std::vector<double>& times,
                                               int step);

/// Nodal forces h f [force] of a boundary whose law prescribes its traction: pairs x dimension, global components.
/// `step`: load step, from 0. Not collective.
std::vector<double> prescribedForces(const assembly::Interface& interface, const std::vector<double>& times,
                                     int dimension, int step);

}  // namespace harmos::latin
