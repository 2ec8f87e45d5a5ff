#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <harmos/base/Error.hpp>

#include "SurfaceMeshes.hpp"

namespace harmos::mortar {
namespace {

using Entry = mesh::TraceOperator::Entry;

/// sum_p B_pj h_p by mesh node j: nodal forces of a unit traction.
std::vector<double> unitForces(const JoinedSurface& surface, int side, const mesh::Mesh& mesh) {
  std::vector<double> force(mesh.nodes.size(), 0.0);
  for (int p = 0; p < surface.trace[side].points(); ++p) {
    for (const Entry& entry : surface.trace[side].row(p)) force[entry.node] += entry.weight * surface.area[p];
  }
  return force;
}

/// What holds of every interface: rows sum to 1, areas are positive, frames are orthogonal, n leads from side 1 to 2.
void expectSound(const JoinedSurface& surface, double tolerance = 1e-11) {
  ASSERT_FALSE(surface.node.empty());
  for (std::size_t p = 0; p < surface.node.size(); ++p) {
    EXPECT_GT(surface.area[p], 0.0);
    EXPECT_NEAR(norm(surface.frame[p][0]), 1.0, 1e-14);
    for (const auto& trace : surface.trace) {
      double sum = 0.0;
      for (const Entry& entry : trace.row(static_cast<int>(p))) sum += entry.weight;
      EXPECT_NEAR(sum, 1.0, tolerance);
    }
  }
}

/// Linear fields have the same mean on both sides of every point.
void expectLinearReproduction(const JoinedSurface& surface, const mesh::Mesh& mesh, double tolerance) {
  for (int p = 0; p < surface.trace[0].points(); ++p) {
    EXPECT_NEAR(distance(surface.trace[0].at(p, mesh.nodes), surface.trace[1].at(p, mesh.nodes)), 0.0, tolerance);
    EXPECT_NEAR(surface.gap[p], 0.0, tolerance);
  }
}

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// int N_j dS over a face of unit area that is an affine image of its parent.
std::vector<double> nodalShares(int nodesPerFace) {
  switch (nodesPerFace) {
    case 3:
      return {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
    case 6:
      return {0.0, 0.0, 0.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
    case 4:
      return {0.25, 0.25, 0.25, 0.25};
    case 8:
      return {-1.0 / 12.0, -1.0 / 12.0, -1.0 / 12.0, -1.0 / 12.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
    default:
      return {1.0 / 36.0, 1.0 / 36.0, 1.0 / 36.0, 1.0 / 36.0, 1.0 / 9.0, 1.0 / 9.0, 1.0 / 9.0, 1.0 / 9.0, 4.0 / 9.0};
  }
}

struct Ratio {
  int first1, second1, first2, second2;
};

/// Two meshes of one square in space, all kinds of faces, both choices of the points: constant tractions give the nodal
/// forces of the faces themselves, linear fields agree.
TEST(JoinSurfaces, PassesThePatchTestForAllKindsOfFacesInSpace) {
  for (const int kind1 : {3, 4, 6, 8, 9}) {
    for (const int kind2 : {3, 4, 6, 8, 9}) {
      for (const Ratio& ratio : {Ratio{1, 1, 1, 1}, Ratio{3, 2, 4, 5}, Ratio{1, 1, 7, 3}, Ratio{20, 1, 1, 1}}) {
        for (const int pointsOn : {0, 1}) {
          mesh::Mesh mesh;
          const Side side1 = meshGrid(mesh, "one", {kind1, ratio.first1, ratio.second1, turned(plane())});
          const Side side2 = meshGrid(mesh, "two", {kind2, ratio.first2, ratio.second2, turned(plane()), true});
          JoinOptions options;
          options.pointsOn = pointsOn;
          const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2, options);
          SCOPED_TRACE(std::to_string(kind1) + " " + std::to_string(kind2) + " " + std::to_string(ratio.first2));
          const auto corner = [](double a, double b) { return turned(plane())(a, b); };
          const base::Vector3 normal = cross(corner(1.0, 0.0) - corner(0.0, 0.0), corner(0.0, 1.0) - corner(0.0, 0.0));
          expectSound(surface);
          expectLinearReproduction(surface, mesh, 1e-12);
          EXPECT_NEAR(total(surface.area), 1.0, 1e-12);
          for (const base::Frame& frame : surface.frame) EXPECT_NEAR(distance(frame[0], normal), 0.0, 1e-12);
          EXPECT_EQ(surface.pointsOn, pointsOn);
          EXPECT_LT(surface.report.uncovered[0], 1e-12);
          EXPECT_LT(surface.report.uncovered[1], 1e-12);
          EXPECT_EQ(surface.report.leftOut, 0);
          for (const int which : {0, 1}) {
            const Side& side = which == 0 ? side1 : side2;
            const auto force = unitForces(surface, which, mesh);
            std::vector<double> expected(mesh.nodes.size(), 0.0);
            const auto shares = nodalShares(static_cast<int>(side.faces[0].nodes.size()));
            for (const mesh::Face& face : side.faces) {
              for (std::size_t j = 0; j < shares.size(); ++j) {
                expected[face.nodes[j]] += shares[j] / static_cast<double>(side.faces.size());
              }
            }
            for (std::size_t j = 0; j < expected.size(); ++j) EXPECT_NEAR(force[j], expected[j], 1e-12) << j;
          }
        }
      }
    }
  }
}

TEST(JoinSurfaces, PassesThePatchTestForAllKindsOfFacesInThePlane) {
  for (const int kind1 : {2, 3}) {
    for (const int kind2 : {2, 3}) {
      for (const auto& [count1, count2] : {std::pair(1, 1), std::pair(4, 7), std::pair(40, 3), std::pair(1, 20)}) {
        for (const int pointsOn : {0, 1}) {
          mesh::Mesh mesh;
          mesh.dimension = 2;
          const Grid::Map line = [](double a, double) { return base::Vector3{3.0 * a, 1.0 + 4.0 * a, 0.0}; };
          const Side side1 = meshGrid(mesh, "one", {kind1, count1, 1, line});
          const Side side2 = meshGrid(mesh, "two", {kind2, count2, 1, line, true});
          JoinOptions options;
          options.pointsOn = pointsOn;
          options.depth = 2.0;
          const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2, options);
          expectSound(surface);
          expectLinearReproduction(surface, mesh, 1e-12);
          EXPECT_NEAR(total(surface.area), 10.0, 1e-12);
          for (const base::Frame& frame : surface.frame) EXPECT_NEAR(frame[0][0], 0.8, 1e-12);
          for (const int which : {0, 1}) {
            const auto force = unitForces(surface, which, mesh);
            const Side& side = which == 0 ? side1 : side2;
            const bool isQuadratic = side.faces[0].nodes.size() == 3;
            const double length = 10.0 / static_cast<double>(side.faces.size());
            EXPECT_NEAR(force[side.faces[0].nodes[which]], length * (isQuadratic ? 1.0 / 6.0 : 0.5), 1e-12);
          }
        }
      }
    }
  }
}

TEST(JoinSurfaces, JoinsMatchingFacesNodeByNode) {
  for (const int kind : {3, 4}) {
    mesh::Mesh mesh;
    const Grid::Map map = turned(rectangle(0.0, 0.0, 2.0, 1.0));
    const Grid grid1{kind, 5, 3, map, false, false, 0.3}, grid2{kind, 5, 3, map, true, false, 0.3};
    const Side side1 = meshGrid(mesh, "one", grid1), side2 = meshGrid(mesh, "two", grid2);
    const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2);
    ASSERT_EQ(surface.node.size(), 24u);
    EXPECT_TRUE(surface.trace[0].isSelection());
    EXPECT_TRUE(surface.trace[1].isSelection());
    for (int p = 0; p < 24; ++p) {
      EXPECT_EQ(surface.trace[0].row(p).begin()->node, surface.node[p]);
      EXPECT_EQ(distance(mesh.nodes[surface.trace[1].row(p).begin()->node], mesh.nodes[surface.node[p]]), 0.0);
    }
    EXPECT_EQ(surface.face.size(), side1.faces.size());
  }
}

/// The integrand is no polynomial on distorted quadrilaterals: nodal forces are right to the error of the rule.
TEST(JoinSurfaces, PassesThePatchTestOnDistortedQuadrilaterals) {
  for (const int kind1 : {4, 8, 9}) {
    for (const int kind2 : {3, 4, 6, 8, 9}) {
      mesh::Mesh mesh;
      const Side side1 = meshGrid(mesh, "one", {kind1, 4, 3, turned(plane()), false, false, 0.25});
      const Side side2 = meshGrid(mesh, "two", {kind2, 5, 4, turned(plane()), true, false, 0.25});
      for (const int pointsOn : {0, 1}) {
        JoinOptions options;
        options.pointsOn = pointsOn;
        const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2, options);
        SCOPED_TRACE(std::to_string(kind1) + " " + std::to_string(kind2));
        expectSound(surface);
        expectLinearReproduction(surface, mesh, 1e-12);
        EXPECT_NEAR(total(surface.area), 1.0, 1e-12);
        // Against the same sides joined to themselves, which are integrated on the faces as they are.
        for (const int which : {0, 1}) {
          const Side& side = which == 0 ? side1 : side2;
          Side mirror = side;
          for (mesh::Face& face : mirror.faces) {
            const int corners = face.nodes.size() % 3 == 0 && face.nodes.size() < 9 ? 3 : 4;
            std::reverse(face.nodes.begin() + 1, face.nodes.begin() + corners);
            const auto mids = std::min<std::size_t>(face.nodes.size(), static_cast<std::size_t>(2 * corners));
            std::reverse(face.nodes.begin() + corners, face.nodes.begin() + static_cast<std::ptrdiff_t>(mids));
          }
          const auto expected = unitForces(joinSurfaces("test", mesh, side, mirror), 0, mesh);
          const auto force = unitForces(surface, which, mesh);
          for (std::size_t j = 0; j < force.size(); ++j) EXPECT_NEAR(force[j], expected[j], 1e-10) << j;
        }
      }
    }
  }
}

/// A side of which the other one covers only a part: what is transmitted is what the covered part carries.
TEST(JoinSurfaces, TransmitsConstantTractionsAndLinearFieldsWhereAFaceIsCoveredInPart) {
  for (const int kind : {3, 4, 6, 8, 9}) {
    for (const int pointsOn : {0, 1}) {
      mesh::Mesh mesh;
      const Side side1 = meshGrid(mesh, "plate", {kind, 4, 4, turned(plane())});
      const Side side2 = meshGrid(mesh, "head", {kind, 3, 5, turned(rectangle(0.3, 0.2, 0.9, 0.7)), true});
      JoinOptions options;
      options.pointsOn = pointsOn;
      const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2, options);
      SCOPED_TRACE(std::to_string(kind) + " " + std::to_string(pointsOn));
      expectSound(surface);
      expectLinearReproduction(surface, mesh, 1e-12);
      EXPECT_NEAR(total(surface.area), 0.3, 1e-12);
      EXPECT_LT(surface.report.uncovered[1], 1e-12);
      // All faces of the plate that are touched: 3 x 3 cells of 1/16, and with triangles fewer than twice as many.
      const double touched = 0.3 / (1.0 - surface.report.uncovered[0]);
      EXPECT_NEAR(touched, surface.report.faces[0] * (kind % 3 == 0 && kind < 9 ? 0.5 : 1.0) / 16.0, 1e-12);
      EXPECT_EQ(surface.report.given[0], static_cast<int>(side1.faces.size()));
      const auto force = unitForces(surface, 1, mesh);
      std::vector<double> expected(mesh.nodes.size(), 0.0);
      const auto shares = nodalShares(kind);
      for (const mesh::Face& face : side2.faces) {
        for (std::size_t j = 0; j < shares.size(); ++j) {
          expected[face.nodes[j]] += shares[j] * 0.3 / static_cast<double>(side2.faces.size());
        }
      }
      for (std::size_t j = 0; j < force.size(); ++j) EXPECT_NEAR(force[j], expected[j], 1e-12);
      EXPECT_NEAR(total(unitForces(surface, 0, mesh)), 0.3, 1e-12);
    }
  }
}

