#include <harmos/stochastic/AffineComponents.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <harmos/base/Error.hpp>

namespace harmos::stochastic {
namespace {

// A law that leaves less than this share of the line's own stiffness is rigid.
constexpr double rigid = 1e-12;
// Relative round-off of a probe.
constexpr double roundOff = 1e-12;

base::Vector3 tractionOf(const laws::InterfaceLaw& law, int step, const laws::LocalLine& line) {
  laws::LocalState state;
  const double gap = 0.0;
  law.solve(step, {1, &line, &gap, nullptr, nullptr, &state});
  return state.traction;
}

}  // namespace

std::array<AffineComponent, 3> affineComponents(const laws::InterfaceLaw& law, int step, double compliance,
                                                const std::string& interfaceName) {
  if (!law.isAffine()) {
    throw base::Error("interface \"" + interfaceName + "\": the law \"" + law.name() +
                          "\" is not affine, which Galerkin's and the direct spectral method need; choose the "
                          "pseudo-spectral local stage",
                      base::ExitCode::input);
  }
  std::array<AffineComponent, 3> result;
  laws::LocalLine line;
  line.compliance = compliance;
  const base::Vector3 atRest = tractionOf(law, step, line);
  for (std::size_t c = 0; c < 3; ++c) {
    line.freeJump = {};
    line.freeJump[c] = 1.0;
    // On the line t = (k delta_free + c) / (1 + k H), or (delta_free - delta) / H.
    const double slope = tractionOf(law, step, line)[c] - atRest[c];
    const double rest = 1.0 - slope * compliance;
    if (std::abs(rest) <= rigid) {
      result[c] = {std::numeric_limits<double>::infinity(), -compliance * atRest[c]};
    } else {
      result[c] = {slope / rest, atRest[c] / rest};
    }
  }
  return result;
}

bool areSame(const std::vector<double>& stiffnesses) {
  const double first = stiffnesses[0];
  return std::all_of(stiffnesses.begin(), stiffnesses.end(),
                     [first](double k) { return k == first || std::abs(k - first) <= roundOff * std::abs(first); });
}

}  // namespace harmos::stochastic
