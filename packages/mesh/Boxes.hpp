#pragma once

#include <array>
#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/MeshSize.hpp>

namespace harmos::input {
class ErrorList;
class ParameterSpec;
class Parameters;
}  // namespace harmos::input

namespace harmos::mesh {

/// A box of equal cells, see StructuredMesh::addGrid for how a cell is divided into elements.
struct Box {
  std::string name;                         // also of the block
  base::Vector3 lower{};                    // lowest coordinates [length]; in 2-D the third one is 0
  base::Vector3 upper{};                    // highest coordinates [length], above the lowest; in 2-D the third one is 0
  std::array<int, 3> cells{};               // per direction, at least 1; in 2-D the third one does not count
  ElementType element = ElementType::hex8;  // what the cells are divided into; says also whether it is 2-D
};

/// The form that boxes() and readBoxes() read: named lists of corners [length], numbers of cells, and an element.
input::ParameterSpec describeBoxes();

/// One block per box, with side sets `<name>_xmin`, _xmax, _ymin, _ymax and, in 3-D, _zmin, _zmax. Boxes share no
/// nodes. For bodies of another shape, move Mesh::nodes afterwards. Throws base::Error(input) on an empty list, and on
/// boxes without extent or cells, with more nodes than an int can count, some in the plane and some in space, or of one
/// name.
Mesh boxes(const std::vector<Box>& list);
/// The same from a list that was checked against describeBoxes(). Throws base::Error(input) with all that is wrong.
Mesh boxes(const input::Parameters& parameters);
/// The blocks of this mesh, which is not made. Throws as boxes().
std::vector<BlockSize> boxesSizes(const input::Parameters& parameters);

/// The boxes of an input; reports those that boxes() would refuse to `errors`, each at its place; the list is of
/// use only when there were none.
std::vector<Box> readBoxes(const input::Parameters& parameters, input::ErrorList& errors);

}  // namespace harmos::mesh
