#pragma once

#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/base/Matrix.hpp>

namespace harmos::latin {

/// y = h x for one interface side: `x` and `y` hold pairs x dimension rows, node by node, in one column; they must
/// differ. h: the consistent interface mass where there is one, else the areas of the pairs [area].
void applyMass(const assembly::Interface& interface, int dimension, const double* x, double* y);

/// Places at which the forces h_p t_p of the pairs act [length], given those of the pairs: with a consistent mass the
/// means of those weighted by its rows, so that moments are the integrals; else the same.
std::vector<base::Vector3> placesOfForces(const assembly::Interface& interface, std::vector<base::Vector3> places);

}  // namespace harmos::latin
