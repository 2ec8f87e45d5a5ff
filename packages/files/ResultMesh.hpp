#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::files {

/// What a result file shows: nodes, element blocks and sets. Blocks may hold volumes, surfaces (SHELL4, TRI3) or lines
/// (BAR2); node numbers are 0-based.
struct ResultMesh {
  /// Elements of one type under one name.
  struct Block {
    std::string name;               // unique among blocks
    std::string type;               // Exodus element type
    int nodesPerElement = 0;        // above 0 where elements() is asked for
    std::vector<int> connectivity;  // nodes of the elements, one after the other, in the order of Exodus
    /// Number of elements.
    int elements() const { return static_cast<int>(connectivity.size()) / nodesPerElement; }
  };

  int dimension = 3;                         // 2 or 3
  std::vector<base::Vector3> nodes;          // coordinates (x, y, z) [length]; z is 0 in 2-D
  std::vector<Block> blocks;                 // elements are counted through all of them
  std::vector<mesh::SideSet> sideSets;       // ids are given by the writer
  std::vector<mesh::NodeSet> nodeSets;       // the same
  std::vector<std::int64_t> elementNumbers;  // by which the user knows elements; empty: 1, 2, ...
  std::vector<std::int64_t> nodeNumbers;     // and nodes; the same

  /// Number of elements in all blocks.
  int elements() const;
};

/// A mesh as it is, without doubled nodes, with the numbers of the user's file where each is of one element or node.
ResultMesh resultMesh(const mesh::Mesh& mesh);

/// Names of the variables of a result file.
struct ResultVariables {
  std::vector<std::string> nodal;    // one value per node
  std::vector<std::string> element;  // one value per element of every block
  std::vector<std::string> global;   // one value per time
};

/// Values of all variables at one time, in the order of ResultVariables, each in its unit.
struct ResultStep {
  double time = 0.0;                         // [time]
  std::vector<std::vector<double>> nodal;    // [variable][node]
  std::vector<std::vector<double>> element;  // [variable][element], elements counted through all blocks
  std::vector<double> global;                // [variable]
};

/// All variables zero: the unloaded state at time 0, and a start for filling a step in.
ResultStep zeroStep(const ResultMesh& mesh, const ResultVariables& variables, double time = 0.0);

}  // namespace harmos::files
