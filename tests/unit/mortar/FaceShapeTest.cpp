#include <gtest/gtest.h>

#include <cmath>

#include <harmos/mortar/detail/FaceShape.hpp>
#include <harmos/mortar/detail/FlatFace.hpp>

namespace harmos::mortar {
namespace {

struct Kind {
  int dimension, nodes;
};
const std::vector<Kind> kinds = {{2, 2}, {2, 3}, {3, 3}, {3, 4}, {3, 6}, {3, 8}, {3, 9}};

TEST(FaceShape, IsOneAtItsNodeAndZeroAtTheOthers) {
  for (const Kind& kind : kinds) {
    const FaceShape& shape = FaceShape::of(kind.dimension, static_cast<std::size_t>(kind.nodes));
    ASSERT_EQ(shape.nodes(), kind.nodes);
    ASSERT_EQ(static_cast<int>(shape.places().size()), kind.nodes);
    for (int i = 0; i < kind.nodes; ++i) {
      const auto values = shape.values(shape.places()[i]);
      for (int j = 0; j < kind.nodes; ++j) EXPECT_DOUBLE_EQ(values[j], i == j ? 1.0 : 0.0) << kind.nodes;
    }
  }
}

TEST(FaceShape, ReproducesPolynomialsOfItsOrderAndTheirDerivatives) {
  for (const Kind& kind : kinds) {
    const FaceShape& shape = FaceShape::of(kind.dimension, static_cast<std::size_t>(kind.nodes));
    const double square = shape.isQuadratic() ? 1.0 : 0.0, y = shape.parentDimension() == 2 ? 1.0 : 0.0;
    const auto f = [&](const Parent& x) {
      return 2.0 + 3.0 * x[0] - y * x[1] + square * (x[0] * x[0] + y * (2.0 * x[0] * x[1] - 5.0 * x[1] * x[1]));
    };
    const Parent at = {0.3, 0.2 * y};
    FaceShape::Values values;
    FaceShape::Gradients gradients;
    shape.evaluate(at, values, gradients);
    double sum = 0.0, alongFirst = 0.0, alongSecond = 0.0, ones = 0.0;
    for (int j = 0; j < kind.nodes; ++j) {
      ones += values[j];
      sum += values[j] * f(shape.places()[j]);
      alongFirst += gradients[j][0] * f(shape.places()[j]);
      alongSecond += gradients[j][1] * f(shape.places()[j]);
    }
    EXPECT_NEAR(ones, 1.0, 1e-15);
    EXPECT_NEAR(sum, f(at), 1e-14) << kind.nodes;
    EXPECT_NEAR(alongFirst, 3.0 + square * (2.0 * at[0] + y * 2.0 * at[1]), 1e-14) << kind.nodes;
    EXPECT_NEAR(alongSecond, y * (-1.0 + square * (2.0 * at[0] - 10.0 * at[1])), 1e-14) << kind.nodes;
  }
}

TEST(FlatFace, FindsTheParentOfAPlaceOnADistortedFace) {
  const std::vector<base::Vector3> square = {{0.0, 0.0, 0.0},  {1.2, 0.1, 0.0},   {0.9, 1.3, 0.0},
                                             {-0.2, 0.8, 0.0}, {0.55, 0.0, 0.0},  {1.1, 0.75, 0.0},
                                             {0.35, 1.1, 0.0}, {-0.1, 0.45, 0.0}, {0.45, 0.6, 0.0}};
  std::vector<base::Vector3> triangle = {square[0], square[1], square[2], square[4], square[5], {0.5, 0.6, 0.0}};
  const Plane plane({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 3);
  for (const int count : {3, 4, 6, 8, 9}) {
    const std::vector<base::Vector3>& points = count % 3 == 0 && count < 9 ? triangle : square;
    std::vector<int> nodes;
    for (int j = 0; j < count; ++j) nodes.push_back(j);
    const FaceShape& shape = FaceShape::of(3, static_cast<std::size_t>(count));
    const FlatFace face(shape, points, nodes, plane);
    EXPECT_EQ(face.distortion() == 0.0, count == 3);
    // Inside, at corners, and a little outside.
    for (const Parent at :
         {Parent{0.3, 0.25}, Parent{0.0, 0.0}, Parent{-1.0, 1.0}, Parent{1.0, 1.0}, Parent{1.2, -0.4}}) {
      base::Vector3 place{};
      for (int j = 0; j < count; ++j) place = place + shape.values(at)[j] * points[j];
      const Parent found = face.parentOf(plane.project(place));
      EXPECT_NEAR(found[0], at[0], 1e-13) << count;
      EXPECT_NEAR(found[1], at[1], 1e-13) << count;
    }
  }
}

}  // namespace
}  // namespace harmos::mortar
