// Laws that give the traction as a function of the jump, against closed forms of where they meet a line.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <harmos/laws/SmoothLaw.hpp>

#include "LawSamples.hpp"

namespace harmos::laws {
namespace {

struct Springs {
  static constexpr const char* name = "Springs";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::two;
  template <class Scalar>
  std::array<Scalar, 3> traction(const std::array<Scalar, 3>& jump, const NodeContext&, const double*) const {
    return {Scalar(normal * jump[0]), Scalar(tangential * jump[1]), Scalar(tangential * jump[2])};
  }
  double normal = 1.0, tangential = 1.0;
  Springs(double n, double t) : normal(n), tangential(t) {}
};

/// t = k (delta - old) + c |delta|^2 delta, coupled, with the jump as history.
struct Cubic {
  static constexpr const char* name = "Cubic";
  static constexpr int historySize = 3;
  static constexpr Sides sides = Sides::two;
  template <class Scalar>
  std::array<Scalar, 3> traction(const std::array<Scalar, 3>& jump, const NodeContext&, const double* old) const {
    const Scalar square = jump[0] * jump[0] + jump[1] * jump[1] + jump[2] * jump[2];
    return {Scalar(2.0 * (jump[0] - old[0]) + 100.0 * square * jump[0]),
            Scalar(2.0 * (jump[1] - old[1]) + 100.0 * square * jump[1]),
            Scalar(2.0 * (jump[2] - old[2]) + 100.0 * square * jump[2])};
  }
  void update(const base::Vector3& jump, const NodeContext&, const double*, double* now) const {
    std::copy(jump.begin(), jump.end(), now);
  }
  Status status(const base::Vector3& jump, const NodeContext&, const double*) const {
    return jump[0] > 0.0 ? Status::slip : Status::stick;
  }
};

/// Pressure that grows exponentially with the overclosure.
struct Cushion {
  static constexpr const char* name = "Cushion";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::two;
  template <class Scalar>
  std::array<Scalar, 3> traction(const std::array<Scalar, 3>& jump, const NodeContext&, const double*) const {
    return {Scalar(1.0 - exp(-1000.0 * jump[0])), Scalar(jump[1]), Scalar(jump[2])};
  }
};

/// Along the slip, without a derivative where there is none.
struct SaturatingSlip {
  static constexpr const char* name = "Saturating Slip";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::two;
  template <class Scalar>
  std::array<Scalar, 3> traction(const std::array<Scalar, 3>& jump, const NodeContext&, const double*) const {
    const Scalar slip = sqrt(jump[1] * jump[1] + jump[2] * jump[2]);
    const Scalar share = 5.0 * tanh(slip / 0.1) / slip;
    return {Scalar(10.0 * jump[0]), Scalar(share * jump[1]), Scalar(share * jump[2])};
  }
};

/// Above the line delta = -t everywhere.
struct Parabola {
  static constexpr const char* name = "Parabola";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::two;
  template <class Scalar>
  std::array<Scalar, 3> traction(const std::array<Scalar, 3>& jump, const NodeContext&, const double*) const {
    return {Scalar(1.0 + jump[0] * jump[0]), Scalar(jump[1]), Scalar(jump[2])};
  }
};

template <class G>
using Smooth = PointwiseLaw<SmoothLaw<G>>;

TEST(SmoothLaw, MeetsLinesAsTheClosedFormDoes) {
  Random random(1);
  for (const double n : {1e-12, 1.0, 1e12}) {
    for (const double t : {0.0, 1.0, 1e6}) {
      const Smooth<Springs> smooth(n, t);
      const auto closed = makeLaw("Linear Elastic", {{"Normal Stiffness", n}, {"Tangential Stiffness", t}});
      for (int i = 0; i < 50; ++i) {
        const LocalLine line = randomLine(random);
        const base::Vector3 expected = Node(*closed).solve(line).traction;
        EXPECT_LE(norm(Node(smooth).solve(line).traction - expected), 1e-14 * norm(expected));
      }
    }
  }
}

TEST(SmoothLaw, IsSmoothAndKeepsWhatTheStructSays) {
  const Smooth<Cubic> law;
  EXPECT_TRUE(law.isSmooth());
  EXPECT_EQ(law.historySize(), 3);
  EXPECT_STREQ(law.name(), "Cubic");
  EXPECT_EQ(law.sides(), Sides::two);
}

TEST(SmoothLaw, FindsPointsOfCoupledGraphs) {
  Random random(2);
  const Smooth<Cubic> law;
  for (int i = 0; i < 200; ++i) {
    Node node(law);
    base::Vector3 old{};
    for (int step = 0; step < 3; ++step) {
      const LocalLine line = randomLine(random);
      const LocalState state = node.solve(line);
      const base::Vector3 jump = line.jump(state.traction);
      const base::Vector3 expected = 2.0 * (jump - old) + 100.0 * dot(jump, jump) * jump;
      // The jump carries the round-off of the line.
      const double slope = 2.0 + 300.0 * dot(jump, jump);
      const double lost = 1e-14 * (norm(line.freeJump) + line.compliance * norm(state.traction));
      EXPECT_LE(norm(state.traction - expected), slope * lost + 1e-13 * norm(expected));
      EXPECT_EQ(state.status, jump[0] > 0.0 ? Status::slip : Status::stick);
      node.accept();
      old = jump;
    }
  }
}

// Far from where the method starts the exponential is 1e4 times steeper.
TEST(SmoothLaw, ComesThroughSteepGraphs) {
  const Smooth<Cushion> law;
  for (const double free : {-1.0, -0.1, -1e-3, 1e-3, 0.1, 1.0}) {
    for (const double compliance : {1e-9, 1e-3, 1.0, 1e3}) {
      const LocalLine line{{free, 0.0, 0.0}, compliance};
      const LocalState state = Node(law).solve(line);
      const double jump = line.jump(state.traction)[0];
      // The terms of the formula cancel; the jump carries that, times the compliance.
      const double lost = 1e-12 * (std::abs(free) + compliance * std::abs(state.traction[0]));
      EXPECT_NEAR(state.traction[0], -std::expm1(-1000.0 * jump),
                  1e-12 * std::abs(state.traction[0]) + 1000.0 * std::exp(-1000.0 * jump) * lost);
    }
  }
}

TEST(SmoothLaw, BeginsElsewhereWhereThereIsNoDerivativeAtRest) {
  const LocalLine line{{0.1, 0.3, 0.4}, 0.02};
  const LocalState state = Node(Smooth<SaturatingSlip>()).solve(line);
  const base::Vector3 jump = line.jump(state.traction);
  const double slip = tangentialNorm(jump);
  EXPECT_NEAR(tangentialNorm(state.traction), 5.0 * std::tanh(slip / 0.1), 1e-12);
  EXPECT_NEAR(slip + 0.02 * tangentialNorm(state.traction), 0.5, 1e-14);
  EXPECT_NEAR(state.traction[2] / state.traction[1], 4.0 / 3.0, 1e-12);
}

TEST(SmoothLaw, SaysWhereThereIsNoPoint) {
  const Smooth<Parabola> law;
  EXPECT_NEAR(Node(law).solve({{0.75, 0.0, 0.0}, 0.5}).traction[0],
              1.0 + (std::sqrt(1.5) - 1.0) * (std::sqrt(1.5) - 1.0), 1e-14);
  try {
    Node(law).solve({{0.0, 0.0, 0.0}, 1.0});
    FAIL() << "found a point";
  } catch (const NoIntersection& error) {
    EXPECT_NE(std::string(error.what()).find("at point 1, place (1, 2, 3), no traction"), std::string::npos)
        << error.what();
    EXPECT_EQ(error.code(), base::ExitCode::notConverged);
  }
}

TEST(SmoothLaw, HandsOnWhatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(Node(Smooth<Springs>(1.0, 1.0)).solve({{nan, 0.0, 0.0}, 1.0}).traction[0]));
}

}  // namespace
}  // namespace harmos::laws
