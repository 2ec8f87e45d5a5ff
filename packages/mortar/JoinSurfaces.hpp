#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/mesh/Depth.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Skin.hpp>
#include <harmos/mortar/HeldDirections.hpp>
#include <harmos/mortar/JoinedSurface.hpp>
#include <harmos/mortar/Reach.hpp>

/// Joins surface meshes that do not match: points, areas, gaps and trace operators by dual mortar integrals.
namespace harmos::mortar {

/// One side of an interface.
struct Side {
  std::string name;               // in messages, such as: side set "a"
  std::vector<mesh::Face> faces;  // each once; normals out of the part
  double stiffness = 1.0;         // of its part [stress], where the softer one is preferred
};

/// What becomes of gaps and overlaps of the geometry.
enum class GapTreatment { geometric, closed, closedWithin };

/// How two sides are joined.
struct JoinOptions {
  /// The side (0 or 1) whose corner nodes are the points; none: one that covers less than nine tenths of the
  /// faces of the other; else one that is more than three times softer; else that with the coarser mesh; if they are
  /// equally fine, of the softer part; if these are equal, with the smaller surface; else side 1.
  std::optional<int> pointsOn;
  GapTreatment gap = GapTreatment::geometric;
  double within = 0.0;         // up to which gaps and overlaps are closed, with closedWithin [length]
  Reach reach;                 // how far apart faces may lie along their normals
  double creaseAngle = 180.0;  // [degrees], as for mesh::smoothPatches()
  /// Whether nodes at creases have points, one for every patch around them; ties get on better without.
  bool hasPointsAtCreases = true;
  mesh::Depth depth;  // in 2-D
  /// Where the points carry tractions along the surface: what holds the nodes of both parts besides the interface.
  HeldDirections held;
};

/// Joins two sides of an interface whose nodes need not coincide, in the plane or in space, of any linear and quadratic
/// faces:
///
///     (B_s)_pj = (1 / h_p) int psi_p N_j dS,  h_p = int psi_p dS
///
/// over the common refinement of both surfaces. psi_p is the dual basis of the corners of the mortar side, N_j are the
/// shape functions of side s. So a constant traction and a linear displacement are transmitted exactly where the faces
/// lie on each other; equal meshes are joined node by node, and rigid motions of both do no work. Corners of which less
/// than a twentieth of the area around them is covered are left out, those at which both sides are held along the
/// surface unless B selects held nodes alone, and those at creases unless hasPointsAtCreases; their psi goes to the
/// corners beside them in their patch, so that tractions that are constant on every patch are still transmitted
/// exactly.
///
/// Throws base::Error(input), starting with `where`, if a side has no faces, or if no two faces of the sides face each
/// other within reach, with counts and distances. O(n log n) for n faces of similar size. Not collective.
JoinedSurface joinSurfaces(const std::string& where, const mesh::Mesh& mesh, const Side& side1, const Side& side2,
                           const JoinOptions& options = {});

}  // namespace harmos::mortar