TEST(JoinSurfaces, LeavesOutPointsOfWhichHardlyAnythingIsCovered) {
  for (const int kind : {3, 4, 6, 8, 9}) {
    mesh::Mesh mesh;
    const Side side1 = meshGrid(mesh, "one", {kind, 2, 2, plane()});
    const Side side2 = meshGrid(mesh, "two", {kind, 3, 3, rectangle(0.0, 0.0, 0.52, 1.0), true});
    JoinOptions options;
    options.pointsOn = 0;
    const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2, options);
    SCOPED_TRACE(kind);
    EXPECT_EQ(surface.node.size(), 6u);
    EXPECT_EQ(surface.report.leftOut, 3);
    expectSound(surface);
    expectLinearReproduction(surface, mesh, 1e-12);
    EXPECT_NEAR(total(surface.area), 0.52, 1e-12);
    EXPECT_NEAR(surface.report.uncovered[0], 0.48, 1e-12);
    base::Vector3 centre{};
    for (int p = 0; p < 6; ++p) centre = centre + surface.area[p] * surface.trace[0].at(p, mesh.nodes);
    EXPECT_NEAR(distance(centre, 0.52 * base::Vector3{0.26, 0.5, 0.0}), 0.0, 1e-12);
  }
}

/// Next to a plane of symmetry y = 0: tractions along y would do next to nothing there.
TEST(JoinSurfaces, LeavesOutPointsAtWhichBothSidesAreHeldAlongTheSurface) {
  for (const int kind : {3, 4, 6, 8, 9}) {
    mesh::Mesh mesh;
    const Side side1 = meshGrid(mesh, "one", {kind, 2, 2, plane()});
    const std::size_t ofSide1 = mesh.nodes.size();
    const Side side2 = meshGrid(mesh, "two", {kind, 3, 3, plane(), true});
    SCOPED_TRACE(kind);
    const auto joined = [&](const base::Vector3& direction, bool isSecondHeld) {
      JoinOptions options;
      options.pointsOn = 0;
      for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
        const bool isThere = mesh.nodes[node][1] == 0.0 && (node < ofSide1 || isSecondHeld);
        if (isThere) options.held[static_cast<int>(node)] = {direction};
      }
      return joinSurfaces("test", mesh, side1, side2, options);
    };
    const JoinedSurface surface = joined({0.0, 1.0, 0.0}, true);
    EXPECT_EQ(surface.node.size(), 6u);
    EXPECT_EQ(surface.report.held, 3);
    expectSound(surface);
    expectLinearReproduction(surface, mesh, 1e-12);
    EXPECT_NEAR(total(surface.area), 1.0, 1e-12);
    EXPECT_NEAR(total(unitForces(surface, 0, mesh)), 1.0, 1e-12);
    EXPECT_NEAR(total(unitForces(surface, 1, mesh)), 1.0, 1e-12);
    EXPECT_EQ(joined({0.0, 1.0, 0.0}, false).report.held, 0);  // the other side can move
    EXPECT_EQ(joined({0.0, 0.0, 1.0}, true).report.held, 0);   // held across the surface
  }
  mesh::Mesh mesh;
  const Side side1 = meshGrid(mesh, "one", {4, 2, 2, plane()});
  const Side side2 = meshGrid(mesh, "two", {4, 2, 2, plane(), true});
  JoinOptions options;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    if (mesh.nodes[node][1] == 0.0) options.held[static_cast<int>(node)] = {{0.0, 1.0, 0.0}};
  }
  EXPECT_EQ(joinSurfaces("test", mesh, side1, side2, options).report.held, 0);  // of equal meshes held nodes meet
}

