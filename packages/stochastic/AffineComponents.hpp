#pragma once

#include <array>
#include <string>
#include <vector>

#include <harmos/laws/AffineComponent.hpp>

namespace harmos::stochastic {

/// laws::affineComponents() for those who need an affine law. Throws base::Error (input) naming the interface
/// when the law is not affine.
std::array<laws::AffineComponent, 3> affineComponents(const laws::InterfaceLaw& law, int step, double compliance,
                                                      const std::string& interfaceName);

/// Whether stiffnesses, at least one, do not differ but for the round-off of the probe, 1e-12 of the first.
bool areSame(const std::vector<double>& stiffnesses);

}  // namespace harmos::stochastic
