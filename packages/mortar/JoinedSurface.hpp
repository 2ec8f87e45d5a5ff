#pragma once

#include <array>
#include <vector>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/TraceOperator.hpp>

namespace harmos::mortar {

/// What is to be known of an interface between meshes that do not match.
struct JoinReport {
  std::array<int, 2> faces{};         // of both sides that have a part in common with the other
  std::array<int, 2> given{};         // of both sides, as they were given
  std::array<double, 2> uncovered{};  // share of the area of the former that the other side does not cover [-]
  int leftOut = 0;  // corners of covered faces that are no points, since hardly anything of them is covered
  int held = 0;     // points that were left out because both sides are held there along the surface
  std::array<int, 2> beyondReach{};  // faces of both sides that lie opposite each other, but too far apart
  double nearestBeyond = 0.0;        // least distance of these [length]
  double spacing = 0.0;              // of the points, in the mean [length]
  double largestGap = 0.0;           // of a point, before gaps were closed [length], >= 0
  double largestOverlap = 0.0;       // likewise, of points that overlap [length], >= 0
  base::Vector3 overlapPlace{};      // of that point [length]
  /// How far the faces of both sides lie from the curved surfaces that they stand for, in sum [length]: what gaps and
  /// overlaps they alone can make.
  double sagitta = 0.0;
  int closed = 0;              // points whose gap or overlap was closed
  double largestClosed = 0.0;  // of these [length]
  /// Largest distance of the two places of a point over the diameter of all points [-]: the work that is done when both
  /// sides turn together, per angle, traction, area and diameter.
  double rigidMotion = 0.0;
};

/// Two surface meshes that were joined on points (dual mortar). Points are numbered from 0; their order is that of the
/// nodes of the mortar side, then of the patches. n points from side 1 to side 2.
struct JoinedSurface {
  int pointsOn = 0;                          // the mortar side, 0 or 1: its corner nodes are the points
  std::vector<int> node;                     // per point, of the mesh
  std::vector<int> patch;                    // per point, smooth patch of faces around its node, counted from 0
  std::vector<base::Vector3> place;          // per point, where its forces act on the mortar side [length]
  std::vector<base::Vector3> normal;         // per point, int psi n dS [area]
  std::vector<base::Frame> frame;            // per point, n the direction of `normal`
  std::vector<double> area;                  // per point, h = int psi dS [length^2; in 2-D length times depth], > 0
  std::vector<double> gap;                   // per point, n . (B2 x2 - B1 x1) [length], > 0 if open
  std::array<mesh::TraceOperator, 2> trace;  // B of both sides, with nodes of the mesh; rows sum to 1
  /// A corner of faces that has no point because it lies at a crease.
  struct Creased {
    int node = -1;          // of the mesh
    int point = -1;         // one that has its share, whose tractions stand there
    base::Vector3 place{};  // of the node [length]
  };
  std::vector<Creased> creased;
  /// Points of the covered faces of the mortar side, in the order of their corners (seen from outside of that side);
  /// n + i is creased[i]. Those with a corner that was left out for another reason are not listed.
  std::vector<std::vector<int>> face;
  JoinReport report;
};

}  // namespace harmos::mortar
