#include <harmos/mesh/MeshSize.hpp>

namespace harmos::mesh {
namespace {

struct PerElement {
  double nodes, neighbours;
};

/// Counted in meshes that repeat one cell.
PerElement of(ElementType type) {
  switch (type) {
    case ElementType::tri3:
      return {0.5, 7.0};
    case ElementType::quad4:
      return {1.0, 9.0};
    case ElementType::tet4:
      return {1.0 / 6.0, 15.0};
    case ElementType::pyramid5:
      return {1.0 / 3.0, 18.0};
    case ElementType::wedge6:
      return {0.5, 21.0};
    case ElementType::hex8:
      return {1.0, 27.0};
    case ElementType::tri6:
      return {2.0, 11.5};
    case ElementType::quad8:
      return {3.0, 47.0 / 3.0};
    case ElementType::quad9:
      return {4.0, 16.0};
    case ElementType::tet10:
      return {8.0 / 6.0, 28.75};
    case ElementType::wedge15:
      return {2.5, 44.2};
    case ElementType::hex20:
      return {4.0, 58.5};
    case ElementType::hex27:
      return {8.0, 64.0};
  }
  return {};
}

}  // namespace

double nodesForElement(ElementType type) {
  return of(type).nodes;
}

double meanNeighbours(ElementType type) {
  return of(type).neighbours;
}

}  // namespace harmos::mesh
