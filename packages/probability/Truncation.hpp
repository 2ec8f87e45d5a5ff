#pragma once

#include <harmos/probability/Expansion.hpp>

namespace harmos::probability {

/// Root mean square distance of a random number from its expansion, estimated from the coefficients alone, in its unit.
/// Not a number for an expansion of order 0.

/// Where it has kinks, as contact and friction make them: the energy of the degree n decays as n^-5/2, so that all
/// degrees from the second one tell how large the kink is, and single ones that vanish by chance do not matter. Source:
/// the coefficients of max(0, xi - g) in Hermite polynomials are He_{n-2}(g) phi(g) / sqrt(n!).
double kinkedResidual(const Expansion& expansion);

/// Where it is smooth: the degrees go on to decay geometrically as the last two of the expansion do.
double smoothResidual(const Expansion& expansion);

}  // namespace harmos::probability