// The cells of a thin sector are trapezia, so that a point on one plane of symmetry sees a little of the other one,
// which holds its nodes in nearly the same direction: their jump would be all but given.
TEST(JoinSurfaces, LeavesOutWhatASectorSeesOfItsOtherPlane) {
  constexpr double half = 0.5 * M_PI / 180.0;
  const auto sector = [](double r, double angle) {
    const double turn = half * (2.0 * angle - 1.0);
    return base::Vector3{(1.0 + r) * std::cos(turn), (1.0 + r) * std::sin(turn), 0.0};
  };
  mesh::Mesh mesh;
  const Side side1 = meshGrid(mesh, "one", {4, 2, 1, sector});
  const Side side2 = meshGrid(mesh, "two", {4, 3, 1, sector, true});
  JoinOptions options;
  options.pointsOn = 0;
  const auto largestOnOtherPlane = [&](const JoinedSurface& surface) {
    double largest = 0.0;
    for (std::size_t p = 0; p < surface.node.size(); ++p) {
      for (const Entry& entry : surface.trace[1].row(static_cast<int>(p))) {
        if (mesh.nodes[entry.node][1] * mesh.nodes[surface.node[p]][1] < 0.0)
          largest = std::max(largest, std::abs(entry.weight));
      }
    }
    return largest;
  };
  const double seen = largestOnOtherPlane(joinSurfaces("test", mesh, side1, side2, options));
  EXPECT_GT(seen, 1e-11);
  EXPECT_LT(seen, 1e-7);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    const double side = mesh.nodes[node][1] > 0.0 ? 1.0 : -1.0;
    options.held[static_cast<int>(node)] = {{-side * std::sin(half), std::cos(half), 0.0}};
  }
  const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2, options);
  EXPECT_EQ(surface.node.size(), 6u);
  EXPECT_EQ(largestOnOtherPlane(surface), 0.0);
  expectSound(surface);
  expectLinearReproduction(surface, mesh, 1e-7);
}

