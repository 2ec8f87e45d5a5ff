#pragma once

#include <functional>
#include <string>
#include <vector>

#include <harmos/input/ErrorList.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::study {

/// What is asked of a scene beyond its input; throws base::Error (input) where it is refused.
using Demand = std::function<void(const scene::Scene&)>;

/// Reports to `errors` distributions whose tails the scene does not admit where a quadrature needs them. The study has
/// random parameters; of a sample nothing is refused.
///
/// A stiffness kbar (1 + d xi) with a normal germ is negative with some probability. An expansion of order p is
/// computed from Gauss points, the outermost of which is x_max: for d >= 1/x_max the stiffness is negative there, and
/// the Galerkin system is not positive definite. Source: theory of Gauss-Hermite quadrature; x_max = 1.73, 2.33, 2.86
/// for 3, 4, 5 points.
///
/// kbar: its mean [stress/length], d: its coefficient of variation [-], xi and x_max: germs [-]. Of an order that is
/// raised until a tolerance is met, only order 2 is certain to be needed. `demand` is asked about every scene besides.
void checkTails(const Study& study, const laws::LawRegistry& laws, const Demand& demand, input::ErrorList& errors);

/// The same for an expansion of order `order`.
void checkTails(const Study& study, const laws::LawRegistry& laws, int order, const Demand& demand,
                input::ErrorList& errors);

/// One sentence about every random parameter: its moments, P(parameter <= 0), and a warning when a Gauss point leaves
/// less than a fifth of the mean of a normal one. The study has random parameters.
std::vector<std::string> describeTails(const Study& study);

/// One sentence per sweep of a coefficient of variation, with a warning from where on the tail rules.
std::vector<std::string> describeSweeps(const Study& study);

}  // namespace harmos::study
