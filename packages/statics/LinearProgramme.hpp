#pragma once

#include <memory>
#include <vector>

namespace harmos::statics {

/// A linear programme that grows by columns: the least c.x with lower <= x <= upper and A x = b.
///
/// Solved by the primal simplex method of CLP, from the last basis on, to 1e-10 in rows and reduced costs: they should
/// be of the order of one.
class LinearProgramme {
 public:
  /// An entry of a column.
  struct Entry {
    int row = 0;         ///< counted from 0
    double value = 0.0;  ///< of any unit
  };

  /// Without columns; `right` is b, with one entry per row.
  explicit LinearProgramme(const std::vector<double>& right);
  ~LinearProgramme();
  /// Takes over the columns; the other one may only be destroyed or assigned to then.
  LinearProgramme(LinearProgramme&&) noexcept;
  /// The same.
  LinearProgramme& operator=(LinearProgramme&&) noexcept;

  /// Adds an unknown with its bounds and its cost; infinite bounds are none. Taken in by the next solve().
  void add(const std::vector<Entry>& column, double lower, double upper, double cost);
  /// How many columns there are.
  int columns() const;
  /// Whether it found a solution; no solution is known before, nor where it fails.
  bool solve();
  /// Whether the last solve() found none because c.x has no least value.
  bool isUnbounded() const;
  /// The least c.x of the last solve().
  double value() const;
  /// The unknowns of the last solve(), in the order of their columns.
  std::vector<double> solution() const;
  /// The multipliers y of the rows: c - A^T y is 0 at unknowns within their bounds, >= 0 at lower, <= 0 at upper ones.
  std::vector<double> multipliers() const;

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace harmos::statics
