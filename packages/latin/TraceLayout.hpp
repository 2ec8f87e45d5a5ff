#pragma once

#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/assembly/SearchDirection.hpp>
#include <harmos/latin/EliminatedBoundaries.hpp>

namespace harmos::latin {

/// Where the trace of each interface side stands in a field on this rank.
///
/// A field is a base::Matrix with one row per component of every point of every owned interface side (global x, y, z;
/// point by point) and one column per load step. Boundaries with a prescribed traction and those that are eliminated
/// carry no unknowns and have no rows.
class TraceLayout {
 public:
  /// The block of rows of one interface side that this rank owns.
  struct Block {
    int interface = -1;  ///< position in the assembly
    int side = 0;        ///< 0 or 1
    int body = -1;       ///< position in the assembly
    int begin = 0;       ///< first row
    int pairs = 0;       ///< of the interface, each with a row per dimension
  };

  /// Not collective. Keeps the communicator and nothing else.
  TraceLayout(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
              const EliminatedBoundaries& eliminated, Teuchos::RCP<const Teuchos::Comm<int>> comm);

  /// Rows per pair: 2 or 3.
  int dimension() const { return dimension_; }
  /// Rows of a field on this rank, at least 1: a rank without unknowns has one of no area.
  int rows() const { return rows_; }
  /// The blocks of this rank, in the order of their rows.
  const std::vector<Block>& blocks() const { return blocks_; }
  /// First row of an interface side, or -1 when another rank owns it or it has no unknowns.
  int begin(int interfaceIndex, int side) const { return begin_[interfaceIndex][side]; }
  /// Lumped interface mass h [area] of every row.
  const std::vector<double>& area() const { return area_; }
  /// Search direction k [stress/length] of every row.
  const std::vector<double>& stiffness() const { return stiffness_; }
  /// Number of different nodes of owned bodies that interfaces feel; a node may belong to several interfaces.
  int nodes() const { return nodes_; }
  /// B of all blocks, one below the other: a point for each group of `dimension` rows, over these nodes.
  const mesh::TraceOperator& trace() const { return trace_; }
  /// The communicator of all ranks that share the assembly.
  const Teuchos::Comm<int>& comm() const { return *comm_; }
  /// The same, to be kept.
  Teuchos::RCP<const Teuchos::Comm<int>> commPointer() const { return comm_; }
  /// Whether this rank owns a body.
  bool owns(int body) const { return owned_[body]; }

 private:
  int dimension_;
  int rows_ = 0;
  std::vector<Block> blocks_;
  std::vector<std::vector<int>> begin_;
  std::vector<double> area_;
  std::vector<double> stiffness_;
  int nodes_ = 0;
  mesh::TraceOperator trace_;
  std::vector<bool> owned_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
};

}  // namespace harmos::latin
