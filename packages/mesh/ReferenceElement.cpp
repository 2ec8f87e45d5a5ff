#include <harmos/mesh/ReferenceElement.hpp>

#include <memory>
#include <utility>

#include <Intrepid2_DefaultCubatureFactory.hpp>
#include <Intrepid2_HGRAD_HEX_C1_FEM.hpp>
#include <Intrepid2_HGRAD_HEX_C2_FEM.hpp>
#include <Intrepid2_HGRAD_PYR_C1_FEM.hpp>
#include <Intrepid2_HGRAD_QUAD_C1_FEM.hpp>
#include <Intrepid2_HGRAD_QUAD_C2_FEM.hpp>
#include <Intrepid2_HGRAD_TET_C1_FEM.hpp>
#include <Intrepid2_HGRAD_TET_C2_FEM.hpp>
#include <Intrepid2_HGRAD_TRI_C1_FEM.hpp>
#include <Intrepid2_HGRAD_TRI_C2_FEM.hpp>
#include <Intrepid2_HGRAD_WEDGE_C1_FEM.hpp>
#include <Intrepid2_HGRAD_WEDGE_C2_FEM.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::mesh {
namespace {

using Device = Kokkos::Device<Kokkos::Serial, Kokkos::HostSpace>;
using Array = Kokkos::DynRankView<double, Device>;
using Basis = Intrepid2::Basis<Device, double, double>;

/// The basis of Intrepid2 that spans the functions of an element or more.
std::unique_ptr<const Basis> basisOf(ElementType type) {
  switch (type) {
    case ElementType::tri3:
      return std::make_unique<Intrepid2::Basis_HGRAD_TRI_C1_FEM<Device>>();
    case ElementType::quad4:
      return std::make_unique<Intrepid2::Basis_HGRAD_QUAD_C1_FEM<Device>>();
    case ElementType::tet4:
      return std::make_unique<Intrepid2::Basis_HGRAD_TET_C1_FEM<Device>>();
    case ElementType::pyramid5:
      return std::make_unique<Intrepid2::Basis_HGRAD_PYR_C1_FEM<Device>>();
    case ElementType::wedge6:
      return std::make_unique<Intrepid2::Basis_HGRAD_WEDGE_C1_FEM<Device>>();
    case ElementType::hex8:
      return std::make_unique<Intrepid2::Basis_HGRAD_HEX_C1_FEM<Device>>();
    case ElementType::tri6:
      return std::make_unique<Intrepid2::Basis_HGRAD_TRI_C2_FEM<Device>>();
    case ElementType::quad8:
    case ElementType::quad9:
      return std::make_unique<Intrepid2::Basis_HGRAD_QUAD_C2_FEM<Device>>();
    case ElementType::tet10:
      return std::make_unique<Intrepid2::Basis_HGRAD_TET_C2_FEM<Device>>();
    case ElementType::wedge15:
      return std::make_unique<Intrepid2::Basis_HGRAD_WEDGE_C2_FEM<Device>>();
    case ElementType::hex20:
    case ElementType::hex27:
      return std::make_unique<Intrepid2::Basis_HGRAD_HEX_C2_FEM<Device>>();
  }
  throw base::Error("Unknown element type.");
}

/// Degrees that the rule integrates exactly; of wedges on the triangle and upright.
std::vector<int> degreesOf(ElementType type) {
  switch (type) {
    case ElementType::tri3:
    case ElementType::tet4:
      return {1};
    case ElementType::wedge6:
      return {2, 2};
    case ElementType::tri6:
      return {4};
    case ElementType::wedge15:
      return {4, 5};
    case ElementType::quad4:
    case ElementType::pyramid5:
    case ElementType::hex8:
      return {3, 3, 3};
    default:
      return {5, 5, 5};
  }
}

/// A node of the full basis that a serendipity element lacks, and what its value is in terms of those it has.
struct Dependent {
  int node;
  std::vector<std::pair<int, double>> weights;
};

/// In the middle of a face with all its edges: -1/4 of the corners, 1/2 of the middles of edges.
Dependent middleOfFace(int node, const int* corners, const int* middles) {
  Dependent middle{node, {}};
  for (int i = 0; i < 4; ++i) {
    middle.weights.emplace_back(corners[i], -0.25);
    middle.weights.emplace_back(middles[i], 0.5);
  }
  return middle;
}

std::vector<Dependent> dependentsOf(ElementType type) {
  std::vector<Dependent> dependents;
  const auto addFaces = [&](const CellTopologyData& full) {
    for (unsigned side = 0; side < full.side_count; ++side) {
      const auto& face = full.side[side];
      if (face.topology->node_count == 9) {
        const std::vector<int> nodes(face.node, face.node + 9);
        dependents.push_back(middleOfFace(nodes[8], nodes.data(), nodes.data() + 4));
      }
    }
  };
  if (type == ElementType::quad8) {
    const int nodes[] = {0, 1, 2, 3, 4, 5, 6, 7};
    dependents.push_back(middleOfFace(8, nodes, nodes + 4));
  } else if (type == ElementType::wedge15) {
    addFaces(*shards::getCellTopologyData<shards::Wedge<18>>());
  } else if (type == ElementType::hex20) {
    addFaces(*shards::getCellTopologyData<shards::Hexahedron<27>>());
    Dependent centre{20, {}};
    for (int corner = 0; corner < 8; ++corner) centre.weights.emplace_back(corner, -0.25);
    for (int middle = 8; middle < 20; ++middle) centre.weights.emplace_back(middle, 0.25);
    dependents.push_back(std::move(centre));
  }
  return dependents;
}

void evaluate(ElementType type, const Basis& basis, const Array& places, ShapeFunctions& result) {
  const int all = basis.getCardinality();
  result.dimension = dimensionOf(type);
  result.nodes = nodesPerElement(type);
  result.points = static_cast<int>(places.extent(0));
  Array values("values", all, result.points);
  Array gradients("gradients", all, result.points, result.dimension);
  basis.getValues(values, places, Intrepid2::OPERATOR_VALUE);
  basis.getValues(gradients, places, Intrepid2::OPERATOR_GRAD);
  for (const Dependent& dependent : dependentsOf(type)) {
    for (const auto& [node, weight] : dependent.weights) {
      for (int p = 0; p < result.points; ++p) {
        values(node, p) += weight * values(dependent.node, p);
        for (int j = 0; j < result.dimension; ++j) gradients(node, p, j) += weight * gradients(dependent.node, p, j);
      }
    }
  }
  for (int p = 0; p < result.points; ++p) {
    for (int a = 0; a < result.nodes; ++a) {
      result.value.push_back(values(a, p));
      for (int j = 0; j < result.dimension; ++j) result.gradient.push_back(gradients(a, p, j));
    }
  }
}

std::vector<base::Vector3> toPlaces(const Array& array, int count, int dimension) {
  std::vector<base::Vector3> places(count);
  for (int p = 0; p < count; ++p) {
    for (int j = 0; j < dimension; ++j) places[p][j] = array(p, j);
  }
  return places;
}

}  // namespace

