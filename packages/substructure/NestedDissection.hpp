#pragma once

#include <cstddef>
#include <vector>

namespace harmos::substructure {

/// Fill-reducing order of the unknowns and its inverse.
struct Ordering {
  std::vector<int> old;       ///< row at each new position
  std::vector<int> position;  ///< new position of each row
};

/// What the Cholesky factor of a sparse matrix takes.
struct FactorSize {
  double nonzeros = 0.0;         ///< entries of L, of the lower triangle with the diagonal
  double operations = 0.0;       ///< floating point operations of the numeric factorisation
  double bytes = 0.0;            ///< [byte] memory of L in double precision, without the padding of supernodes
  int blocks = 1;                ///< that the matrix falls into, each with a factor; the others are sums over them
  bool isTraceLast = false;      ///< whether the rows of a trace come after all others, to be kept dense
  bool isTraceInverted = false;  ///< and its dense factor is inverted
};

/// Orders a symmetric matrix by METIS nested dissection and predicts its factor, from the structure alone.
///
/// Consecutive rows of equal structure (the components of a node, up to three) are ordered as one, which costs a third
/// of the time. Gives the same order in every run. Source: Karypis, Kumar (1998), doi:10.1137/S1064827595287997; sizes
/// after Liu (1990), doi:10.1137/0611010.
class NestedDissection {
 public:
  /// Compressed rows with both triangles and ascending columns, as in CrsView; copied. `last`: rows, ascending, to be
  /// ordered after all others. Throws base::Error when METIS fails.
  NestedDissection(int rows, const std::size_t* rowPointers, const int* columns, const std::vector<int>& last = {});
  /// The order of the rows, `last` at its end; owned by this object.
  const Ordering& ordering() const { return ordering_; }
  /// Size of the Cholesky factor in this order, zeros by cancellation included. Exact unless some but not all rows of a
  /// node were to be last.
  FactorSize factorSize() const;

 private:
  void order(const std::vector<int>& blocks);
  int sizeOf(int block) const { return firstRow_[block + 1] - firstRow_[block]; }

  std::vector<int> firstRow_;               // of every block, and the number of rows
  std::vector<int> pointers_, neighbours_;  // graph of the blocks without the diagonal
  Ordering blocks_, ordering_;
};

}  // namespace harmos::substructure
