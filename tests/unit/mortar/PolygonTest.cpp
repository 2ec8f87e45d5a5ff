#include <gtest/gtest.h>

#include <cmath>

#include <harmos/mortar/detail/PolygonQuadrature.hpp>

namespace harmos::mortar {
namespace {

ConvexPolygon square(double x0, double y0, double size) {
  return ConvexPolygon(std::vector<Flat>{{x0, y0}, {x0 + size, y0}, {x0 + size, y0 + size}, {x0, y0 + size}});
}

TEST(ConvexPolygon, IsCounterClockwiseWhateverTheCornersWere) {
  const ConvexPolygon polygon(std::vector<Flat>{{0.0, 0.0}, {0.0, 2.0}, {3.0, 0.0}});
  EXPECT_DOUBLE_EQ(polygon.area(), 3.0);
  EXPECT_EQ(polygon[0], (Flat{3.0, 0.0}));
}

TEST(ConvexPolygon, HasInCommonWhatLiesInBoth) {
  EXPECT_DOUBLE_EQ(intersection(square(0.0, 0.0, 1.0), square(0.25, 0.5, 1.0)).area(), 0.375);
  EXPECT_DOUBLE_EQ(intersection(square(0.0, 0.0, 1.0), square(0.25, 0.25, 0.5)).area(), 0.25);
  EXPECT_DOUBLE_EQ(intersection(square(0.25, 0.25, 0.5), square(0.0, 0.0, 1.0)).area(), 0.25);
  EXPECT_EQ(intersection(square(0.0, 0.0, 1.0), square(2.0, 0.0, 1.0)).corners(), 0);
  EXPECT_DOUBLE_EQ(intersection(square(0.0, 0.0, 1.0), square(0.0, 0.0, 1.0)).area(), 1.0);
  // A square and one that is turned by 45 degrees about the same centre: an octagon.
  const double r = std::sqrt(0.5);
  const ConvexPolygon turned(std::vector<Flat>{{0.5 + r, 0.5}, {0.5, 0.5 + r}, {0.5 - r, 0.5}, {0.5, 0.5 - r}});
  const ConvexPolygon octagon = intersection(square(0.0, 0.0, 1.0), turned);
  EXPECT_EQ(octagon.corners(), 8);
  EXPECT_NEAR(octagon.area(), 2.0 * std::sqrt(2.0) - 2.0, 1e-15);
}

TEST(ConvexPolygon, OfTwoCornersIsASegment) {
  const auto segment = [](double from, double to) { return ConvexPolygon(std::vector<Flat>{{from, 0.0}, {to, 0.0}}); };
  EXPECT_DOUBLE_EQ(intersection(segment(0.0, 1.0), segment(2.0, 0.5)).area(), 0.5);
  EXPECT_EQ(intersection(segment(0.0, 1.0), segment(1.0, 2.0)).corners(), 0);
}

TEST(PolygonQuadrature, IsExactUpToItsDegree) {
  // int x^a y^b over the triangle (0, 0), (1, 0), (0, 1) is a! b! / (a + b + 2)!.
  const ConvexPolygon triangle(std::vector<Flat>{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}});
  const ConvexPolygon segment(std::vector<Flat>{{0.0, 0.0}, {1.0, 0.0}});
  std::vector<QuadraturePoint> points;
  for (int degree = 0; degree <= 20; ++degree) {
    integratePolygon(triangle, degree, points);
    for (int a = 0; a <= degree; ++a) {
      double sum = 0.0;
      for (const auto& at : points) sum += std::pow(at.place[0], a) * std::pow(at.place[1], degree - a) * at.weight;
      const double exact = std::exp(std::lgamma(a + 1) + std::lgamma(degree - a + 1) - std::lgamma(degree + 3));
      EXPECT_NEAR(sum, exact, 1e-13 * exact) << a << " of " << degree;
    }
    integratePolygon(segment, degree, points);
    double sum = 0.0;
    for (const auto& at : points) sum += std::pow(at.place[0], degree) * at.weight;
    EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-14);
  }
}

}  // namespace
}  // namespace harmos::mortar
