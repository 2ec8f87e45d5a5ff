#include <cmath>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/PairFields.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr double accuracy = 1e-8;

/// Solves and keeps the state, so that any response can be asked afterwards.
struct Solved {
  explicit Solved(BoxAssembly boxes) : cubes(std::move(boxes)), solver(cubes.assembly(), options(), self(), timers) {
    result = solver.solve();
    EXPECT_EQ(result.outcome, Outcome::certified) << result.reason;
  }
  static LatinOptions options() {
    LatinOptions chosen;
    chosen.accuracy = accuracy;
    return chosen;
  }
  std::vector<double> operator()(const Response& response) const { return response.evaluate(solver.state()); }

  BoxAssembly cubes;
  base::Timers timers;
  LatinSolver solver;
  LatinResult result;
};

BoxAssembly pulled() {
  return twoCubes(laws::makeLaw("Perfect"),
                  laws::makeLaw("Prescribed Traction", {{"X", 1.0}, {"Y", 2.0}, {"Z", 3.0}}, {{"Z", {1.0, -1.0}}}), 2);
}

TEST(ResultantResponse, IsTheForceOnSideOne) {
  const Solved solved(pulled());
  for (int joint : {1, 2}) {  // an interface and a boundary with prescribed traction
    const double expected[] = {1.0, 2.0, 3.0};
    for (std::size_t c = 0; c < 3; ++c) {
      base::Vector3 direction{};
      direction[c] = 1.0;
      const auto force = solved(ResultantResponse("force", {joint}, {direction}));
      EXPECT_NEAR(force[0], expected[c], 10.0 * accuracy);
      EXPECT_NEAR(force[1], c == 2 ? -3.0 : expected[c], 10.0 * accuracy);
    }
    // Along the normal, positive in tension: the force of a bolt.
    const auto tension = solved(ResultantResponse("tension", {joint}, {}));
    EXPECT_NEAR(tension[0], 3.0, 10.0 * accuracy);
    EXPECT_NEAR(tension[1], -3.0, 10.0 * accuracy);
  }
  // The clamp holds against it.
  EXPECT_NEAR(solved(ResultantResponse("reaction", {0}, {{0.0, 1.0, 0.0}}))[0], -2.0, 10.0 * accuracy);
  // Several pieces of one interface add up.
  EXPECT_NEAR(solved(ResultantResponse("both", {0, 1}, {{0.0, 1.0, 0.0}}))[0], 0.0, 10.0 * accuracy);
}

/// A law of a host that knows its nodes: the traction along x is the number of the node.
class Varying : public laws::InterfaceLaw {
 public:
  const char* name() const override { return "Varying"; }
  int historySize() const override { return 0; }
  laws::Frame frame() const override { return laws::Frame::global; }
  laws::Sides sides() const override { return laws::Sides::one; }
  bool prescribesTraction() const override { return true; }
  bool dissipates() const override { return false; }
  void solve(int, const laws::NodeArrays& nodes) const override {
    for (int i = 0; i < nodes.count; ++i) nodes.state[i].traction = {1.0 * i, 0.0, 0.0};
  }
};

TEST(ResultantResponse, OfAPrescribedTractionMayVaryFromNodeToNode) {
  const Solved solved(twoCubes(laws::makeLaw("Perfect"), std::make_shared<Varying>(), 1));
  const assembly::Interface& loaded = solved.solver.state().assembly().interfaces[2];
  double expected = 0.0;
  for (int p = 0; p < loaded.pairs(); ++p) expected += p * loaded.area[p];
  ASSERT_GT(expected, 0.0);
  for (int joint : {1, 2}) {
    EXPECT_NEAR(solved(ResultantResponse("force", {joint}, {{1.0, 0.0, 0.0}}))[0], expected,
                10.0 * accuracy * expected);
  }
}

TEST(ResultantResponse, WithACentreIsTheMoment) {
  const Solved solved(pulled());
  // The traction (1, 2, 3) acts at (0.5, 0.5, 2): about the centre of the joint (0.5, 0.5, 1) it is (-2, 1, 0).
  const base::Vector3 centre{0.5, 0.5, 1.0};
  const double expected[] = {-2.0, 1.0, 0.0};
  for (std::size_t c = 0; c < 3; ++c) {
    base::Vector3 direction{};
    direction[c] = 1.0;
    for (int joint : {1, 2})
      EXPECT_NEAR(solved(ResultantResponse("moment", {joint}, {direction}, {centre}))[0], expected[c], 20.0 * accuracy);
  }
}

TEST(DisplacementResponse, IsAWeightedSumAlongADirection) {
  const Solved solved(pulled());
  const auto& top = solved.solver.state().assembly().interfaces[2];
  std::vector<DisplacementResponse::Node> nodes;
  double expected = 0.0;
  for (int p = 0; p < top.pairs(); ++p) {
    nodes.push_back({top.body1, top.trace1.node(p), top.area[p]});
    const base::Vector3 u = solved.solver.state().displacement(top.body1, top.trace1.node(p), 0);
    expected += top.area[p] * (0.6 * u[0] + 0.8 * u[2]);
  }
  EXPECT_NEAR(solved(DisplacementResponse("u", nodes, {0.6, 0.0, 0.8}))[0], expected, 1e-14);
}

constexpr double friction = 0.3;