ReferenceElement referenceElement(ElementType type) {
  const auto basis = basisOf(type);
  const auto cubature =
      Intrepid2::DefaultCubatureFactory::create<Device, double, double>(basis->getBaseCellTopology(), degreesOf(type));
  const int count = cubature->getNumPoints(), dimension = dimensionOf(type);
  Array places("places", count, dimension), weights("weights", count);
  cubature->getCubature(places, weights);
  ReferenceElement element;
  evaluate(type, *basis, places, element);
  element.place = toPlaces(places, count, dimension);
  for (int p = 0; p < count; ++p) element.weight.push_back(weights(p));
  return element;
}

ShapeFunctions shapeFunctions(ElementType type, const std::vector<base::Vector3>& places) {
  Array array("places", places.size(), dimensionOf(type));
  for (std::size_t p = 0; p < places.size(); ++p) {
    for (int j = 0; j < dimensionOf(type); ++j) array(p, j) = places[p][j];
  }
  ShapeFunctions result;
  evaluate(type, *basisOf(type), array, result);
  return result;
}

std::vector<base::Vector3> nodePlaces(ElementType type) {
  const auto basis = basisOf(type);
  Array places("places", basis->getCardinality(), dimensionOf(type));
  basis->getDofCoords(places);
  return toPlaces(places, nodesPerElement(type), dimensionOf(type));
}

}  // namespace harmos::mesh
