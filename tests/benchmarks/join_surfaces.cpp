// Prints the CPU time that joining two meshes of one square takes, by kinds of faces, and that of clipping two faces by
// Harmos and by Boost.Geometry.
//
//   join_surfaces [FACES]     of each side, 100000 unless given

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#define BOOST_GEOMETRY_NO_ROBUSTNESS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <harmos/mortar/JoinSurfaces.hpp>
#include <harmos/mortar/detail/ConvexPolygon.hpp>

#include "SurfaceMeshes.hpp"

namespace {

using namespace harmos;

double cpuTime() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Row {
  const char* name;
  int kind1, kind2;
  double distortion;
};

void joinSquares(const Row& row, int faces) {
  const auto cells = [faces](int kind) {
    return static_cast<int>(std::lround(std::sqrt(kind == 3 || kind == 6 ? 0.5 * faces : 1.0 * faces)));
  };
  mesh::Mesh mesh;
  const int first = cells(row.kind1), second = cells(row.kind2) - 1;
  const auto side1 = mortar::meshGrid(
      mesh, "one", {row.kind1, first, first, mortar::turned(mortar::plane()), false, false, row.distortion});
  const auto side2 = mortar::meshGrid(
      mesh, "two", {row.kind2, second, second, mortar::turned(mortar::plane()), true, false, row.distortion});
  const double before = cpuTime();
  const auto surface = mortar::joinSurfaces("benchmark", mesh, side1, side2);
  std::printf("| %-28s | %6zu | %6zu | %6zu | %8.2f |\n", row.name, side1.faces.size(), side2.faces.size(),
              surface.node.size(), cpuTime() - before);
}

/// Microseconds that `clip` takes for two quadrilaterals that are turned against each other.
template <typename Clip>
double timeOf(const Clip& clip) {
  constexpr int repetitions = 100000;
  double area = 0.0;
  const double before = cpuTime();
  for (int i = 0; i < repetitions; ++i) area += clip(1e-6 * i);
  const double time = 1e6 * (cpuTime() - before) / repetitions;
  return area > 0.0 ? time : 0.0;
}

void clip() {
  namespace geometry = boost::geometry;
  using Point = geometry::model::d2::point_xy<double>;
  using Polygon = geometry::model::polygon<Point>;
  const auto corners = [](double shift) {
    return std::vector<mortar::Flat>{{0.5 + shift, -0.2}, {1.2, 0.5}, {0.5, 1.2}, {-0.2, 0.5 + shift}};
  };
  const std::vector<mortar::Flat> square = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  const double own = timeOf([&](double shift) {
    return intersection(mortar::ConvexPolygon(square), mortar::ConvexPolygon(corners(shift))).area();
  });
  const double library = timeOf([&](double shift) {
    const auto polygonOf = [](const std::vector<mortar::Flat>& places) {
      Polygon polygon;
      for (const auto& place : places) geometry::append(polygon, Point(place[0], place[1]));
      geometry::correct(polygon);
      return polygon;
    };
    std::vector<Polygon> common;
    geometry::intersection(polygonOf(square), polygonOf(corners(shift)), common);
    return common.empty() ? 0.0 : geometry::area(common[0]);
  });
  std::printf("\nclipping two quadrilaterals: by half planes %.2f us, by Boost.Geometry %.2f us\n", own, library);
}

}  // namespace

int main(int argumentCount, char** arguments) {
  const int faces = argumentCount > 1 ? std::atoi(arguments[1]) : 100000;
  std::printf("| faces                        | side 1 | side 2 | points | CPU [s]  |\n|---|---|---|---|---|\n");
  for (const Row& row :
       {Row{"tri3, tri3", 3, 3, 0.0}, Row{"quad4, quad4", 4, 4, 0.0}, Row{"quad4, quad4, distorted", 4, 4, 0.2},
        Row{"tri6, tri6", 6, 6, 0.0}, Row{"quad8, quad8", 8, 8, 0.0}, Row{"tri6, quad8", 6, 8, 0.0}}) {
    joinSquares(row, faces);
  }
  clip();
  return 0;
}
