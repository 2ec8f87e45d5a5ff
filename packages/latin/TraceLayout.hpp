#pragma once

#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/assembly/SearchDirection.hpp>

namespace harmos::latin {

/// Where the trace of each interface side stands in a field on this rank.
///
/// A field is a base::Matrix with one row per component of every node of every owned interface side (global x, y, z;
/// node by node) and one column per load step. Boundaries with a prescribed traction carry no unknowns and have no
/// rows.
class TraceLayout {
 public:
  /// The block of rows of one interface side that this rank owns.
  struct Block {
    int interface = -1;
    int side = 0;
    int body = -1;
    int begin = 0;  ///< first row
    int pairs = 0;
  };

  TraceLayout(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
              Teuchos::RCP<const Teuchos::Comm<int>> comm);

  int dimension() const { return dimension_; }
  int rows() const { return rows_; }
  const std::vector<Block>& blocks() const { return blocks_; }
  /// First row of an interface side, or -1 when another rank owns it or it has no unknowns.
  int begin(int interfaceIndex, int side) const { return begin_[interfaceIndex][side]; }
  /// Lumped interface mass h [area] of every row.
  const std::vector<double>& area() const { return area_; }
  /// Search direction k [stress/length] of every row.
  const std::vector<double>& stiffness() const { return stiffness_; }
  /// Number of different nodes of owned bodies that have rows; a node may belong to several interfaces.
  int nodes() const { return nodes_; }
  /// Which of these nodes each group of `dimension` rows belongs to.
  const std::vector<int>& nodeOf() const { return nodeOf_; }
  const Teuchos::Comm<int>& comm() const { return *comm_; }
  Teuchos::RCP<const Teuchos::Comm<int>> commPointer() const { return comm_; }
  bool owns(int body) const { return owned_[body]; }

 private:
  int dimension_;
  int rows_ = 0;
  std::vector<Block> blocks_;
  std::vector<std::vector<int>> begin_;
  std::vector<double> area_;
  std::vector<double> stiffness_;
  int nodes_ = 0;
  std::vector<int> nodeOf_;
  std::vector<bool> owned_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
};

}  // namespace harmos::latin
