#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Vector3.hpp>

namespace harmos::substructure {

/// The planes across an axis, through the middle of some points, in which these points and a symmetric matrix on their
/// components are their own mirror images, and the change to unknowns that are even or odd about each plane.
///
/// A matrix S that a reflection P leaves as it is, P S P = S, couples no even unknown with an odd one: with one plane S
/// falls into two blocks of half its size, with three into eight. The change T takes u_a and its mirror image u_b to
/// (u_a + s u_b) / sqrt(2) and (s u_a - u_b) / sqrt(2), s = -1 for the component across the plane, else 1.
/// It is its own inverse and transpose.
/// Source: Bossavit, Symmetry, groups, and boundary value problems, Comput. Methods Appl. Mech. Eng. 56 (1986).
class MirrorPlanes {
 public:
  /// A component of a point.
  struct Row {
    base::Vector3 position;  ///< of the point [length]
    int component;           ///< 0, 1 or 2
  };

  /// `matrix`: symmetric, both triangles stored, a row of which belongs to each of `rows`; no rows: no planes are
  /// looked for. Mirror images coincide within 1e-9 of the extent of the points, and entries of the matrix within 1e-12
  /// of its Frobenius norm, all together.
  MirrorPlanes(const std::vector<Row>& rows, const base::Matrix& matrix);

  /// Planes that were found.
  int count() const { return static_cast<int>(planes_.size()); }
  /// x := T x, column by column, with the rows of the matrix.
  void change(base::Matrix& x) const;
  /// Rows of T x, ascending, that are even and odd about the same planes, each set of them that is not empty: one set
  /// without planes.
  std::vector<std::vector<int>> blocks() const;

 private:
  /// A row, its mirror image that lies apart from it, and s.
  struct Pair {
    int first, second;
    double sign;
  };
  struct Plane {
    std::vector<Pair> pairs;
    std::vector<bool> isOdd;  // of the unknowns after the change
  };

  /// Empty pairs: none.
  static Plane across(int axis, const std::vector<Row>& rows);
  static bool leaves(const Plane& plane, const base::Matrix& matrix);

  int rows_;
  std::vector<Plane> planes_;
};

}  // namespace harmos::substructure
