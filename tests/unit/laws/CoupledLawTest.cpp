#include <gtest/gtest.h>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/laws/FaceLaw.hpp>

#include "LawSamples.hpp"
#include "MakeLaw.hpp"

namespace harmos::laws {
namespace {

/// The points of a face, and what a law made of them.
struct Points {
  std::vector<LocalLine> line;
  std::vector<double> gap, area, oldHistory, newHistory;
  std::vector<base::Vector3> position;
  std::vector<LocalState> state;

  int historySize;

  explicit Points(int count, int size = 1, unsigned seed = 3) : historySize(size) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
      line.push_back(randomLine(random));
      area.push_back(magnitude(random));
      position.push_back(randomVector(random));
    }
    gap.assign(line.size(), 0.0);
    state.resize(line.size());
    oldHistory.assign(line.size() * static_cast<std::size_t>(historySize), 0.0);
    newHistory = oldHistory;
  }
  /// Points first .. first + count - 1.
  NodeArrays arrays(int first, int count) {
    NodeArrays nodes;
    nodes.count = count;
    nodes.line = line.data() + first;
    nodes.gap = gap.data() + first;
    nodes.oldHistory = oldHistory.data() + first * historySize;
    nodes.newHistory = newHistory.data() + first * historySize;
    nodes.state = state.data() + first;
    nodes.position = position.data() + first;
    nodes.area = area.data() + first;
    return nodes;
  }
  NodeArrays arrays() { return arrays(0, static_cast<int>(line.size())); }
  double normalForce() const {
    double sum = 0.0;
    for (std::size_t p = 0; p < line.size(); ++p) sum += area[p] * state[p].traction[0];
    return sum;
  }
};

std::shared_ptr<const CoupledLaw> pretension(double force) {
  return std::dynamic_pointer_cast<const CoupledLaw>(
      std::shared_ptr<const InterfaceLaw>(makeLaw("Pretension", {{"Force", force}})));
}

/// Locked from time 1 on, of three load steps.
std::unique_ptr<InterfaceLaw> lockedFrom(double time) {
  input::Parameters parameters("law");
  parameters.set("Type", std::string("Pretension")).set("Force", 5.0).set("Locked From", time);
  parameters.attach(std::make_shared<input::Histories>(std::vector<double>{1.0, 2.0, 3.0}));
  return builtInLaws().create(parameters);
}

TEST(Pretension, HasItsForceAndOneOverlap) {
  const auto law = pretension(5.0);
  ASSERT_TRUE(law);
  Points points(7);
  law->solve(0, points.arrays());
  EXPECT_NEAR(points.normalForce(), 5.0, 1e-12);
  for (std::size_t p = 0; p < points.line.size(); ++p) {
    const base::Vector3 jump = points.line[p].jump(points.state[p].traction);
    EXPECT_NEAR(jump[0], -points.newHistory[0], 1e-12);
    EXPECT_NEAR(jump[1], 0.0, 1e-12);
    EXPECT_NEAR(jump[2], 0.0, 1e-12);
    EXPECT_EQ(points.newHistory[p], points.newHistory[0]);
  }
}

/// Laws of every kind, bound to these points where they ask for a face.
std::vector<std::shared_ptr<const CoupledLaw>> laws(const Points& points) {
  std::vector<std::pair<base::Vector3, double>> places;
  for (std::size_t p = 0; p < points.position.size(); ++p) places.emplace_back(points.position[p], points.area[p]);
  const auto face = std::make_shared<const FaceMotions>(FaceMotions::of(places, 3).value());
  std::vector<input::Parameters> all;
  all.emplace_back("law").set("Type", std::string("Pretension")).set("Force", 5.0);
  for (const char* kind : {"Distributing", "Rigid"}) {
    input::Parameters& held = all.emplace_back("law");
    held.set("Type", std::string("Remote Displacement")).set("Kind", std::string(kind)).set("X", 0.3).set("Y", -0.2);
    held.set("Y Stiffness", 2.0).set("Rotation Z", 0.1).set("Force Z", 4.0).set("Point", std::vector<double>{1, 2, 3});
  }
  input::Parameters& spring = all.emplace_back("law");
  spring.set("Type", std::string("Face Spring")).set("Point", std::vector<double>{1, 2, 3}).set("Force", 2.0);
  spring.set("Axis", std::vector<double>{1, 1, 0}).set("Shear Stiffness", 3.0).set("Torsion Stiffness", 0.0);
  std::vector<std::shared_ptr<const CoupledLaw>> result;
  for (const input::Parameters& parameters : all) {
    std::shared_ptr<const InterfaceLaw> law = builtInLaws().create(parameters);
    if (const auto* ofFace = dynamic_cast<const FaceLaw*>(law.get())) law = ofFace->on(face);
    result.push_back(std::dynamic_pointer_cast<const CoupledLaw>(law));
  }
  return result;
}

std::vector<double> sumsOf(const CoupledLaw& law, Points& points) {
  std::vector<double> sums(static_cast<std::size_t>(law.sums()), 0.0);
  law.addToSums(0, points.arrays(), sums.data());
  return sums;
}

