#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <harmos/mesh/CutMesh.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/SmoothPatches.hpp>

namespace harmos::mesh {

class PartSkin;

/// Finds the surfaces of interfaces and outer boundaries between the parts of a mesh.
///
/// A part that was cut into pieces is addressed by its name. Every function returns one surface per pair of
/// pieces that meet (per piece on an outer boundary); a node on a cut is in the surfaces of both pieces, each with the
/// area of its own faces, so that the areas add up to those of the uncut interface. Names in errors are the user's.
/// All throw base::Error(input) for unknown names, sets and interfaces without faces or nodes, and faces that belong to
/// no part, and pairs without area. Keeps references to the mesh and the pieces, which must outlive it and stay as they
/// are. Not collective: the whole mesh is on the rank that asks.
///
/// `creaseAngle` [degrees]: faces around a node whose normals differ by more are different patches, and the node is a
/// pair of its own for each of them (see smoothPatches()). With oneNormal every node is one pair.
class InterfaceFinder {
 public:
  /// A crease angle that no surface has.
  static constexpr double oneNormal = noCrease;

  /// Joins faces of two sides that do not match, with the names of both as messages have them. The faces are those
  /// of both side sets, or those of both parts that lie on each other.
  using Joiner = std::function<std::vector<InterfaceSurface>(const std::string& name1, const std::vector<Face>& side1,
                                                             const std::string& name2, const std::vector<Face>& side2)>;

  /// `depth` multiplies lengths in 2-D and does not count in 3-D. Throws base::Error(input) if two parts share an
  /// element.
  InterfaceFinder(const Mesh& mesh, const std::vector<Piece>& pieces, const Depth& depth = 1.0);

  /// The interface between two side sets whose faces coincide node by node (within conformingTolerance).
  ///
  /// `projection` [any length] is for surfaces that are open (or overlap) initially: faces must coincide when seen
  /// along it, the normal is along it, the gap is measured along it, and areas are the areas seen along it. Sides that
  /// do not conform are left to `join`, if there is one and no projection; so are those with the same nodes but with
  /// different faces (triangles against quadrilaterals, other diagonals), whose nodal areas differ. Throws
  /// base::Error(input) if they do not conform otherwise, or belong to one part.
  std::vector<InterfaceSurface> betweenSideSets(const std::string& name, const std::string& sideSet1,
                                                const std::string& sideSet2,
                                                const std::optional<base::Vector3>& projection = std::nullopt,
                                                double creaseAngle = oneNormal, const Joiner& join = {}) const;

  /// The interface between two bodies: their coincident faces and, besides, mesh nodes that they share outside of these
  /// faces; if there are no such faces, the nodes that coincide. Areas of nodes without faces: mean over the two bodies
  /// of their nodal skin areas, of volume^(2/3) for nodes inside a part (in 2-D thickness times the root of the plane
  /// area). If faces lie on each other that do not match node by node, they and all that match are left to `join`, if
  /// there is one. Throws base::Error(input) if there is none then, or if the parts do not touch.
  std::vector<InterfaceSurface> betweenParts(const std::string& name, const std::string& part1,
                                             const std::string& part2, double creaseAngle = oneNormal,
                                             const Joiner& join = {}) const;

  /// All faces of two side sets, whether they match or not, joined by `join`. Throws base::Error(input) as the other
  /// functions do.
  std::vector<InterfaceSurface> joinedSideSets(const std::string& name, const std::string& sideSet1,
                                               const std::string& sideSet2, const Joiner& join) const;
  /// The same of the skins of two parts.
  std::vector<InterfaceSurface> joinedParts(const std::string& name, const std::string& part1, const std::string& part2,
                                            const Joiner& join) const;

  /// Which part, and which piece of it, elements belong to.
  const PieceMap& pieces() const { return parts_.map; }

  /// The surfaces between the pieces of every part that was cut, named "<part> cut": by their common faces, and by
  /// single nodes where no chain of faces ties pieces that share one. A scene gives them the law Perfect.
  std::vector<InterfaceSurface> cuts() const;

  /// Outer boundary on a side set: one surface per piece that has faces in it, normals out of the part. Faces on the
  /// axis of axisymmetry have no area and are left out, as are nodes there that only such faces share.
  std::vector<InterfaceSurface> onSideSet(const std::string& name, const std::string& sideSet,
                                          double creaseAngle = oneNormal) const;

  /// Outer boundary on a node set: its faces if every node belongs to a face of the skin that lies in the set, else the
  /// nodes alone, with their share of the skin's area, inner nodes as in betweenParts(). `part` (empty: all) restricts
  /// the set to the nodes of a part and takes that part's skin; otherwise faces between parts that share nodes do not
  /// count.
  std::vector<InterfaceSurface> onNodeSet(const std::string& name, const std::string& nodeSet,
                                          const std::string& part = "", double creaseAngle = oneNormal) const;

  /// The faces of a side set, each once, normals out of their parts. Throws base::Error(input) as the other functions
  /// do; the message starts with `where`.
  std::vector<Face> facesOf(const std::string& where, const std::string& sideSet) const;

  /// Throws base::Error(input) that counts the faces of a side set that lie inside of a part: no law can act there.
  /// The message starts with `where`.
  void demandSurface(const std::string& where, const std::string& sideSet) const;

 private:
  std::vector<InterfaceSurface> onFaces(const std::string& name, const std::vector<Face>& faces,
                                        double creaseAngle) const;
  /// The skin of a part, which is made once for all its interfaces.
  const PartSkin& skinOf(const std::string& where, const std::string& part) const;

  CutMesh parts_;
  std::shared_ptr<std::map<std::string, PartSkin>> skins_;  // that were asked for
};

}  // namespace harmos::mesh
