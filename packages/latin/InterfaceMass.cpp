#include <harmos/latin/InterfaceMass.hpp>

namespace harmos::latin {

void applyMass(const assembly::Interface& interface, int dimension, const double* x, double* y) {
  if (interface.mass.empty()) {
    for (int p = 0; p < interface.pairs(); ++p) {
      for (int c = 0; c < dimension; ++c) {
        y[p * dimension + c] = interface.area[p] * x[p * dimension + c];
      }
    }
    return;
  }
  std::fill(y, y + interface.pairs() * dimension, 0.0);
  for (const mesh::MassEntry& entry : interface.mass) {
    for (int c = 0; c < dimension; ++c) y[entry.row * dimension + c] += entry.value * x[entry.column * dimension + c];
  }
}

}  // namespace harmos::latin
