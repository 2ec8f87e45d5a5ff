#include <harmos/laws/detail/SlipElements.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace harmos::laws {
namespace {

// Newton's steps come to rest long before.
constexpr int mostSteps = 200;
constexpr double leastStep = 1e-10;
// Share of the decrease that the slope promises.
constexpr double sufficient = 1e-4;
// Of an energy; and of a jump: Newton's step after one as short as that is round-off.
constexpr double roundOff = 4e-16;
constexpr double converged = 1e-13;

}  // namespace

/// Traction, energy and tangent [stress/length] of the elements.
struct SlipElements::Gradient {
  Tangential traction;
  double energy = 0.0;
  double k11 = 0.0, k12 = 0.0, k22 = 0.0;
  bool slides = false;
};

SlipElements::SlipElements(const NormalSpring& normal, std::vector<double> stiffnesses, std::vector<double> strengths,
                           double spring)
    : normal_(normal), stiffnesses_(std::move(stiffnesses)), strengths_(std::move(strengths)), spring_(spring) {}

SlipElements::Gradient SlipElements::gradient(const Tangential& jump, const double* old) const {
  Gradient sum;
  sum.traction = spring_ * jump;
  sum.energy = 0.5 * spring_ * dot(jump, jump);
  sum.k11 = sum.k22 = spring_;
  for (std::size_t i = 0; i < stiffnesses_.size(); ++i) {
    const Tangential stretch = jump - Tangential{old[2 * i], old[2 * i + 1]};
    const double length = stretch.norm(), k = stiffnesses_[i], strength = strengths_[i];
    // What is not a number slides, so that it is seen.
    if (k * length <= strength) {
      sum.traction = sum.traction + k * stretch;
      sum.energy += 0.5 * k * length * length;
      sum.k11 += k;
      sum.k22 += k;
      continue;
    }
    const Tangential along = (1.0 / length) * stretch;
    const double across = strength / length;
    sum.traction = sum.traction + strength * along;
    sum.energy += strength * (length - 0.5 * strength / k);
    sum.k11 += across * along.t2 * along.t2;
    sum.k12 -= across * along.t1 * along.t2;
    sum.k22 += across * along.t1 * along.t1;
    sum.slides = true;
  }
  return sum;
}

LocalState SlipElements::solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
  const Tangential free = Tangential::of(line.freeJump);
  const double compliance = line.compliance;
  const auto value = [&](const Tangential& there, const Gradient& gradient) {
    return 0.5 * dot(there - free, there - free) + compliance * gradient.energy;
  };
  // The jump lies within the hull of the points at which each energy is least: no step is longer than twice its size.
  double reach = spring_ > 0.0 ? free.norm() : 0.0;
  for (std::size_t i = 0; i < stiffnesses_.size(); ++i) {
    reach = std::max(reach, (free - Tangential{old[2 * i], old[2 * i + 1]}).norm());
  }
  // Multiplied by H: residual r = delta - delta_free + H t.
  Tangential jump{old[0], old[1]};
  Gradient here = gradient(jump, old);
  for (int step = 0; step < mostSteps; ++step) {
    const Tangential residual = jump - free + compliance * here.traction;
    const double size = residual.norm();
    if (std::isnan(size)) {
      std::copy_n(old, historySize(), now);
      return {{size, size, size}, Status::slip};
    }
    if (size == 0.0) break;
    const double a = 1.0 + compliance * here.k11, b = compliance * here.k12, c = 1.0 + compliance * here.k22;
    const double determinant = a * c - b * b;
    Tangential direction{-(c * residual.t1 - b * residual.t2) / determinant,
                         -(a * residual.t2 - b * residual.t1) / determinant};
    const double length = direction.norm();
    if (length > 2.0 * reach) direction = (2.0 * reach / length) * direction;
    const double slope = dot(residual, direction), from = value(jump, here);
    double share = 1.0;
    Tangential next = jump + direction;
    Gradient there = gradient(next, old);
    while (share > leastStep && value(next, there) > from + sufficient * share * slope + roundOff * from) {
      share *= 0.5;
      next = jump + share * direction;
      there = gradient(next, old);
    }
    if (share <= leastStep) break;
    jump = next;
    here = there;
    if (length <= converged * jump.norm()) break;
  }
  for (std::size_t i = 0; i < stiffnesses_.size(); ++i) {
    const Tangential stretch = jump - Tangential{old[2 * i], old[2 * i + 1]};
    const double length = stretch.norm(), limit = strengths_[i] / stiffnesses_[i];
    const Tangential elastic = length > limit ? (limit / length) * stretch : stretch;
    now[2 * i] = length > limit ? jump.t1 - elastic.t1 : old[2 * i];
    now[2 * i + 1] = length > limit ? jump.t2 - elastic.t2 : old[2 * i + 1];
  }
  // As it follows from the line, so that it meets it to the last digit where the law is stiff.
  const Tangential onLine = (1.0 / compliance) * (free - jump);
  const bool isStiff = compliance * (here.k11 + here.k22) > 2.0;
  const Tangential t = isStiff ? onLine : here.traction;
  return {{normal_.traction(line, at.gap), t.t1, t.t2}, here.slides ? Status::slip : Status::stick};
}

double SlipElements::keptWork(const PairStep& step) const {
  double lost = 0.0;
  for (std::size_t i = 0; i < stiffnesses_.size(); ++i) {
    const Tangential slip{step.history[2 * i], step.history[2 * i + 1]};
    const Tangential old{step.oldHistory[2 * i], step.oldHistory[2 * i + 1]};
    lost += strengths_[i] * (slip - old).norm();
  }
  return step.work() - lost;
}

double SlipElements::storedEnergy(const PairStep& step) const {
  const Tangential jump = Tangential::of(step.jump);
  double energy = normal_.energy(step.traction[0]) + 0.5 * spring_ * dot(jump, jump);
  for (std::size_t i = 0; i < stiffnesses_.size(); ++i) {
    const Tangential stretch = jump - Tangential{step.history[2 * i], step.history[2 * i + 1]};
    energy += 0.5 * stiffnesses_[i] * dot(stretch, stretch);
  }
  return energy;
}

std::vector<OutputField> SlipElements::outputs() {
  return {{"sliding_share", "-", "of the strength of all elements, that of those that have slid in the load step"}};
}

void SlipElements::output(const PairStep& step, double* values) const {
  double sliding = 0.0, all = 0.0;
  for (std::size_t i = 0; i < stiffnesses_.size(); ++i) {
    const bool moved =
        step.history[2 * i] != step.oldHistory[2 * i] || step.history[2 * i + 1] != step.oldHistory[2 * i + 1];
    if (moved) sliding += strengths_[i];
    all += strengths_[i];
  }
  values[0] = all > 0.0 ? sliding / all : 0.0;
}

}  // namespace harmos::laws
