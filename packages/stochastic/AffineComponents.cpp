#include <harmos/stochastic/AffineComponents.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Error.hpp>

namespace harmos::stochastic {
namespace {

// Relative round-off of a probe.
constexpr double roundOff = 1e-12;

}  // namespace

std::array<laws::AffineComponent, 3> affineComponents(const laws::InterfaceLaw& law, int step, double compliance,
                                                      const std::string& interfaceName) {
  if (!law.isAffine()) {
    throw base::Error("interface \"" + interfaceName + "\": the law \"" + law.name() +
                          "\" is not affine, which Galerkin's and the direct spectral method need; choose the "
                          "pseudo-spectral local stage",
                      base::ExitCode::input);
  }
  return laws::affineComponents(law, step, compliance);
}

bool areSame(const std::vector<double>& stiffnesses) {
  const double first = stiffnesses[0];
  return std::all_of(stiffnesses.begin(), stiffnesses.end(),
                     [first](double k) { return k == first || std::abs(k - first) <= roundOff * std::abs(first); });
}

}  // namespace harmos::stochastic