TEST(JoinSurfaces, LetsNothingOfASliverGrow) {
  for (const double width : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    mesh::Mesh mesh;
    const Side side1 = meshGrid(mesh, "one", {4, 2, 2, plane()});
    const Side side2 = meshGrid(mesh, "two", {3, 3, 3, rectangle(0.0, 0.0, 0.5 + width, 1.0), true});
    JoinOptions options;
    options.pointsOn = 0;
    const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2, options);
    expectSound(surface, 1e-10);
    expectLinearReproduction(surface, mesh, 1e-10);
    for (const auto& trace : surface.trace) {
      for (int p = 0; p < trace.points(); ++p) {
        for (const Entry& entry : trace.row(p)) EXPECT_LT(std::abs(entry.weight), 5.0) << width;
      }
    }
  }
}

/// The quarter of a cylinder of radius 1 and length 1.
base::Vector3 cylinder(double a, double b) {
  const double angle = 0.5 * std::acos(-1.0) * a;
  return {std::cos(angle), std::sin(angle), b};
}

/// Facets of two meshes of one cylinder gape and overlap by the sagitta of the coarser one, quadratic ones hardly.
TEST(JoinSurfaces, MeasuresTheGapsBetweenFacetsOfACylinder) {
  int pointsOn = 1;
  const auto join = [&pointsOn](int kind, int cells, GapTreatment gap, double within) {
    mesh::Mesh mesh;
    const Side inner = meshGrid(mesh, "pin", {kind, cells, 2, cylinder, false, true});
    const Side outer = meshGrid(mesh, "hole", {kind, 2 * cells, 3, cylinder, true, true});
    JoinOptions options;
    options.gap = gap;
    options.within = within;
    options.pointsOn = pointsOn;
    JoinedSurface surface = joinSurfaces("test", mesh, inner, outer, options);
    expectSound(surface);
    for (std::size_t p = 0; p < surface.node.size(); ++p) {
      const base::Vector3& x = surface.place[p];
      EXPECT_GT(dot(surface.frame[p][0], {x[0], x[1], 0.0}), 0.97);  // from the pin to the hole
    }
    return surface.report;
  };
  for (const int side : {0, 1}) {
    pointsOn = side;
    for (const int kind : {3, 4}) {
      for (const int cells : {4, 8, 16}) {
        const double sagitta = 1.0 - std::cos(0.25 * std::acos(-1.0) / cells);
        const JoinReport report = join(kind, cells, GapTreatment::geometric, 0.0);
        // On the coarser side it is the mean over the facets around a point.
        EXPECT_GT(report.largestGap, (pointsOn == 1 ? 0.5 : 0.4) * sagitta);
        EXPECT_LT(report.largestGap, (pointsOn == 1 ? 1.1 : 0.7) * sagitta);
        EXPECT_LT(report.largestOverlap, 0.2 * sagitta);
        // With that of the finer one, a quarter; triangles' mean normals at the rim lean to one side.
        EXPECT_NEAR(report.sagitta, 1.25 * sagitta, (kind == 3 ? 0.4 : 0.1) * sagitta);
        EXPECT_GT(report.rigidMotion, (pointsOn == 1 ? 0.2 : 0.1) * sagitta);
        EXPECT_LT(report.uncovered[0], 0.02);
        EXPECT_EQ(report.closed, 0);
        const JoinReport closed = join(kind, cells, GapTreatment::closed, 0.0);
        EXPECT_GT(closed.closed, 0);
        EXPECT_EQ(closed.largestClosed, std::max(report.largestGap, report.largestOverlap));
        EXPECT_EQ(closed.largestGap, report.largestGap);
        const JoinReport within = join(kind, cells, GapTreatment::closedWithin, 0.5 * report.largestGap);
        EXPECT_LE(within.largestClosed, 0.5 * report.largestGap);
        EXPECT_LT(within.closed, closed.closed);
      }
    }
    for (const int kind : {6, 8, 9}) {
      const double coarse = join(kind, 4, GapTreatment::geometric, 0.0).largestGap;
      const double fine = join(kind, 8, GapTreatment::geometric, 0.0).largestGap;
      EXPECT_LT(coarse, 1e-3);
      EXPECT_LT(fine, coarse / 8.0);
    }
  }
}

