#include <gtest/gtest.h>

#include <cmath>

#include <harmos/mesh/FaceIntegrals.hpp>
#include <harmos/mesh/ReferenceElement.hpp>

namespace harmos::mesh {
namespace {

using Places = std::vector<base::Vector3>;

constexpr double pi = 3.14159265358979323846;

double sum(const FaceIntegrals& face, double NodalWeight::*what) {
  double total = 0.0;
  for (const NodalWeight& weight : face.weight) total += weight.*what;
  return total;
}

/// A face of this type in the plane z = 1, corners at those of a parallelogram (or its half) of area 6 (or 3).
Places flat(ElementType type) {
  Places places = nodePlaces(type);
  const bool isTriangle = cornersPerElement(type) == 3;
  for (base::Vector3& x : places) {
    const double a = isTriangle ? x[0] : 0.5 * (1.0 + x[0]), b = isTriangle ? x[1] : 0.5 * (1.0 + x[1]);
    x = {3.0 * a + b, 2.0 * b, 1.0};
  }
  return places;
}

TEST(FaceIntegrals, SharesOfFlatQuadraticFacesAreThoseOfTheTextbook) {
  struct Expected {
    ElementType type;
    double area, corner, middle, centre;
  };
  for (const Expected& expected : {Expected{ElementType::tri6, 3.0, 0.0, 1.0 / 3.0, 0.0},
                                   Expected{ElementType::quad8, 6.0, -1.0 / 12.0, 1.0 / 3.0, 0.0},
                                   Expected{ElementType::quad9, 6.0, 1.0 / 36.0, 1.0 / 9.0, 4.0 / 9.0}}) {
    const FaceIntegrals face = integrateFace(3, flat(expected.type), 1.0);
    const auto corners = static_cast<std::size_t>(cornersPerElement(expected.type));
    for (std::size_t i = 0; i < face.weight.size(); ++i) {
      const double share = i < corners ? expected.corner : i < 2 * corners ? expected.middle : expected.centre;
      const NodalWeight& weight = face.weight[i];
      EXPECT_NEAR(weight.share, share * expected.area, 1e-13) << exodusName(expected.type) << " " << i;
      EXPECT_NEAR(weight.flux[2], weight.share, 1e-13);
      EXPECT_GT(weight.area, 0.0);
      EXPECT_NEAR(weight.normal[2], weight.area, 1e-13);
      double row = 0.0;
      for (const double entry : face.mass[i]) row += entry;
      EXPECT_NEAR(row, weight.share, 1e-13);
    }
    EXPECT_NEAR(sum(face, &NodalWeight::area), expected.area, 1e-13);
  }
}

TEST(FaceIntegrals, QuadraticEdgesFollowSimpsonsRule) {
  const FaceIntegrals edge = integrateFace(2, {{0.0, 0.0, 0.0}, {3.0, 4.0, 0.0}, {1.5, 2.0, 0.0}}, 0.5);
  const double area = 2.5;
  for (const auto& [node, share] : {std::pair(0, 1.0 / 6.0), std::pair(1, 1.0 / 6.0), std::pair(2, 2.0 / 3.0)}) {
    EXPECT_NEAR(edge.weight[node].share, share * area, 1e-14);
    EXPECT_NEAR(edge.weight[node].flux[0], 0.8 * share * area, 1e-14);
    EXPECT_NEAR(edge.weight[node].flux[1], -0.6 * share * area, 1e-14);
  }
}

TEST(FaceIntegrals, NormalsOfAClosedCurvedSurfaceAddUpToZero) {
  // Six faces of a ball: a cube of quad9 or quad8 blown up. Any pressure on it is in balance; the volume is nearly that
  // of the ball.
  for (const ElementType type : {ElementType::quad8, ElementType::quad9}) {
    base::Vector3 total{};
    double flux = 0.0;
    for (int side = 0; side < 6; ++side) {
      const ElementType solid = type == ElementType::quad8 ? ElementType::hex20 : ElementType::hex27;
      const Places cube = nodePlaces(solid);
      Places face;
      for (const int node : sideNodes(solid, side)) face.push_back((1.0 / base::norm(cube[node])) * cube[node]);
      const FaceIntegrals integrals = integrateFace(3, face, 1.0);
      for (std::size_t i = 0; i < face.size(); ++i) {
        total = total + integrals.weight[i].flux;
        flux += dot(face[i], integrals.weight[i].flux);
        EXPECT_GT(dot(integrals.weight[i].normal, face[i]), 0.0);
      }
    }
    EXPECT_LT(base::norm(total), 1e-13);
    EXPECT_NEAR(flux / 3.0, 4.0 / 3.0 * pi, type == ElementType::quad8 ? 1.0 : 0.25);
  }
}

}  // namespace
}  // namespace harmos::mesh
