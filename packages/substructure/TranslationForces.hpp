#pragma once

#include <vector>

#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::substructure {

/// What a stiffness makes of translations: K [force/length] times unit translations, for each row one force per
/// component, row * dimension + component. Without supports it should be nothing.
struct TranslationForces {
  std::vector<double> resistance;  ///< where K does resist them, as in axisymmetry; empty: nowhere
  std::vector<double> roundOff;    ///< below 1e-13 of the terms of a row, where its entries are rounded; empty: nowhere
};

/// Sums are found in extended precision. dimension: dofs per node, 2 or 3.
TranslationForces translationForces(const CrsView& stiffness, int dimension);

}  // namespace harmos::substructure