TEST(JoinSurfaces, MeasuresAnOpenGapAndAnOverlap) {
  for (const double height : {0.02, -0.02}) {
    mesh::Mesh mesh;
    const Side side1 = meshGrid(mesh, "one", {4, 4, 4, plane()});
    const Side side2 = meshGrid(mesh, "two", {3, 5, 5, plane(height), true});
    for (const int pointsOn : {0, 1}) {
      JoinOptions options;
      options.pointsOn = pointsOn;
      const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2, options);
      for (const double gap : surface.gap) EXPECT_NEAR(gap, height, 1e-14);
      for (const base::Frame& frame : surface.frame) EXPECT_NEAR(frame[0][2], 1.0, 1e-14);
      EXPECT_NEAR(surface.report.largestGap, std::max(height, 0.0), 1e-14);
      EXPECT_NEAR(surface.report.largestOverlap, std::max(-height, 0.0), 1e-14);
      EXPECT_NEAR(surface.report.rigidMotion, 0.02 / std::sqrt(2.0), 1e-12);
      EXPECT_EQ(surface.report.sagitta, 0.0);
    }
  }
}

/// Two faces of a box, at a right angle.
base::Vector3 bend(double a, double b) {
  return a <= 0.5 ? base::Vector3{2.0 * a, b, 0.0} : base::Vector3{1.0, b, 2.0 * a - 1.0};
}

