#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::files {

/// What a result file shows: nodes, element blocks and sets. Blocks may hold volumes, surfaces (SHELL4, TRI3) or lines
/// (BAR2); node numbers are 0-based.
struct ResultMesh {
  struct Block {
    std::string name;
    std::string type;  // Exodus element type
    int nodesPerElement = 0;
    std::vector<int> connectivity;
    int elements() const { return static_cast<int>(connectivity.size()) / nodesPerElement; }
  };

  int dimension = 3;
  std::vector<base::Vector3> nodes;
  std::vector<Block> blocks;
  std::vector<mesh::SideSet> sideSets;  // ids are given by the writer
  std::vector<mesh::NodeSet> nodeSets;

  int elements() const;
};

/// A mesh as it is, without doubled nodes.
ResultMesh resultMesh(const mesh::Mesh& mesh);

/// Names of the variables of a result file.
struct ResultVariables {
  std::vector<std::string> nodal;
  std::vector<std::string> element;
  std::vector<std::string> global;
};

/// Values of all variables at one time, in the order of ResultVariables.
struct ResultStep {
  double time = 0.0;
  std::vector<std::vector<double>> nodal;    // [variable][node]
  std::vector<std::vector<double>> element;  // [variable][element], elements counted through all blocks
  std::vector<double> global;                // [variable]
};

/// All variables zero: the unloaded state at time 0, and a start for filling a step in.
ResultStep zeroStep(const ResultMesh& mesh, const ResultVariables& variables, double time = 0.0);

}  // namespace harmos::files
