// Laws of joints that slip by and by, yield or creep, against closed forms, point by point.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "LawSamples.hpp"

namespace harmos::laws {
namespace {

constexpr double rigid = 1e-9;  // compliance of a line on which the jump is as good as given

/// A law led along tangential jumps, with what it loses in all.
class Path {
 public:
  explicit Path(const InterfaceLaw& law, double duration = 1.0)
      : law_(law), node_(law), duration_(duration), old_(static_cast<std::size_t>(law.historySize()), 0.0) {}

  /// Traction along t1 at the next jump.
  double to(double jump) {
    const LocalLine line{{0.0, jump, 0.0}, rigid};
    step_.traction = node_.solve(line, 0, duration_).traction;
    step_.jump = line.jump(step_.traction);
    const std::vector<double> now = node_.newHistory();
    step_.oldHistory = old_.data();
    step_.history = now.data();
    lost_ += step_.work() - law_.keptWork(step_);
    stored_ = law_.storedEnergy(step_);
    old_ = now;
    step_.oldJump = step_.jump;
    node_.accept();
    return step_.traction[1];
  }
  /// In equal pieces.
  double along(double from, double jump, int pieces) {
    double traction = 0.0;
    for (int i = 1; i <= pieces; ++i) traction = to(from + (jump - from) * i / pieces);
    return traction;
  }
  double lost() const { return lost_; }
  double stored() const { return stored_; }

