#include <harmos/elasticity/detail/ReferenceElement.hpp>

#include <Intrepid2_DefaultCubatureFactory.hpp>
#include <Intrepid2_HGRAD_HEX_C1_FEM.hpp>
#include <Intrepid2_HGRAD_PYR_C1_FEM.hpp>
#include <Intrepid2_HGRAD_QUAD_C1_FEM.hpp>
#include <Intrepid2_HGRAD_TET_C1_FEM.hpp>
#include <Intrepid2_HGRAD_TRI_C1_FEM.hpp>
#include <Intrepid2_HGRAD_WEDGE_C1_FEM.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::elasticity {
namespace {

using Device = Kokkos::Device<Kokkos::Serial, Kokkos::HostSpace>;
using Array = Kokkos::DynRankView<double, Device>;

ReferenceElement evaluate(const Intrepid2::Basis<Device, double, double>& basis, int degree) {
  const auto cubature =
      Intrepid2::DefaultCubatureFactory::create<Device, double, double>(basis.getBaseCellTopology(), degree);
  ReferenceElement element;
  element.dimension = cubature->getDimension();
  element.nodes = basis.getCardinality();
  element.points = cubature->getNumPoints();
  Array points("points", element.points, element.dimension), weights("weights", element.points);
  cubature->getCubature(points, weights);
  Array values("values", element.nodes, element.points);
  Array gradients("gradients", element.nodes, element.points, element.dimension);
  basis.getValues(values, points, Intrepid2::OPERATOR_VALUE);
  basis.getValues(gradients, points, Intrepid2::OPERATOR_GRAD);
  for (int p = 0; p < element.points; ++p) {
    element.weight.push_back(weights(p));
    for (int a = 0; a < element.nodes; ++a) {
      element.value.push_back(values(a, p));
      for (int j = 0; j < element.dimension; ++j) element.gradient.push_back(gradients(a, p, j));
    }
  }
  return element;
}

}  // namespace

ReferenceElement referenceElement(mesh::ElementType type) {
  switch (type) {
    case mesh::ElementType::tri3:
      return evaluate(Intrepid2::Basis_HGRAD_TRI_C1_FEM<Device>(), 1);
    case mesh::ElementType::quad4:
      return evaluate(Intrepid2::Basis_HGRAD_QUAD_C1_FEM<Device>(), 3);
    case mesh::ElementType::tet4:
      return evaluate(Intrepid2::Basis_HGRAD_TET_C1_FEM<Device>(), 1);
    case mesh::ElementType::pyramid5:
      return evaluate(Intrepid2::Basis_HGRAD_PYR_C1_FEM<Device>(), 3);
    case mesh::ElementType::wedge6:
      return evaluate(Intrepid2::Basis_HGRAD_WEDGE_C1_FEM<Device>(), 2);
    case mesh::ElementType::hex8:
      return evaluate(Intrepid2::Basis_HGRAD_HEX_C1_FEM<Device>(), 3);
  }
  throw base::Error("Unknown element type.");
}

}  // namespace harmos::elasticity
