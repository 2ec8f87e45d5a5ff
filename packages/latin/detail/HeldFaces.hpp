#pragma once

#include <cstddef>
#include <vector>

#include <harmos/assembly/NodeClusters.hpp>
#include <harmos/base/Matrix.hpp>
#include <harmos/latin/EliminatedBoundaries.hpp>
#include <harmos/laws/FaceLaw.hpp>

namespace harmos::latin {

/// What holds nodes of an assembly, whatever they bear: boundaries that are eliminated, and, where there are any, laws
/// over whole faces (laws::FaceLaw) with the joints that pass on what they bear.
///
/// Left out: what is held at some load steps only, and interfaces with a consistent mass or with points that are no
/// nodes. Not collective.
class HeldFaces {
 public:
  using Pair = assembly::NodeClusters::Pair;

  /// A law over a whole face, or two.
  struct Face {
    std::vector<std::size_t> interfaces;
    std::vector<std::size_t> held;  ///< components, at all load steps
    bool isRigid = false;           ///< takes any tractions with the resultants that it holds, not those alone
    base::Vector3 centre{};         ///< [length]
    double size = 0.0;              ///< of the farthest point from there [length]
    double area = 0.0;              ///< the largest of a point
    base::Matrix sums;              ///< see unitsAt(); of unit tractions, held x fields
    /// How many fields of tractions it has.
    int fields() const { return sums.numCols(); }
  };

  /// The arguments must outlive it.
  HeldFaces(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
            const EliminatedBoundaries& eliminated);

  const std::vector<Face>& all() const { return faces_; }
  /// The face that an interface belongs to; -1: none.
  int faceOf(int interface) const { return faceOf_[interface]; }
  /// Leaves only those that are marked.
  void keep(const std::vector<bool>& isKept);
  /// t sqrt(h) at a pair of a face of fields of tractions, sums of the unit tractions of what it holds, that are
  /// orthonormal over the face.
  std::vector<base::Vector3> unitsAt(const Face& face, const Pair& pair) const;
  /// Orthonormal directions in which a pair bears anything by itself.
  std::vector<base::Vector3> axesOf(const Pair& pair) const;
  /// The nodes that hang together by pairs of eliminated boundaries, and, `withFaces`, of faces and joints.
  assembly::NodeClusters clusters(bool withFaces) const;

 private:
  /// t sqrt(h) of the unit tractions themselves.
  std::vector<base::Vector3> tractionsAt(const Face& face, const Pair& pair) const;
  void makeOrthonormal(Face& face) const;
  void number();

  const assembly::Assembly& assembly_;
  const assembly::SearchDirection& searchDirection_;
  const EliminatedBoundaries& eliminated_;
  std::vector<Face> faces_;
  std::vector<int> faceOf_;  // per interface
};

}  // namespace harmos::latin
