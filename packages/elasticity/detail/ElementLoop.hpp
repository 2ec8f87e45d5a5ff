#pragma once

#include <harmos/base/Error.hpp>
#include <harmos/elasticity/detail/ElementIntegrals.hpp>
#include <harmos/elasticity/detail/PartElements.hpp>

namespace harmos::elasticity {

/// Calls visit(group, number in the group, integrals) for every element of a part; throws base::Error naming the first
/// one that is turned inside out or has no volume.
template <class Visitor>
void forEachElement(const mesh::Mesh& mesh, const mesh::Piece& piece, const std::vector<ElementGroup>& groups,
                    bool withProduct, const Visitor& visit) {
  ElementIntegrals integrals;
  for (const ElementGroup& group : groups) {
    const ReferenceElement reference = referenceElement(group.block->type);
    const auto perElement = static_cast<std::size_t>(reference.nodes);
    for (int number = 0; number < group.elements(); ++number) {
      const base::Vector3* corners[ElementIntegrals::maximumNodes];
      const int* nodes =
          group.block->connectivity.data() + static_cast<std::size_t>(group.inBlock[number]) * perElement;
      for (std::size_t a = 0; a < perElement; ++a) corners[a] = &mesh.nodes[nodes[a]];
      if (!integrate(reference, corners, withProduct, integrals)) {
        throw base::Error("Jacobian not positive in " + nameOf(mesh, piece, group, number) +
                              ": the element is turned inside out, folded, or has no volume. Check the order of its "
                              "nodes and their coordinates.",
                          base::ExitCode::input);
      }
      visit(group, number, integrals);
    }
  }
}

}  // namespace harmos::elasticity