// Of every component the unit tractions have its resultant in the point; what is left free has the force that is given.
TEST(CoupledLaws, HaveUnitTractionsOfUnitResultant) {
  const Points points(9);
  const base::Vector3 point{1.0, 2.0, 3.0};
  int faces = 0;
  for (const auto& law : laws(points)) {
    const auto* ofFace = dynamic_cast<const FaceLaw*>(law.get());
    if (ofFace == nullptr) continue;
    ++faces;
    const bool isSpring = ofFace->onOtherFace() != nullptr;
    for (std::size_t c = 0; c < 6; ++c) {
      base::Vector3 force{}, moment{};
      for (std::size_t p = 0; p < points.position.size(); ++p) {
        const base::Vector3 f = points.area[p] * ofFace->unitTractions(points.position[p])[c];
        force = force + f;
        moment = moment + base::cross(points.position[p] - point, f);
      }
      EXPECT_NEAR(base::norm(force), c < 3 ? 1.0 : 0.0, 1e-10) << law->name() << ' ' << c;
      EXPECT_NEAR(base::norm(moment), c < 3 ? 0.0 : 1.0, 1e-10) << law->name() << ' ' << c;
      if (isSpring) continue;  // along axes of its own
      EXPECT_NEAR((c < 3 ? force : moment)[c % 3], 1.0, 1e-10) << law->name() << ' ' << c;
    }
    const auto resultants = ofFace->resultants(0).value();
    const std::array<bool, 6> borne = isSpring ? std::array<bool, 6>{false, true, true, false, true, true}
                                               : std::array<bool, 6>{true, true, false, false, false, true};
    for (std::size_t c = 0; c < 6; ++c) {
      EXPECT_EQ(resultants[c].isBorne, borne[c]) << law->name() << ' ' << c;
      EXPECT_EQ(resultants[c].force, !isSpring && c == 2 ? 4.0 : 0.0) << law->name() << ' ' << c;
    }
  }
  EXPECT_EQ(faces, 3);
}

TEST(CoupledLaws, AreTheSameInPieces) {
  const int size = 2;  // of the longest history
  for (const auto& law : laws(Points(9))) {
    Points whole(9, size), pieces(9, size);
    law->solve(0, whole.arrays());
    std::vector<double> sums(static_cast<std::size_t>(law->sums()), 0.0);
    for (const auto& [first, count] : {std::pair(0, 4), std::pair(4, 0), std::pair(4, 5)}) {
      law->addToSums(0, pieces.arrays(first, count), sums.data());
    }
    for (const auto& [first, count] : {std::pair(0, 4), std::pair(4, 0), std::pair(4, 5)}) {
      law->solvePoints(0, pieces.arrays(first, count), sums.data());
    }
    for (std::size_t p = 0; p < whole.state.size(); ++p) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(pieces.state[p].traction[c], whole.state[p].traction[c], 1e-10) << law->name();
      }
    }
  }
}

// What solveTangent() says is how tractions change, and symmetric in the sum of h a.b.
TEST(CoupledLaws, HaveASymmetricTangent) {
  const Points given(6, 2);
  for (const auto& law : laws(given)) {
    Points at(given), moved(given), a(6, 2, 5), b(6, 2, 6);
    a.position = b.position = at.position;
    for (std::size_t p = 0; p < at.line.size(); ++p) {
      a.line[p].compliance = b.line[p].compliance = at.line[p].compliance;
      a.area[p] = b.area[p] = at.area[p];
      moved.line[p].freeJump = at.line[p].freeJump + a.line[p].freeJump;
    }
    law->solve(0, at.arrays());
    law->solve(0, moved.arrays());
    for (Points* direction : {&a, &b}) law->solveTangent(0, direction->arrays(), sumsOf(*law, *direction).data());
    double ab = 0.0, ba = 0.0, size = 0.0;
    for (const LocalState& state : a.state) size = std::max(size, base::norm(state.traction));
    EXPECT_GT(size, 0.0);
    for (std::size_t p = 0; p < at.line.size(); ++p) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(moved.state[p].traction[c] - at.state[p].traction[c], a.state[p].traction[c], 1e-10 * size)
            << law->name();
      }
      ab += at.area[p] * base::dot(a.line[p].freeJump, b.state[p].traction);
      ba += at.area[p] * base::dot(b.line[p].freeJump, a.state[p].traction);
    }
    EXPECT_NEAR(ab, ba, 1e-9 * std::abs(ab) + 1e-12) << law->name();
  }
}

TEST(Pretension, KeepsItsOverlapOnceLocked) {
  const auto law = lockedFrom(1.0);
  Points points(4);
  law->solve(0, points.arrays());
  const double overlap = points.newHistory[0];
  points.oldHistory = points.newHistory;
  for (LocalLine& line : points.line) line.freeJump[0] += 1.0;
  law->solve(1, points.arrays());
  EXPECT_GT(std::abs(points.normalForce() - 5.0), 0.1);
  for (const double now : points.newHistory) EXPECT_EQ(now, overlap);
  for (std::size_t p = 0; p < points.line.size(); ++p) {
    EXPECT_NEAR(points.line[p].jump(points.state[p].traction)[0], -overlap, 1e-12);
  }
  EXPECT_THROW(lockedFrom(0.5), base::Error);
}

}  // namespace
}  // namespace harmos::laws
