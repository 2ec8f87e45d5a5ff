#include <gtest/gtest.h>

#include <cmath>

#include <harmos/scene/detail/Span.hpp>

namespace harmos::scene {
namespace {

const base::Frame axes{{{{{1.0, 0.0, 0.0}}}, {{{0.0, 1.0, 0.0}}}, {{{0.0, 0.0, 1.0}}}}};

TEST(Span, KnowsWhatFollowsAndWhatIsLeft) {
  Span span;
  EXPECT_EQ(span.complement(axes), std::vector<base::Vector3>(axes.begin(), axes.end()));
  const base::Vector3 oblique{{2.0, 2.0, 0.0}}, across{{1.0, -1.0, 0.0}};
  span.add(oblique);
  span.add({{1.0, 1.0 + 1e-9, 0.0}});
  EXPECT_TRUE(span.contains({{-3.0, -3.0, 0.0}}));
  EXPECT_TRUE(span.excludes(across));
  EXPECT_FALSE(span.contains(axes[0]));
  EXPECT_FALSE(span.excludes(axes[0]));
  const auto rest = span.complement(axes);
  ASSERT_EQ(rest.size(), 2u);
  EXPECT_EQ(rest[0], axes[2]);
  EXPECT_NEAR(std::abs(dot(rest[1], across)), std::sqrt(2.0), 1e-12);
}

TEST(Span, HoldsAllDirectionsOfThreeThatDiffer) {
  Span span;
  span.add({{1.0, 0.0, 0.0}});
  span.add({{1.0, 1e-3, 0.0}});
  EXPECT_FALSE(span.isSpace());
  span.add({{1.0, 1.0, 1e-3}});
  EXPECT_TRUE(span.isSpace());
  EXPECT_TRUE(span.complement(axes).empty());
  EXPECT_TRUE(span.contains({{0.3, -0.2, 5.0}}));
}

}  // namespace
}  // namespace harmos::scene
