#include <harmos/laws/AffineComponent.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace harmos::laws {
namespace {

// A law that leaves less than this share of the line's own stiffness is rigid.
constexpr double rigid = 1e-12;
// The shortest compliance [length/stress] that is asked for, in any units.
constexpr double leastCompliance = 1e-60;

base::Vector3 tractionOf(const InterfaceLaw& law, int step, const LocalLine& line) {
  LocalState state;
  const double gap = 0.0;
  law.solve(step, {1, &line, &gap, nullptr, nullptr, &state});
  return state.traction;
}

/// On the line t = (k delta_free + c) / (1 + k H), or (delta_free - delta) / H.
AffineComponent probe(const InterfaceLaw& law, int step, double compliance, std::size_t component) {
  LocalLine line;
  line.compliance = compliance;
  const double atRest = tractionOf(law, step, line)[component];
  // Long enough that the difference keeps its digits beside a large offset.
  const double jump = compliance * std::max(1.0, std::abs(atRest));
  line.freeJump[component] = jump;
  const double slope = (tractionOf(law, step, line)[component] - atRest) / jump;
  const double rest = 1.0 - slope * compliance;
  if (std::abs(rest) <= rigid) return {std::numeric_limits<double>::infinity(), -compliance * atRest};
  return {slope / rest, atRest / rest};
}

}  // namespace

std::array<AffineComponent, 3> affineComponents(const InterfaceLaw& law, int step, double compliance) {
  std::array<AffineComponent, 3> result;
  for (std::size_t c = 0; c < 3; ++c) {
    result[c] = probe(law, step, compliance, c);
    const double stiffness = result[c].stiffness;
    // Digits of k are lost where k H is large.
    if (stiffness > 0.0 && std::isfinite(stiffness)) result[c] = probe(law, step, 1.0 / stiffness, c);
  }
  return result;
}

std::array<AffineComponent, 3> affineComponents(const InterfaceLaw& law, int step) {
  std::array<AffineComponent, 3> result = affineComponents(law, step, 1.0);
  for (std::size_t c = 0; c < 3; ++c) {
    for (double compliance = rigid; compliance > leastCompliance && std::isinf(result[c].stiffness);
         compliance *= rigid) {
      const AffineComponent closer = affineComponents(law, step, compliance)[c];
      if (std::isfinite(closer.stiffness)) result[c] = closer;
    }
  }
  return result;
}

}  // namespace harmos::laws
