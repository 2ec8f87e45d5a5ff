#pragma once

#include <harmos/base/Error.hpp>
#include <harmos/elasticity/detail/ElementFault.hpp>
#include <harmos/elasticity/detail/ElementIntegrals.hpp>
#include <harmos/elasticity/detail/PartElements.hpp>

namespace harmos::elasticity {

/// Calls visit(group, number in the group, basis, integrals) for every element of a part; throws base::Error that
/// counts the ones that are turned inside out or have no volume, and names the first.
template <class Visitor>
void forEachElement(const mesh::Mesh& mesh, const mesh::Piece& piece, const std::vector<ElementGroup>& groups,
                    Formulation formulation, Kinematics kinematics, bool withProduct, const Visitor& visit) {
  ElementIntegrals integrals;
  ElementFaults faults(mesh, piece);
  for (const ElementGroup& group : groups) {
    const ElementBasis basis(group.block->type, formulation, kinematics);
    const auto perElement = static_cast<std::size_t>(basis.reference.nodes);
    for (int number = 0; number < group.elements(); ++number) {
      const base::Vector3* places[ElementIntegrals::maximumFunctions];
      const int* nodes =
          group.block->connectivity.data() + static_cast<std::size_t>(group.inBlock[number]) * perElement;
      for (std::size_t a = 0; a < perElement; ++a) places[a] = &mesh.nodes[nodes[a]];
      if (integrate(basis, places, withProduct, integrals)) {
        visit(group, number, basis, integrals);
      } else {
        faults.add(group, number);
      }
    }
  }
  faults.throwIfAny();
}

}  // namespace harmos::elasticity
