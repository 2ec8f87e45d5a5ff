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

std::vector<base::Vector3> placesOfForces(const assembly::Interface& interface, std::vector<base::Vector3> places) {
  if (interface.mass.empty()) return places;
  std::vector<base::Vector3> sums(places.size());
  std::vector<double> areas(places.size(), 0.0);
  for (const mesh::MassEntry& entry : interface.mass) {
    sums[entry.column] = sums[entry.column] + entry.value * places[entry.row];
    areas[entry.column] += entry.value;
  }
  for (std::size_t p = 0; p < places.size(); ++p) places[p] = (1.0 / areas[p]) * sums[p];
  return places;
}

}  // namespace harmos::latin