TEST(JoinSurfaces, DividesPointsAtCreases) {
  mesh::Mesh mesh;
  const Side side1 = meshGrid(mesh, "one", {4, 4, 2, bend});
  const Side side2 = meshGrid(mesh, "two", {3, 6, 3, bend, true});
  JoinOptions options;
  options.pointsOn = 0;
  EXPECT_EQ(joinSurfaces("test", mesh, side1, side2, options).node.size(), 15u);
  options.creaseAngle = 45.0;
  const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2, options);
  EXPECT_EQ(surface.node.size(), 18u);
  EXPECT_EQ(std::count(surface.patch.begin(), surface.patch.end(), 1), 3);
  expectSound(surface);
  expectLinearReproduction(surface, mesh, 1e-12);
  EXPECT_NEAR(total(surface.area), 2.0, 1e-12);
  for (const base::Frame& frame : surface.frame) EXPECT_NEAR(std::max(-frame[0][0], frame[0][2]), 1.0, 1e-12);
}

/// Three faces of a box, the middle one two thirds as wide.
base::Vector3 bendTwice(double a, double b) {
  if (a < 0.4) return {0.0, b, 1.0 - 2.5 * a};
  return a <= 0.6 ? base::Vector3{5.0 * (a - 0.4), b, 0.0} : base::Vector3{1.0, b, 2.5 * (a - 0.6)};
}

