#include <harmos/latin/detail/GivenLoads.hpp>

#include <algorithm>

#include <harmos/latin/PrescribedForces.hpp>
#include <harmos/latin/detail/IsZero.hpp>

namespace harmos::latin {
namespace {

/// Room for all dofs of a body, where there is none yet.
base::Matrix& room(const assembly::Assembly& assembly, int body, std::vector<base::Matrix>& fields) {
  base::Matrix& field = fields[body];
  if (field.numCols() > 0) return field;
  const auto nodes = static_cast<int>(assembly.bodies[body].nodes.size());
  field.shape(nodes * assembly.dimension, assembly.loadCases());
  return field;
}

bool isScaled(const assembly::Assembly& assembly, std::size_t interfaceIndex) {
  return assembly.path && assembly.path->scales(static_cast<int>(interfaceIndex));
}

}  // namespace

GivenLoads::GivenLoads(const assembly::Assembly& assembly, const EliminatedBoundaries& eliminated,
                       const ReferenceMotions* reference, const std::vector<bool>& owned)
    : forces_(owned.size()), places_(owned.size()), tractions_(assembly.interfaces.size()) {
  const int dimension = assembly.dimension, cases = assembly.loadCases();
  for (std::size_t b = 0; b < owned.size(); ++b) {
    const int body = static_cast<int>(b);
    const auto& nodes = eliminated.nodes(body);
    if (!owned[b] || nodes.empty()) continue;
    for (base::Matrix* field : {&forces_[b], &places_[b]})
      field->shape(dimension * static_cast<int>(nodes.size()), cases);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      for (int t = 0; t < cases; ++t) {
        base::Vector3 force = eliminated.force(body, n, t);
        base::Vector3 place = eliminated.held(body, n, t);
        if (reference != nullptr && !reference->isEmpty()) {
          const int node = nodes[n].node;
          force = force - base::product(nodes[n].springs, reference->at(body, node, t));
          const base::Vector3 below = reference->below(place, body, node, t);
          place = below - base::product(nodes[n].free, below);
        }
        const auto row = static_cast<std::ptrdiff_t>(n) * dimension;
        std::copy_n(force.begin(), dimension, forces_[b][t] + row);
        std::copy_n(place.begin(), dimension, places_[b][t] + row);
      }
    }
  }
  for (std::size_t i = 0; i < tractions_.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (!interface.law->prescribesTraction() || !owned[interface.body1]) continue;
    tractions_[i].shape(interface.pairs() * dimension, isScaled(assembly, i) ? 1 : assembly.steps());
    for (int t = 0; t < tractions_[i].numCols(); ++t) {
      const std::vector<double> forces = prescribedForces(interface, assembly.times, dimension, t);
      std::copy(forces.begin(), forces.end(), tractions_[i][t]);
    }
  }
}

bool GivenLoads::operator==(const GivenLoads& other) const {
  return forces_ == other.forces_ && places_ == other.places_ && tractions_ == other.tractions_;
}

void GivenLoads::addTo(const assembly::Assembly& assembly, const EliminatedBoundaries& eliminated,
                       std::vector<base::Matrix>& loads, std::vector<base::Matrix>& held) const {
  const int dimension = assembly.dimension;
  for (std::size_t b = 0; b < forces_.size(); ++b) {
    if (forces_[b].numCols() == 0) continue;
    const int body = static_cast<int>(b);
    const auto& nodes = eliminated.nodes(body);
    const auto add = [&](const base::Matrix& values, std::vector<base::Matrix>& fields) {
      if (isZero(values)) return;
      base::Matrix& field = room(assembly, body, fields);
      for (int t = 0; t < values.numCols(); ++t) {
        for (std::size_t n = 0; n < nodes.size(); ++n) {
          for (int c = 0; c < dimension; ++c) {
            field[t][nodes[n].node * dimension + c] += values[t][static_cast<int>(n) * dimension + c];
          }
        }
      }
    };
    add(forces_[b], loads);
    add(places_[b], held);
  }
  for (std::size_t i = 0; i < tractions_.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    const base::Matrix& forces = tractions_[i];
    if (forces.numCols() == 0) continue;
    base::Matrix& sums = room(assembly, interface.body1, loads);
    for (int t = 0; t < forces.numCols(); ++t) {
      interface.trace1.addTransposed(dimension, forces[t], sums[isScaled(assembly, i) ? assembly.steps() : t]);
    }
  }
}

}  // namespace harmos::latin
