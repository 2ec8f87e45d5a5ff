#include <harmos/scene/detail/AskedJumps.hpp>

#include <cmath>

#include <harmos/base/Error.hpp>

namespace harmos::scene {
namespace {

// On a line of this compliance every spring gives way, and nothing else.
constexpr double tiny = 1e-30;

/// Asks the law of an interface at one of its pairs.
class PairQuestion {
 public:
  PairQuestion(const assembly::Interface& interface, int pair, const std::vector<double>& times)
      : interface_(interface), pair_(pair), times_(times) {}

  /// The normal jump that is met from a free one, with a history, which is replaced by the one at the end of the load
  /// step.
  double meet(int step, const base::Vector3& freeJump, std::vector<double>& history) const {
    const laws::LocalLine line{freeJump, tiny};
    laws::LocalState state;
    std::vector<double> now(history.size());
    laws::NodeArrays nodes = interface_.nodes(times_, step);
    nodes.count = 1;
    nodes.line = &line;
    nodes.gap += pair_;
    nodes.oldHistory = history.data();
    nodes.newHistory = now.data();
    nodes.state = &state;
    nodes.position += pair_;
    nodes.frame += pair_;
    nodes.area += pair_;
    nodes.number = &pair_;
    interface_.solve(step, nodes);
    history.swap(now);
    return line.jump(state.traction)[0];
  }

 private:
  const assembly::Interface& interface_;
  int pair_;
  const std::vector<double>& times_;
};

}  // namespace

std::array<std::optional<double>, 3> fixedJump(const laws::InterfaceLaw& law, int step, const base::Vector3& place) {
  const double gap = 0.0;
  std::array<base::Vector3, 2> jumps;
  for (const double free : {0.0, 1.0}) {
    const laws::LocalLine line{{free, free, free}, tiny};
    laws::LocalState state;
    law.solve(step, {1, &line, &gap, nullptr, nullptr, &state, &place});
    jumps[free > 0.0 ? 1 : 0] = line.jump(state.traction);
  }
  std::array<std::optional<double>, 3> fixed;
  for (std::size_t c = 0; c < 3; ++c) {
    if (std::abs(jumps[1][c] - jumps[0][c]) < 0.5) fixed[c] = jumps[0][c];
  }
  return fixed;
}

std::vector<double> nearestNormalJumps(const assembly::Interface& interface, int pair, const std::vector<double>& times,
                                       const std::vector<double>& wanted, double reach) {
  const PairQuestion question(interface, pair, times);
  const auto numbers = static_cast<std::size_t>(interface.law->historySize());
  std::vector<double> nearest = wanted, used(numbers, 0.0);
  try {
    for (std::size_t t = 0; t < wanted.size(); ++t) {
      const int step = static_cast<int>(t);
      std::vector<double> unloaded(numbers, 0.0), asItIs = used;
      const double first = question.meet(step, {wanted[t], 0.0, 0.0}, unloaded);
      const double later = question.meet(step, {wanted[t], reach, 0.0}, asItIs);
      const double met = std::abs(first - wanted[t]) < std::abs(later - wanted[t]) ? first : later;
      if (!std::isfinite(first) || !std::isfinite(later)) break;
      nearest[t] = met;
      // There and back, so that it slides in every load step.
      question.meet(step, {wanted[t] - reach, t % 2 == 0 ? reach : -reach, 0.0}, used);
    }
  } catch (const base::Error&) {
    // It says nothing of these jumps.
  }
  return nearest;
}

}  // namespace harmos::scene
