#include <gtest/gtest.h>

#include <harmos/laws/FaceLaw.hpp>

#include "LawSamples.hpp"
#include "MakeLaw.hpp"

namespace harmos::laws {
namespace {

using Points = std::vector<std::pair<base::Vector3, double>>;

Points randomPoints(int count, int dimension) {
  Random random(7);
  Points points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(randomVector(random), magnitude(random));
    if (dimension == 2) points.back().first[2] = 0.0;
  }
  return points;
}

/// Force, and moment about a point, of a law on a face.
FaceMotions::Six resultantOf(const InterfaceLaw& law, const Points& points, const base::Vector3& about) {
  std::vector<base::Vector3> position;
  for (const auto& point : points) position.push_back(point.first);
  const std::vector<LocalLine> lines(points.size());
  const std::vector<double> gaps(points.size(), 0.0);
  std::vector<LocalState> states(points.size());
  law.solve(0, {static_cast<int>(points.size()), lines.data(), gaps.data(), nullptr, nullptr, states.data(),
                position.data()});
  FaceMotions::Six sum{};
  for (std::size_t p = 0; p < points.size(); ++p) {
    const base::Vector3 force = points[p].second * states[p].traction;
    const base::Vector3 moment = base::cross(position[p] - about, force);
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += force[i];
      sum[i + 3] += moment[i];
    }
  }
  return sum;
}

TEST(RemoteForce, HasTheResultantThatIsAskedFor) {
  const std::map<std::string, double> values{{"X", 1.0},        {"Y", -2.0},       {"Z", 3.0},
                                             {"Moment X", 4.0}, {"Moment Y", 5.0}, {"Moment Z", -6.0}};
  const base::Vector3 point{7.0, -8.0, 9.0};
  input::Parameters parameters("law");
  for (const auto& [name, value] : values) parameters.set(name, value);
  parameters.set("Type", std::string("Remote Force")).set("Point", std::vector<double>{7.0, -8.0, 9.0});
  const std::shared_ptr<const InterfaceLaw> law = builtInLaws().create(parameters);
  const Points points = randomPoints(9, 3);
  const auto face = FaceMotions::of(points, 3);
  ASSERT_TRUE(face);
  const auto bound = dynamic_cast<const FaceLaw&>(*law).on(std::make_shared<const FaceMotions>(*face));
  const FaceMotions::Six found = resultantOf(*bound, points, point);
  std::size_t i = 0;
  for (const char* name : {"X", "Y", "Z", "Moment X", "Moment Y", "Moment Z"}) {
    EXPECT_NEAR(found[i++], values.at(name), 1e-10) << name;
  }
  // What replaces it acts on the same face.
  EXPECT_EQ(dynamic_cast<const FaceLaw&>(*inPlaceOf(*bound, law)).face(), dynamic_cast<const FaceLaw&>(*bound).face());
  EXPECT_EQ(inPlaceOf(*makeLaw("Pressure", {{"Pressure", 1.0}}), bound), bound);
}

TEST(RemoteForce, StaysInThePlane) {
  const Points points = randomPoints(5, 2);
  const auto face = FaceMotions::of(points, 2);
  ASSERT_TRUE(face);
  const std::shared_ptr<const InterfaceLaw> law = makeLaw("Remote Force", {{"X", 2.0}, {"Moment Z", 3.0}});
  const auto bound = dynamic_cast<const FaceLaw&>(*law).on(std::make_shared<const FaceMotions>(*face));
  const FaceMotions::Six found = resultantOf(*bound, points, face->centre());
  const FaceMotions::Six expected{2.0, 0.0, 0.0, 0.0, 0.0, 3.0};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
}

TEST(FaceMotions, AreNotSeenOnALine) {
  const Points line{{{0.0, 0.0, 0.0}, 1.0}, {{1.0, 1.0, 0.0}, 1.0}, {{3.0, 3.0, 0.0}, 1.0}};
  EXPECT_FALSE(FaceMotions::of(line, 3));
  EXPECT_TRUE(FaceMotions::of(line, 2));
  EXPECT_FALSE(FaceMotions::of({{{1.0, 2.0, 0.0}, 1.0}}, 2));
  EXPECT_FALSE(FaceMotions::of({}, 3));
}

}  // namespace
}  // namespace harmos::laws