 private:
  const InterfaceLaw& law_;
  Node node_;
  double duration_;
  std::vector<double> old_;
  PairStep step_;
  double lost_ = 0.0, stored_ = 0.0;
};

/// Built-in law with its defaults, numbers, and lists.
std::unique_ptr<InterfaceLaw> make(const std::string& type, const std::map<std::string, double>& values,
                                   const std::map<std::string, std::vector<double>>& lists = {}) {
  input::Parameters p("law");
  p.set("Type", type).set("Opens", false);
  for (const auto& [name, value] : values) p.set(name, value);
  for (const auto& [name, numbers] : lists) p.set(name, numbers);
  return builtInLaws().create(p);
}

// A cycle between +-A loses 4 tau (A - tau/k), as long as it slides; the spring keeps tau^2 / (2 k).
TEST(Jenkins, LosesTheAreaOfItsLoop) {
  const auto law = make("Jenkins", {{"Tangential Stiffness", 100.0}, {"Slip Limit", 2.0}});
  for (const int pieces : {1, 7}) {
    Path path(*law);
    EXPECT_NEAR(path.along(0.0, 0.015, pieces), 1.5, 1e-6);
    EXPECT_NEAR(path.lost(), 0.0, 1e-9);
    EXPECT_NEAR(path.along(0.015, 0.05, pieces), 2.0, 1e-6);
    const double before = path.lost();
    EXPECT_NEAR(path.along(0.05, -0.05, pieces), -2.0, 1e-6);
    path.along(-0.05, 0.05, pieces);
    EXPECT_NEAR(path.lost() - before, 4.0 * 2.0 * (0.05 - 0.02), 1e-6);
    EXPECT_NEAR(path.stored(), 0.5 * 4.0 / 100.0, 1e-6);
  }
}

// Beyond yield the slope is k h / (k + h). With kinematic hardening the elastic range keeps its size 2 tau; with
// isotropic hardening it grows by twice what has hardened.
TEST(TangentialPlasticity, Hardens) {
  const double k = 100.0, yield = 2.0, h = 25.0, far = 0.12;
  const double there = yield + k * h / (k + h) * (far - yield / k), slip = far - there / k;
  for (const char* kind : {"Kinematic Hardening", "Isotropic Hardening"}) {
    std::map<std::string, double> values{{"Tangential Stiffness", k},
                                         {"Yield Stress", yield},
                                         {"Kinematic Hardening", 0.0},
                                         {"Isotropic Hardening", 0.0}};
    values[kind] = h;
    const auto law = make("Tangential Plasticity", values);
    for (const int pieces : {1, 5}) {
      Path path(*law);
      EXPECT_NEAR(path.along(0.0, far, pieces), there, 1e-6);
      const bool isKinematic = std::string(kind)[0] == 'K';
      // It yields again where the elastic range ends.
      const double back = there - 2.0 * (isKinematic ? yield : there), jump = far - (there - back) / k;
      EXPECT_NEAR(path.along(far, jump, pieces), back, 1e-6);
      EXPECT_NEAR(path.along(jump, jump - 0.05, pieces), back - k * h / (k + h) * 0.05, 1e-6);
    }
    Path path(*law);
    path.along(0.0, far, 400);
    if (kind[0] == 'K') {
      EXPECT_NEAR(path.lost(), yield * slip, 1e-6);
      EXPECT_NEAR(path.stored(), 0.5 * there * there / k + 0.5 * h * slip * slip, 1e-6);
    } else {
      EXPECT_NEAR(path.lost(), yield * slip + 0.5 * h * slip * slip, 2e-3 * yield * slip);
    }
  }
}

// Masing's rule: the way back is the first way twice as large, upside down.
TEST(ParallelIwan, ObeysMasing) {
  const auto law = make("Parallel Iwan", {{"Residual Stiffness", 3.0}},
                        {{"Stiffnesses", {10.0, 20.0, 5.0}}, {"Slip Limits", {0.1, 0.5, 1.0}}});
  const auto backbone = [](double u) {
    return 3.0 * u + std::min(10.0 * u, 0.1) + std::min(20.0 * u, 0.5) + std::min(5.0 * u, 1.0);
  };
  const double far = 0.15;
  Path path(*law);
  EXPECT_NEAR(path.along(0.0, far, 3), backbone(far), 1e-6);
  for (const double u : {0.14, 0.1, 0.03, -0.05, -0.15}) {
    EXPECT_NEAR(path.to(u), backbone(far) - 2.0 * backbone(0.5 * (far - u)), 1e-6) << u;
  }
  // A loop loses what Jenkins elements lose by themselves.
  const double before = path.lost();
  path.along(-far, far, 4);
  path.along(far, -far, 4);
  const double expected = 4.0 * (0.1 * (far - 0.01) + 0.5 * (far - 0.025));
  EXPECT_NEAR(path.lost() - before, expected, 1e-6);
}

// With one element along any direction it is Jenkins' law.
TEST(ParallelIwan, OfOneElementIsJenkins) {
  const auto one =
      make("Parallel Iwan", {{"Residual Stiffness", 0.0}}, {{"Stiffnesses", {7.0}}, {"Slip Limits", {1.5}}});
  const auto jenkins = make("Jenkins", {{"Tangential Stiffness", 7.0}, {"Slip Limit", 1.5}});
  Random random(11);
  for (int i = 0; i < 50; ++i) {
    Node a(*one), b(*jenkins);
    for (int step = 0; step < 6; ++step) {
      const LocalLine line = randomLine(random);
      const base::Vector3 found = a.solve(line).traction, expected = b.solve(line).traction;
      EXPECT_LE(norm(found - expected), 1e-11 * (1.0 + norm(line.freeJump) / line.compliance));
      a.accept();
      b.accept();
    }
  }
}

// Segalman (2005): K_T at first, F_S in the end, and losses 4 R u^(3 + chi) / ((2 + chi) (3 + chi)) of small cycles.
TEST(FourParameterIwan, LosesLikeAPowerOfTheAmplitude) {
  const double strength = 4.0, stiffness = 50.0, chi = -0.5, beta = 0.2;
  const auto law = [&] {
    input::Parameters p("law");
    p.set("Type", std::string("Four-Parameter Iwan")).set("Opens", false).set("Elements", 100);
    p.set("Slip Limit", strength).set("Tangential Stiffness", stiffness).set("Exponent", chi).set("Ratio", beta);
    return builtInLaws().create(p);
  }();
  const double reach = strength * (1.0 + beta) / (stiffness * (beta + (chi + 1.0) / (chi + 2.0)));
  const double density = strength * (chi + 1.0) / (std::pow(reach, chi + 2.0) * (beta + (chi + 1.0) / (chi + 2.0)));
  EXPECT_NEAR(Path(*law).to(1e-9 * reach), 1e-9 * reach * stiffness, 1e-3 * 1e-9 * reach * stiffness);
  EXPECT_NEAR(Path(*law).to(1.01 * reach), strength, 1e-6);
  EXPECT_LT(Path(*law).to(0.99 * reach), strength);
  for (const double amplitude : {0.05 * reach, 0.2 * reach, 0.6 * reach}) {
    Path path(*law);
    path.to(amplitude);
    const double before = path.lost();
    path.to(-amplitude);
    path.to(amplitude);
    const double exact = 4.0 * density * std::pow(amplitude, chi + 3.0) / ((chi + 2.0) * (chi + 3.0));
    EXPECT_NEAR(path.lost() - before, exact, 0.02 * exact) << amplitude / reach;
  }
}

// Loaded for the first time: z = Z (1 - exp(-delta / Z)) for n = 1, Z tanh(delta / Z) for n = 2; to and fro it is the
// area that is lost. Unloaded with shape 1/2 it has its first stiffness.
TEST(BoucWen, FollowsItsClosedForms) {
  const double k = 50.0, limit = 2.0, ratio = 0.2, bound = limit / ((1.0 - ratio) * k), far = 2.0 * bound;
  for (const double n : {1.0, 2.0}) {
    const auto law = make("Bouc-Wen", {{"Tangential Stiffness", k},
                                       {"Slip Limit", limit},
                                       {"Residual Stiffness Ratio", ratio},
                                       {"Exponent", n},
                                       {"Unloading Shape", 0.5}});
    const double z = n == 1.0 ? bound * (1.0 - std::exp(-far / bound)) : bound * std::tanh(far / bound);
    const double exact = ratio * k * far + (1.0 - ratio) * k * z;
    const auto error = [&](int pieces) { return std::abs(Path(*law).along(0.0, far, pieces) - exact); };
    EXPECT_LT(error(1000), 1e-3 * exact);
    EXPECT_NEAR(error(500) / error(1000), 2.0, 0.05);
    Path path(*law);
    const double there = path.along(0.0, far, 1000);
    EXPECT_NEAR(path.to(0.9 * far), there - k * 0.1 * far, 1e-6);
    EXPECT_NEAR(path.along(0.9 * far, 20.0 * far, 400) - ratio * k * 20.0 * far, limit, 1e-6);
  }
}

// Two directions at once, on a way that turns: the equation of Park, Wen and Ang by Runge and Kutta.
TEST(BoucWen, FollowsItsEquationInTwoDirections) {
  const double k = 3.0, limit = 2.0, n = 1.7, shape = 0.8, bound = limit / k;
  const auto law = make("Bouc-Wen", {{"Tangential Stiffness", k},
                                     {"Slip Limit", limit},
                                     {"Residual Stiffness Ratio", 0.0},
                                     {"Exponent", n},
                                     {"Unloading Shape", shape}});
  using Plane = std::array<double, 2>;
  const auto way = [](double t) { return Plane{std::sin(3.0 * t), 1.5 * std::sin(2.0 * t)}; };
  const auto speed = [](double t) { return Plane{3.0 * std::cos(3.0 * t), 3.0 * std::cos(2.0 * t)}; };
  const auto rate = [&](double t, const Plane& z) {
    const Plane v = speed(t);
    const double along = v[0] * z[0] + v[1] * z[1], size = std::hypot(z[0], z[1]);
    const double fall =
        size > 0.0 ? std::pow(size, n - 2.0) / std::pow(bound, n) * (shape * std::abs(along) + (1.0 - shape) * along)
                   : 0.0;
    return Plane{v[0] - fall * z[0], v[1] - fall * z[1]};
  };
  Plane z{};
  constexpr int pieces = 40000;
  constexpr double end = 4.0, dt = end / pieces;
  for (int i = 0; i < pieces; ++i) {
    const auto moved = [&](const Plane& a, double by) { return Plane{z[0] + by * a[0], z[1] + by * a[1]}; };
    const Plane a = rate(i * dt, z), b = rate((i + 0.5) * dt, moved(a, 0.5 * dt));
    const Plane c = rate((i + 0.5) * dt, moved(b, 0.5 * dt)), d = rate((i + 1) * dt, moved(c, dt));
    for (std::size_t j = 0; j < 2; ++j) z[j] += dt / 6.0 * (a[j] + 2.0 * b[j] + 2.0 * c[j] + d[j]);
  }
  const auto error = [&](int steps) {
    Node node(*law);
    LocalState state;
    for (int i = 1; i <= steps; ++i) {
      const Plane u = way(end * i / steps);
      state = node.solve({{0.0, u[0], u[1]}, rigid}, 0, end / steps);
      node.accept();
    }
    return std::hypot(state.traction[1] - k * z[0], state.traction[2] - k * z[1]);
  };
  EXPECT_LT(error(4000), 2e-3 * limit);
  EXPECT_NEAR(error(2000) / error(4000), 2.0, 0.1);
}

// A held jump relaxes by 1 / (1 + dt k / eta) per load step, which is exp(-k t / eta) in the limit.
TEST(MaxwellGlue, Relaxes) {
  const double k = 40.0, eta = 8.0, jump = 0.1;
  const auto law = make("Maxwell Glue", {{"Normal Stiffness", 10.0},
                                         {"Normal Viscosity", 1.0},
                                         {"Tangential Stiffness", k},
                                         {"Tangential Viscosity", eta}});
  const double dt = 0.01;
  Path path(*law, dt);
  for (int step = 1; step <= 40; ++step) {
    EXPECT_NEAR(path.to(jump), k * jump * std::pow(1.0 + dt * k / eta, -step), 1e-6);
  }
  Path fine(*law, 0.4 / 4000.0);
  double traction = 0.0;
  for (int step = 1; step <= 4000; ++step) traction = fine.to(jump);
  EXPECT_NEAR(traction, k * jump * std::exp(-0.4 * k / eta), 2e-3 * k * jump);
  // What is not stored any more was lost, but for what the first load step takes at once.
  EXPECT_NEAR(fine.lost() + fine.stored(), 0.5 * k * jump * jump, 5e-3 * k * jump * jump);
}

// A held load creeps to t / k with the time eta / k.
TEST(KelvinGlue, Creeps) {
  const double k = 40.0, eta = 8.0, load = 2.0, soft = 1e4;
  const auto law = make("Kelvin Glue", {{"Normal Stiffness", 10.0},
                                        {"Normal Viscosity", 1.0},
                                        {"Tangential Stiffness", k},
                                        {"Tangential Viscosity", eta}});
  const double dt = 0.4 / 2000.0;
  Node node(*law);
  double jump = 0.0;
  for (int step = 1; step <= 2000; ++step) {
    const LocalLine line{{0.0, soft * load, 0.0}, soft};  // the traction is as good as given
    const double traction = node.solve(line, 0, dt).traction[1];
    EXPECT_NEAR(traction, load, 1e-5);
    jump = node.newHistory()[1];
    node.accept();
  }
  EXPECT_NEAR(jump, load / k * (1.0 - std::exp(-0.4 * k / eta)), 2e-3 * load / k);
}

}  // namespace
}  // namespace harmos::laws