/// A cube pressed onto another one by 4 and dragged by 0, 1, 2, 1 along x.
BoxAssembly dragged() {
  BoxAssembly cubes =
      twoCubes(laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", friction}}),
               laws::makeLaw("Prescribed Displacement", {{"X", 1.0}, {"Y", 0.0}}, {{"X", {0, 1, 2, 1}}}), 4);
  const assembly::Interface& top = cubes.assembly().interfaces[2];
  base::Matrix& loads = cubes.assembly().bodies[1].loads;
  loads.shape(3 * static_cast<int>(cubes.assembly().bodies[1].nodes.size()), 4);
  for (int p = 0; p < top.pairs(); ++p) {
    for (int t = 0; t < 4; ++t) loads(3 * top.trace1.node(p) + 2, t) = -4.0 * top.area[p];
  }
  return cubes;
}

TEST(DissipationResponse, IsFrictionTimesWay) {
  const Solved solved(dragged());
  EXPECT_NEAR(solved(ResultantResponse("push", {2}, {{1.0, 0.0, 0.0}}))[2], 4.0 * friction, 4.0 * accuracy);
  const auto loss = solved(DissipationResponse("loss", {0, 1}));
  // Sliding goes on from step 2 to step 3, so that the elastic shapes stay and all slips by 1.
  EXPECT_NEAR(loss[2] - loss[1], 4.0 * friction * 1.0, 20.0 * accuracy);
  EXPECT_GT(loss[1] - loss[0], 0.0);
  EXPECT_GT(loss[3] - loss[2], 0.0);
  EXPECT_LT(loss[3] - loss[2], 4.0 * friction * 1.0);  // the way back starts by sticking
}

TEST(MaximumResponse, IsTheLargestOverTheNodes) {
  const Solved solved(dragged());
  const PairFields fields = pairFields(solved.solver.state(), 1);
  double pressure = 0.0, slip = 0.0, tangential = 0.0;
  for (int p = 0; p < fields.pairs; ++p) {
    const base::Vector3& f = fields.traction[fields.at(2, p)];
    const base::Vector3& jump = fields.jump[fields.at(2, p)];
    pressure = std::max(pressure, -f[0]);
    tangential = std::max(tangential, std::hypot(f[1], f[2]));
    slip = std::max(slip, std::hypot(jump[1], jump[2]));
    EXPECT_LE(std::hypot(f[1], f[2]), -friction * f[0] + 1e-12);
  }
  using Field = MaximumResponse::Field;
  EXPECT_DOUBLE_EQ(solved(MaximumResponse("p", {1}, Field::contactPressure))[2], pressure);
  EXPECT_DOUBLE_EQ(solved(MaximumResponse("p", {1}, Field::normalTraction))[2], pressure);
  EXPECT_DOUBLE_EQ(solved(MaximumResponse("t", {1}, Field::tangentialTraction))[2], tangential);
  EXPECT_DOUBLE_EQ(solved(MaximumResponse("s", {1}, Field::slip))[2], slip);
  EXPECT_NEAR(slip, 2.0, 0.05);
}

TEST(PairFields, OfAPrescribedTractionHaveItAndTheDisplacement) {
  const Solved solved(pulled());
  const PairFields fields = pairFields(solved.solver.state(), 2);
  ASSERT_EQ(fields.pairs, 9);
  for (int p = 0; p < fields.pairs; ++p) {
    // n = z, and t1, t2 are some turn of x, y.
    const base::Vector3& f = fields.traction[fields.at(1, p)];
    EXPECT_NEAR(f[0], -3.0, 1e-12);
    EXPECT_NEAR(std::hypot(f[1], f[2]), std::hypot(1.0, 2.0), 1e-12);
    const auto& top = solved.solver.state().assembly().interfaces[2];
    const base::Vector3 u = solved.solver.state().displacement(1, top.trace1.node(p), 1);
    EXPECT_NEAR(fields.jump[fields.at(1, p)][0], -u[2], 1e-12);
  }
}

TEST(PairFields, SayWhatEachNodeDoes) {
  const Solved solved(dragged());
  const PairFields fields = pairFields(solved.solver.state(), 1);
  for (int p = 0; p < fields.pairs; ++p) {
    const laws::Status status = fields.status[fields.at(2, p)];
    const bool isLoaded = fields.traction[fields.at(2, p)][0] < 0.0;
    EXPECT_EQ(status, isLoaded ? laws::Status::slip : laws::Status::open);
  }
}

/// 1, then nothing that can be told, as of a host that divides by zero.
class Undefined : public Response {
 public:
  Undefined() : Response("undefined", Quantity::force) {}
  std::vector<double> evaluate(const Iterate&) const override { return {1.0, std::nan("")}; }
};

// Comparisons with NaN are false: the error estimate would pass it over and certify it.
TEST(Response, ThatIsNotFiniteIsNeverCertified) {
  BoxAssembly cubes = pulled();
  base::Timers timers;
  LatinSolver solver(cubes.assembly(), Solved::options(), self(), timers);
  solver.addResponse(std::make_shared<Undefined>());
  try {
    solver.solve();
    FAIL() << "no error";
  } catch (const base::Error& error) {
    EXPECT_STREQ(error.what(), "response \"undefined\", load step 2: the value is not finite (NaN or infinity)");
  }
}

}  // namespace
}  // namespace harmos::latin
