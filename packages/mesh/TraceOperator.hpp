#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {

/// Trace operator B of one side of an interface, a sparse matrix points x nodes, the same for every component:
/// w_p = sum_j B_pj u_j [length], nodal forces of the side F_j = sum_p B_pj h_p f_p [force].
///
/// Where the nodes of a side are the points, B selects one node for each point with coefficient 1.
class TraceOperator {
 public:
  /// One entry of a row.
  struct Entry {
    int node = -1;        ///< of the body (or mesh), counted from 0
    double weight = 1.0;  ///< B_pj, no dimension
  };
  /// The entries of one point, owned by the operator.
  struct Row {
    const Entry* first;                           ///< the first entry
    const Entry* last;                            ///< behind the last one
    const Entry* begin() const { return first; }  ///< for loops over the entries
    const Entry* end() const { return last; }     ///< the same
  };

  /// No points.
  TraceOperator() = default;
  /// Selects node nodes[p] for point p.
  explicit TraceOperator(const std::vector<int>& nodes);
  /// Adds a point; its entries have different nodes.
  void append(const std::vector<Entry>& row);
  /// Adds point p of another operator.
  void appendFrom(const TraceOperator& other, int p) { append({other.row(p).begin(), other.row(p).end()}); }

  /// How many points there are.
  int points() const { return static_cast<int>(pointers_.size()) - 1; }
  /// The entries of point p.
  Row row(int p) const { return {entries_.data() + pointers_[p], entries_.data() + pointers_[p + 1]}; }
  /// Every row is one entry of weight 1.
  bool isSelection() const { return isSelection_; }
  /// The node of point p; only of a selection.
  int node(int p) const { return entries_[p].node; }
  /// (B x)_p of a vector x per node, such as the place at which the forces of the point act on the body.
  base::Vector3 at(int p, const std::vector<base::Vector3>& x) const;
  /// y += B x for vectors of `dimension` components per node and point, node by node.
  void addProduct(int dimension, const double* x, double* y) const;
  /// y += B^T x likewise.
  void addTransposed(int dimension, const double* x, double* y) const;

 private:
  std::vector<std::size_t> pointers_{0};
  std::vector<Entry> entries_;
  bool isSelection_ = true;
};

}  // namespace harmos::mesh
