#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "SolvedScene.hpp"

namespace harmos::verification {
namespace {

constexpr double pi = 3.141592653589793;
constexpr double planeStrainModulus = 2.1e5 / (1.0 - 0.09);

/// From -1 .. 1 to -length .. length, fine near 0.
double graded(double s, double length) {
  constexpr double grading = 4.0;
  return length * std::sinh(grading * s) / std::sinh(grading);
}

/// Turns the boxes of a scene into bodies `length` wide and high whose faces at y = 0 have the given radii (0: flat).
void bend(mesh::Mesh& mesh, double length, double lowerRadius, double upperRadius) {
  const auto depth = [&](double x, double radius) {
    return radius > 0.0 ? x * x / (radius + std::sqrt(radius * radius - x * x)) : 0.0;
  };
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const auto& connectivity = mesh.blocks[b].connectivity;
    std::vector<int> nodes(connectivity);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const int node : nodes) {
      base::Vector3& point = mesh.nodes[node];
      const double x = graded(point[0], length), y = graded(point[1], length);
      const bool lower = b == 0;
      const double surface = lower ? -depth(x, lowerRadius) : depth(x, upperRadius);
      point = {x, y + surface * (1.0 - std::abs(y) / length), 0.0};
    }
  }
}

/// Pairs in the order of x.
std::vector<PairValue> sortedPairs(const SolvedScene& run, int step = -1) {
  auto pairs = run.pairs("contact", step);
  std::sort(pairs.begin(), pairs.end(),
            [](const PairValue& a, const PairValue& b) { return a.position[0] < b.position[0]; });
  return pairs;
}

/// Largest |x| where `holds`, and the distance to the next node.
template <class Predicate>
std::pair<double, double> extent(const std::vector<PairValue>& pairs, Predicate holds) {
  std::pair<double, double> result{0.0, 0.0};
  for (std::size_t i = 0; i + 1 < pairs.size(); ++i) {
    if (holds(pairs[i])) result = {pairs[i].position[0], pairs[i + 1].position[0] - pairs[i].position[0]};
  }
  return result;
}

struct Load {
  const char* name;
  double force, halfWidth, pressure;
};

class HertzLine : public ::testing::TestWithParam<Load> {};

TEST_P(HertzLine, HalfWidthAndPressure) {
  const Load& load = GetParam();
  constexpr double radius = 50.0, length = 15.0;
  // a = sqrt(4 P R (1 - nu^2) / (pi E)), p0 = 2 P / (pi a).
  EXPECT_NEAR(std::sqrt(4.0 * load.force * radius / (pi * planeStrainModulus)), load.halfWidth, 1e-5);
  EXPECT_NEAR(2.0 * load.force / (pi * load.halfWidth), load.pressure, 1e-2);
  SceneInput scene = SceneInput::fromFile("cylinders/hertz.xml");
  scene.set(assignment("Values/pressure", 0.5 * load.force / length));
  scene.changeMesh([&](mesh::Mesh& mesh) { bend(mesh, length, 0.0, radius); });
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  // Forces that press curved bodies onto each other took 1182 and more.
  EXPECT_LE(run.result.linearStages, 220);
  EXPECT_NEAR(run.value("P"), 0.5 * load.force, 1e-3 * load.force);
  // A body of finite size on elements of a / 10 or more: the tolerance of the textbook case.
  EXPECT_NEAR(run.value("p0"), load.pressure, 0.03 * load.pressure);
  const auto [halfWidth, element] =
      extent(sortedPairs(run), [](const PairValue& pair) { return pair.status != laws::Status::open; });
  EXPECT_NEAR(halfWidth, load.halfWidth, element);
}

INSTANTIATE_TEST_SUITE_P(Loads, HertzLine,
                         ::testing::Values(Load{"Force500", 500.0, 0.371395, 857.07},
                                           Load{"Force2000", 2000.0, 0.742790, 1714.13}),
                         [](const auto& test) { return test.param.name; });

/// Where the points are, and the cells of the upper body; those of the lower one are 80 x 30.
struct Meshes {
  const char* name;
  const char* pointsOn;  // empty: the nodes of both, which match
  const char* cells;
};

class CattaneoMindlin : public ::testing::TestWithParam<Meshes> {};

TEST_P(CattaneoMindlin, StickZoneAndShear) {
  // Relative curvature 1/50 between two bodies of curvature 1/100 each; the same elasticity, so that normal and
  // tangential problem do not interact.
  constexpr double mu = 0.3, length = 20.0;
  const bool isMatching = *GetParam().pointsOn == '\0';
  const double reach = isMatching ? 0.0 : 1.0;  // of elements
  SceneInput scene = SceneInput::fromFile("cylinders/cattaneo_mindlin.xml");
  scene.set("Mesh/Boxes/upper/Cells=" + std::string(GetParam().cells));
  if (!isMatching) {
    scene.remove("Interfaces/contact/Projection Direction");
    scene.set("Interfaces/contact/Points On=" + std::string(GetParam().pointsOn));
  }
  scene.changeMesh([&](mesh::Mesh& mesh) { bend(mesh, length, 100.0, 100.0); });
  const SolvedScene run(scene);
  ASSERT_TRUE(run.isCertified()) << run.result.reason;
  for (int step = 0; step < run.steps(); ++step) {
    const double force = run.value("P", step), shearForce = std::abs(run.value("Q", step));
    const auto pairs = sortedPairs(run, step);
    const double a = std::sqrt(8.0 * force * 50.0 / (pi * planeStrainModulus));
    const double p0 = 2.0 * force / (pi * a);
    const double c = a * std::sqrt(std::max(0.0, 1.0 - shearForce / (mu * force)));
    EXPECT_NEAR(run.value("p0", step), p0, 0.03 * p0);
    const auto [contact, edge] = extent(pairs, [](const PairValue& p) { return p.status != laws::Status::open; });
    EXPECT_NEAR(contact, a, edge);
    if (step == 0) continue;
    const auto [stick, inner] = extent(pairs, [](const PairValue& p) { return p.status == laws::Status::stick; });
    EXPECT_NEAR(stick, c, (isMatching ? 1.0 : 1.1) * inner);
    const auto exact = [&](double x) {
      const double full = std::sqrt(std::max(0.0, 1.0 - x * x / (a * a)));
      const double core = std::sqrt(std::max(0.0, 1.0 - x * x / (c * c)));
      return mu * p0 * (full - c / a * core);
    };
    // A point has the mean of what is around it, and next to c and a the closed form is steep.
    for (std::size_t i = 1; i + 1 < pairs.size(); ++i) {
      const double x = pairs[i].position[0], around = 0.5 * (pairs[i + 1].position[0] - pairs[i - 1].position[0]);
      double least = exact(x), most = least;
      for (int k = -10; k <= 10; ++k) {
        const double there = exact(x + 0.1 * k * reach * around);
        least = std::min(least, there);
        most = std::max(most, there);
      }
      const double shear = std::abs(pairs[i].traction[1]);
      EXPECT_GE(shear, least - 0.06 * mu * p0) << "x = " << x << ", step " << step + 1;
      EXPECT_LE(shear, most + 0.06 * mu * p0) << "x = " << x << ", step " << step + 1;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, CattaneoMindlin,
                         ::testing::Values(Meshes{"Matching", "", "{80, 30}"},
                                           Meshes{"NonMatchingFineSide", "Side 1", "{63, 26}"},
                                           Meshes{"NonMatchingCoarseSide", "Side 2", "{63, 26}"}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace harmos::verification