/// Ties have no points at creases, and yet transmit another constant traction on every patch exactly: also where all
/// nodes of a patch lie at creases.
TEST(JoinSurfaces, TransmitsTractionsOfPatchesWithoutPointsAtCreases) {
  for (const int kind1 : {3, 4, 8}) {
    for (const int kind2 : {3, 6, 4}) {
      for (const int pointsOn : {0, 1}) {
        SCOPED_TRACE(std::to_string(kind1) + " " + std::to_string(kind2) + " " + std::to_string(pointsOn));
        mesh::Mesh mesh;
        const Side side1 = meshGrid(mesh, "one", {kind1, 5, 4, bendTwice});
        const Side side2 = meshGrid(mesh, "two", {kind2, 5, 3, bendTwice, true});
        JoinOptions options;
        options.pointsOn = pointsOn;
        options.creaseAngle = 45.0;
        const JoinedSurface divided = joinSurfaces("test", mesh, side1, side2, options);
        options.hasPointsAtCreases = false;
        const JoinedSurface surface = joinSurfaces("test", mesh, side1, side2, options);
        const int atCreases = 4 * (pointsOn == 0 ? 5 : 4);
        EXPECT_LT(surface.node.size(), divided.node.size() - static_cast<std::size_t>(atCreases / 2));
        expectSound(surface);
        expectLinearReproduction(surface, mesh, 1e-12);
        for (int d = 0; d < 3; d += 2) {
          for (const double sign : {-1.0, 1.0}) {
            const auto forces = [&](JoinedSurface of, int side) {
              for (std::size_t p = 0; p < of.area.size(); ++p) of.area[p] *= sign * of.frame[p][0][d] > 0.5 ? 1.0 : 0.0;
              return unitForces(of, side, mesh);
            };
            for (const int side : {0, 1}) {
              const auto found = forces(surface, side), expected = forces(divided, side);
              for (std::size_t j = 0; j < expected.size(); ++j) EXPECT_NEAR(found[j], expected[j], 1e-12) << j;
            }
          }
        }
        EXPECT_EQ(surface.face.size(), divided.face.size());
        for (const std::vector<int>& face : surface.face) {
          for (const int corner : face) {
            const int i = corner - static_cast<int>(surface.node.size());
            if (i < 0) continue;
            const JoinedSurface::Creased& creased = surface.creased.at(i);
            EXPECT_EQ(distance(creased.place, mesh.nodes[creased.node]), 0.0);
            EXPECT_LT(distance(creased.place, surface.place.at(creased.point)), 0.8);
          }
        }
      }
    }
  }
}

TEST(JoinSurfaces, TakesThePointsOfAMuchSofterBodyThenOfTheCoarserMeshThenOfTheSofterBodyThenOfTheSmallerSurface) {
  struct Case {
    int cells1, cells2;
    double stiffness1, stiffness2, width1, width2;
    int expected;
  };
  for (const Case& c :
       {Case{4, 5, 2.0, 1.0, 1.0, 1.0, 0}, Case{4, 5, 4.0, 1.0, 1.0, 1.0, 1}, Case{5, 4, 1.0, 4.0, 1.0, 1.0, 0},
        Case{5, 4, 1.0, 2.0, 1.0, 1.0, 1}, Case{4, 4, 1.0, 2.0, 1.0, 1.0, 0}, Case{4, 4, 2.0, 1.0, 1.0, 1.0, 1},
        Case{4, 2, 1.0, 1.0, 1.0, 0.5, 1}, Case{2, 4, 1.0, 1.0, 0.5, 1.0, 0}, Case{4, 4, 1.0, 1.0, 1.0, 1.0, 0}}) {
    mesh::Mesh mesh;
    Side side1 = meshGrid(mesh, "one", {4, c.cells1, 4, rectangle(0.0, 0.0, c.width1, 1.0)});
    Side side2 = meshGrid(mesh, "two", {4, c.cells2, 4, rectangle(0.0, 0.0, c.width2, 1.0), true});
    side1.stiffness = c.stiffness1;
    side2.stiffness = c.stiffness2;
    EXPECT_EQ(joinSurfaces("test", mesh, side1, side2).pointsOn, c.expected);
    // The same side when it is named first.
    const bool isTie = c.cells1 == c.cells2 && c.stiffness1 == c.stiffness2;
    EXPECT_EQ(joinSurfaces("test", mesh, side2, side1).pointsOn, isTie ? 0 : 1 - c.expected);
  }
}

