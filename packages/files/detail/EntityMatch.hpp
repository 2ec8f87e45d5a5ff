#pragma once

#include <string>
#include <vector>

#include <harmos/files/ResultMesh.hpp>

namespace harmos::files {

/// Which node and element of mesh B is which of mesh A, found by position, so that numbering does not matter.
///
/// Blocks are matched by name, elements inside a block by their centres, the positions of all their nodes and how these
/// are connected, nodes through their elements: nodes that coincide at an interface belong to different elements and
/// stay apart. Sets are matched by name and must have the same members.
struct EntityMatch {
  std::vector<int> node;              // of B, for each node of A; -1 for nodes of no element
  std::vector<int> element;           // of B, for each element of A
  std::vector<std::string> mismatch;  // what of A has no partner, one sentence each; empty: the meshes are equal
};

/// `tolerance` [length] is how far apart the same node may lie in A and B.
EntityMatch matchEntities(const ResultMesh& a, const ResultMesh& b, double tolerance);

}  // namespace harmos::files
