#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace harmos::mesh {

/// By which numbers the user knows the elements and nodes of a mesh: those that its file gives them, which need not be
/// their positions. Without numbers they are the positions, counted from 1 through all blocks.
struct Numbering {
  std::string file;                   // name of the file without folders; empty: the mesh is generated
  std::vector<std::int64_t> element;  // one per element, of split ones their parent's; empty: 1, 2, ...
  std::vector<std::int64_t> node;     // one per node; empty: 1, 2, ...; nodes behind the last are in no file
  bool isSplit = false;               // elements are children of those of the file

  /// Number of an element (its position, from 0), of a child that of its parent.
  std::int64_t ofElement(int position) const;
  /// Number of a node (its position, from 0); nothing for one that Mesh/Refine or Mesh/Order have made.
  std::optional<std::int64_t> ofNode(int position) const;
  /// For messages: element 1017 of "plate.e", or a child of it where elements are split.
  std::string nameOfElement(int position) const;
  /// For messages: node 4711 of "plate.e".
  std::string nameOfNode(int position) const;
};

/// The numbers 1, 2, ... need not be kept: no numbers in their place.
std::vector<std::int64_t> unlessPositions(std::vector<std::int64_t> numbers);

/// Whether all numbers are above 0 and no two of them are equal. O(n log n).
bool areDistinct(std::vector<std::int64_t> numbers);

}  // namespace harmos::mesh