std::string messageOf(const mesh::Mesh& mesh, const Side& side1, const Side& side2, const JoinOptions& options = {}) {
  try {
    joinSurfaces("Interface \"seam\"", mesh, side1, side2, options);
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "";
}

TEST(JoinSurfaces, CountsFacesThatLieTooFarApart) {
  mesh::Mesh mesh;
  const Side flat = meshGrid(mesh, "flat", {4, 4, 4, plane()});
  // A step: the last column of faces is 2 higher than the first two, what is between faces nothing.
  const auto step = [](double x, double y) { return base::Vector3{x, y, x > 0.6 ? 2.0 : 0.0}; };
  const Side stepped = meshGrid(mesh, "stepped", {4, 4, 4, step, true});
  const JoinReport report = joinSurfaces("Interface", mesh, flat, stepped).report;
  EXPECT_EQ(report.faces, (std::array<int, 2>{8, 8}));
  EXPECT_EQ(report.beyondReach, (std::array<int, 2>{4, 4}));
  EXPECT_NEAR(report.nearestBeyond, 2.0, 1e-12);
  EXPECT_NEAR(report.spacing, std::sqrt(0.5 / 15.0), 1e-12);
  JoinOptions all;
  all.reach.distance = 2.5;
  EXPECT_EQ(joinSurfaces("Interface", mesh, flat, stepped, all).report.beyondReach, (std::array<int, 2>{0, 0}));
  const Side part = meshGrid(mesh, "part", {4, 2, 2, rectangle(0.0, 0.0, 0.5, 0.5), true});
  EXPECT_EQ(joinSurfaces("Interface", mesh, flat, part).report.beyondReach, (std::array<int, 2>{0, 0}));
}

TEST(JoinSurfaces, RefusesSidesThatCannotBeJoined) {
  mesh::Mesh mesh;
  const Side side1 = meshGrid(mesh, "side set \"a\"", {4, 4, 4, plane()});
  const Side near = meshGrid(mesh, "side set \"b\"", {3, 4, 4, plane(0.1), true});
  const Side far = meshGrid(mesh, "side set \"b\"", {3, 4, 4, plane(3.0), true});
  const Side turnedAway = meshGrid(mesh, "side set \"b\"", {3, 4, 4, plane()});
  EXPECT_EQ(messageOf(mesh, side1, {"side set \"b\"", {}}), "Interface \"seam\": side set \"b\" has no faces.");
  EXPECT_EQ(messageOf(mesh, side1, far),
            "Interface \"seam\": no face of side set \"a\" (16 faces) lies opposite one of side set \"b\" (32 faces) "
            "within the length of their longest edge; the nearest nodes are 3 apart. Name the faces that "
            "touch by side sets, or raise Search Distance.");
  EXPECT_NE(messageOf(mesh, side1, turnedAway).find("look the same way"), std::string::npos);
  EXPECT_EQ(messageOf(mesh, side1, near), "");
  JoinOptions options;
  options.reach.distance = 0.05;
  EXPECT_NE(messageOf(mesh, side1, near, options).find("within a distance of 0.05"), std::string::npos);
  options.reach.distance = 4.0;
  EXPECT_EQ(messageOf(mesh, side1, far, options), "");
}

// A small part in the middle of one large face, whose corners it is far from.
TEST(JoinSurfaces, TakesThePointsOfASmallPartOnALargeFace) {
  mesh::Mesh mesh;
  const Side large = meshGrid(mesh, "side set \"a\"", {4, 1, 1, plane()});
  Side small = meshGrid(mesh, "side set \"b\"", {4, 2, 2, rectangle(0.45, 0.45, 0.55, 0.55), true});
  for (const double stiffness : {0.01, 1.0, 100.0}) {
    small.stiffness = stiffness;
    EXPECT_EQ(joinSurfaces("test", mesh, large, small).pointsOn, 1);
    EXPECT_EQ(joinSurfaces("test", mesh, small, large).pointsOn, 0);
  }
  JoinOptions options;
  options.pointsOn = 0;
  EXPECT_EQ(
      messageOf(mesh, large, small, options),
      "Interface \"seam\": side set \"b\" covers so little of 1 face of side set \"a\" that none of their corners "
      "can be a point. Put the points on the other side, Points On = Side 2, or mesh side set \"a\" finer there.");
}

}  // namespace
}  // namespace harmos::mortar
