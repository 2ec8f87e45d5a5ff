#pragma once

#include <array>
#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::input {
class ErrorList;
class ParameterSpec;
class Parameters;
}  // namespace harmos::input

namespace harmos::mesh {

/// A box of equal cells, see StructuredMesh::addGrid for how a cell is divided into elements.
struct Box {
  std::string name;
  base::Vector3 lower{};
  base::Vector3 upper{};
  std::array<int, 3> cells{};
  ElementType element = ElementType::hex8;
};

input::ParameterSpec describeBoxes();

/// One block per box, with side sets <name>_xmin, _xmax, _ymin, _ymax and, in 3-D, _zmin, _zmax. Boxes share no nodes.
/// For bodies of another shape, move Mesh::nodes afterwards.
/// Throws base::Error(input) on boxes without extent or cells, of two dimensions, or of one name.
Mesh boxes(const std::vector<Box>& list);
Mesh boxes(const input::Parameters& parameters);

/// The boxes of an input; reports those that boxes() would refuse to `errors`, each at its place.
std::vector<Box> readBoxes(const input::Parameters& parameters, input::ErrorList& errors);

}  // namespace harmos::mesh
