#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/TraceLayout.hpp>

namespace harmos::latin {

/// What both stages of a law's meeting with its line share: the free jumps of the node pairs from the fields of the
/// linear stage, and the tractions of the law back on the rows of both sides.
///
/// With beta = f - k w from the linear stage, E+ reads f^ - k w^ = beta, so the line of a node pair is
///   delta_free = beta1/k - beta2/k,  H = 2/k   (outer boundary: delta_free = beta1/k, H = 1/k).
/// beta and f^: [stress], k: [stress/length], w^ and delta_free: [length], H: [length/stress].
class InterfaceLines {
 public:
  /// All arguments must outlive it.
  InterfaceLines(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
                 const TraceLayout& layout);

  /// That of its fields.
  const TraceLayout& layout() const { return layout_; }
  /// A side of the interface is owned here and has unknowns.
  bool isActive(int interfaceIndex) const { return joints_[interfaceIndex].active; }
  /// Largest number of columns of a field.
  void reserve(int columns);
  /// Collective. Gets the columns first .. first + count - 1 of sides that other ranks own.
  void exchange(const base::Matrix& beta, int first, int count);
  /// Lines [length, length/stress] of all pairs in the frame of the law, from one column that was exchanged.
  void fill(int interfaceIndex, int column, const base::Matrix& beta, std::vector<laws::LocalLine>& lines) const;
  /// Writes f^ [stress] of the sides owned here to the rows of a column: t = f1^ = -f2^, given in the frame of the law.
  /// The sum of what was written is not finite when one value is not.
  double write(int interfaceIndex, const laws::LocalState* states, double* traction) const;
  /// The same of t = M (beta1 - beta2) of a column that was exchanged (outer boundary: M beta1), one M [-] per pair,
  /// row by row, in (x, y, z).
  void map(int interfaceIndex, const std::vector<base::Frame>& matrices, int column, const base::Matrix& beta,
           double* traction) const;

 private:
  struct Joint {
    bool active = false;  // a side is owned here
    int begin1 = -1;
    int begin2 = -1;             // row blocks; -1: not owned here, or no such side
    int neighbour = -1;          // rank that owns the other side; -1: none or this one
    std::vector<double> remote;  // beta of the side owned elsewhere, pairs x dimension x columns
  };

  /// beta of both sides of an interface; null: there is no second side.
  struct Sides {
    const double* first;
    const double* second;

    /// beta1 - beta2 of a pair (outer boundary: beta1).
    template <int dimension>
    base::Vector3 difference(int pair) const;
  };

  const assembly::Interface& of(int interfaceIndex) const { return assembly_.interfaces[interfaceIndex]; }
  Sides betas(int interfaceIndex, int column, const base::Matrix& beta) const;
  /// Writes t of all pairs, in (x, y, z), to the rows of the sides owned here.
  template <class OfPair>
  void put(int interfaceIndex, const OfPair& t, double* traction) const;

  const assembly::Assembly& assembly_;
  const assembly::SearchDirection& searchDirection_;
  const TraceLayout& layout_;
  std::vector<Joint> joints_;
};

}  // namespace harmos::latin
