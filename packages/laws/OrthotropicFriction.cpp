#include <algorithm>
#include <array>
#include <cmath>

#include <harmos/base/Numerals.hpp>
#include <harmos/laws/LawFailure.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/ContactTraction.hpp>
#include <harmos/laws/detail/SlidingLaw.hpp>

namespace harmos::laws {
namespace {

constexpr int mostSteps = 100;
// Of a direction, along the surface: less is round-off of a normal.
constexpr double leastShare = 1e-6;

/// The point of the ellipse with the semi-axes a, b > 0 that is nearest to (x, y) outside: where x = t + lambda t/a^2.
///
/// The function of lambda >= 0, (a x / (a^2 + lambda))^2 + (b y / (b^2 + lambda))^2 - 1, falls and is convex, so that
/// Newton's method from the left of its root stays there and converges.
Tangential nearestOnEllipse(double a, double b, const Tangential& point) {
  const double scale = std::max(a, b);
  const double x = std::abs(point.t1) / scale, y = std::abs(point.t2) / scale;
  const double p = a / scale, q = b / scale;
  double lambda = std::max({0.0, p * x - p * p, q * y - q * q});
  for (int step = 0; step < mostSteps; ++step) {
    const double u = p * x / (p * p + lambda), v = q * y / (q * q + lambda);
    const double value = u * u + v * v - 1.0;
    const double slope = -2.0 * (u * u / (p * p + lambda) + v * v / (q * q + lambda));
    const double next = lambda - value / slope;
    if (!(value > 0.0) || next == lambda) break;
    lambda = next;
  }
  return {point.t1 * p * p / (p * p + lambda), point.t2 * q * q / (q * q + lambda)};
}

/// Unilateral contact with friction that differs along two axes of the surface: (t_1 / mu_1)^2 + (t_2 / mu_2)^2 <=
/// t_n^2, sliding along the normal of that ellipse.
///
/// Axis 1 is the projection of a given direction onto the surface at each point. History: SlipMemory.
/// Source: Michalowski, Mroz, Associated and non-associated sliding rules in contact friction problems (1978).
struct OrthotropicFriction : SlidingLaw {
  static constexpr const char* name = "Orthotropic Friction";

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Contact with friction that differs along two axes of the surface, as on rolled or ground sheets: an ellipse "
         "of tractions, sliding along its normal.")
        .source("Michalowski, Mroz (1978)");
    p.equation(
        "opening >= 0, t_n <= 0, their product 0; (t_1 / mu_1)^2 + (t_2 / mu_2)^2 <= t_n^2, sliding along its normal");
    p.number("Friction Coefficient 1").example("0.3").unit("-").required().above(0.0).doc("mu_1 along axis 1.");
    p.number("Friction Coefficient 2")
        .example("0.1")
        .unit("-")
        .required()
        .above(0.0)
        .doc("mu_2 along the axis across.");
    p.numbers("Axis")
        .example("{1, 0, 0}")
        .unit("-")
        .required()
        .doc("Direction in x, y, z, whose projection onto the surface is axis 1; not along a normal.");
    p.number("Gap").unit("length").defaultValue(0.0).varying().doc(
        "Opening of the undeformed surfaces beyond their geometric distance; negative is interference.");
  }

  explicit OrthotropicFriction(const input::Parameters& p)
      : friction{p.number("Friction Coefficient 1"), p.number("Friction Coefficient 2")}, gap(p.schedule("Gap")) {
    const std::vector<double>& direction = p.numbers("Axis");
    std::copy_n(direction.begin(), std::min<std::size_t>(3, direction.size()), axis.begin());
  }

  AdmissibleTractions admissibleTractions(int) const {
    return AdmissibleTractions::pressureAtMost(std::max(friction[0], friction[1]));
  }

  /// Along the shear up to the ellipse, or the smaller friction where there is no shear.
  double shearLimit(const NodeContext& at, const base::Vector3& traction) const {
    const double pressure = std::max(0.0, -traction[0]), shear = tangentialNorm(traction);
    if (shear == 0.0) return std::min(friction[0], friction[1]) * pressure;
    const Tangential along = axisOnSurface(at), t{traction[1], traction[2]};
    return pressure * shear /
           std::hypot(dot(along, t) / friction[0], (along.t1 * t.t2 - along.t2 * t.t1) / friction[1]);
  }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double opening = line.freeJump[0] + at.gap + gap[at.step];
    if (opening >= 0.0) {
      SlipMemory::keep(Tangential::of(line.freeJump), 0.0, old, now);
      return {{}, Status::open};
    }
    const double normal = contactTraction(opening, line.compliance);
    const Tangential oldSlip = SlipMemory::slip(old);
    const Tangential trial = (1.0 / line.compliance) * (Tangential::of(line.freeJump) - oldSlip);
    const double a = -friction[0] * normal, b = -friction[1] * normal;
    // Along the axes of friction.
    const Tangential along = axisOnSurface(at);
    const Tangential turned{dot(along, trial), along.t1 * trial.t2 - along.t2 * trial.t1};
    const double reach = std::hypot(turned.t1 / a, turned.t2 / b);
    Tangential traction = trial;
    if (!(reach < 1.0)) {
      const Tangential found = nearestOnEllipse(a, b, turned);
      traction = {along.t1 * found.t1 - along.t2 * found.t2, along.t2 * found.t1 + along.t1 * found.t2};
    }
    const Tangential moved = line.compliance * (trial - traction);
    SlipMemory::keep(oldSlip + moved, moved.norm(), old, now);
    return {{normal, traction.t1, traction.t2}, reach >= 1.0 - atTheLimit ? Status::slip : Status::stick};
  }

  /// Unit vector of axis 1. Throws LawFailure where the axis is a normal.
  Tangential axisOnSurface(const NodeContext& at) const {
    const Tangential projected{base::dot(at.frame()[1], axis), base::dot(at.frame()[2], axis)};
    const double length = projected.norm();
    if (length > leastShare * base::norm(axis)) return (1.0 / length) * projected;
    const base::Vector3 place = at.position();
    throw LawFailure("has its Axis along the normal of the surface at (" + base::toText(place[0]) + ", " +
                         base::toText(place[1]) + ", " + base::toText(place[2]) +
                         "), where it is no axis of friction; give one along the surface",
                     base::ExitCode::input);
  }

  std::array<double, 2> friction;
  input::Schedule gap;
  base::Vector3 axis{};
};

}  // namespace

HARMOS_INTERFACE_LAW(OrthotropicFriction)

}  // namespace harmos::laws
