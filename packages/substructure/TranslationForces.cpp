#include <harmos/substructure/TranslationForces.hpp>

#include <cmath>

namespace harmos::substructure {
namespace {

// Of the sum of absolute values: what a row makes of a translation is round-off below it.
constexpr double limit = 1e-13;

}  // namespace

TranslationForces translationForces(const CrsView& stiffness, int dimension) {
  TranslationForces forces;
  for (int row = 0; row < stiffness.rows; ++row) {
    long double sums[3] = {0.0L, 0.0L, 0.0L};
    double terms = 0.0;
    for (std::size_t k = stiffness.rowPointers[row]; k < stiffness.rowPointers[row + 1]; ++k) {
      sums[stiffness.columns[k] % dimension] += stiffness.values[k];
      terms += std::abs(stiffness.values[k]);
    }
    for (int c = 0; c < dimension; ++c) {
      if (sums[c] == 0.0L) continue;
      std::vector<double>& to = std::abs(sums[c]) <= limit * terms ? forces.roundOff : forces.resistance;
      to.resize(static_cast<std::size_t>(stiffness.rows) * dimension, 0.0);
      to[static_cast<std::size_t>(row) * dimension + c] = static_cast<double>(sums[c]);
    }
  }
  return forces;
}

}  // namespace harmos::substructure
