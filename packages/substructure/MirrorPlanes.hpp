#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::substructure {

/// The planes across an axis, through the middle of some nodes, in which these nodes are their own mirror images, and
/// the change to unknowns that are even or odd about each plane. Rows are components of nodes, node by node.
///
/// A matrix A that a reflection P leaves as it is, P A P = A, couples no even unknown with an odd one: with one plane A
/// falls into two blocks of half its size, with three into eight. The change T takes u_a and its mirror image u_b to
/// (u_a + s u_b) / sqrt(2) and (s u_a - u_b) / sqrt(2), s = -1 for the component across the plane, else 1.
/// It is its own inverse and transpose; those of several planes commute.
/// Source: Bossavit, Symmetry, groups, and boundary value problems, Comput. Methods Appl. Mech. Eng. 56 (1986).
class MirrorPlanes {
 public:
  /// None, of so many rows.
  explicit MirrorPlanes(int rows) : rows_(rows) {}
  /// `nodes`: coordinates [length]; those of mirror images are the same to 1e-14 of the extent of all: the motions of a
  /// rigid body are then as rigid after the change as before. `dimension`: components of a node, 2 or 3.
  MirrorPlanes(const std::vector<base::Vector3>& nodes, int dimension);

  /// Drops planes in which a symmetric matrix with a diagonal >= 0 is not its own mirror image: some a_ij is further
  /// from the mirrored one than 1e-12 sqrt(a_ii a_jj).
  void keepThoseOf(const CrsView& matrix);
  /// Drops planes in which some rows, ascending, are not the mirror images of each other.
  void keepThoseOf(const std::vector<int>& rows);
  /// The same planes for vectors that have but these rows, which must be the mirror images of each other.
  MirrorPlanes restrictedTo(const std::vector<int>& rows) const;

  /// Planes that are left.
  int count() const { return static_cast<int>(planes_.size()); }
  /// x := T x, column by column.
  void change(base::Matrix& x) const;
  /// Rows of T x, ascending, that are even and odd about the same planes: 2^count() sets, of which some may be empty.
  std::vector<std::vector<int>> blocks() const;
  /// The rows and columns of T A T in one of blocks(), for a matrix A of which all planes are kept.
  Teuchos::RCP<base::CrsMatrix> blockOf(const CrsView& matrix, const std::vector<int>& block) const;

 private:
  /// Of every row.
  struct Plane {
    std::vector<int> image;   // the row itself: it lies on the plane
    std::vector<bool> turns;  // whether s = -1
    std::vector<bool> isOdd;  // after the change; of two images the one that lies above the plane is
    bool isOn(int row) const { return image[row] == row; }
    double sign(int row) const { return turns[row] ? -1.0 : 1.0; }
  };

  /// Empty: none.
  static Plane across(int axis, const std::vector<base::Vector3>& nodes, int dimension);
  static bool leaves(const Plane& plane, const CrsView& matrix);
  /// The entry of T in a row and the column of the block to which it adds something; column -1: nothing.
  struct Share {
    int column;
    double factor;
  };
  Share shareIn(int member, int row) const;
  /// The row and its mirror images.
  std::vector<int> imagesOf(int row) const;

  int rows_;
  std::vector<Plane> planes_;
};

}  // namespace harmos::substructure
