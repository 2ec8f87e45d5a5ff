#pragma once

#include <string>
#include <vector>

#include <harmos/input/ErrorList.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::study {

/// Refuses distributions whose tails the scene does not admit where a quadrature needs them.
///
/// A stiffness kbar (1 + d xi) with a normal germ is negative with some probability. An expansion of order p is
/// computed from Gauss points, the outermost of which is x_max: for d >= 1/x_max the stiffness is negative there, and
/// the Galerkin system is not positive definite. Source: theory of Gauss-Hermite quadrature; x_max = 1.73, 2.33, 2.86
/// for 3, 4, 5 points.
///
/// Of an order that is raised until a tolerance is met, only order 2 is certain to be needed.
void checkTails(const Study& study, const laws::LawRegistry& laws, input::ErrorList& errors);

/// The same for an expansion of another order.
void checkTails(const Study& study, const laws::LawRegistry& laws, int order, input::ErrorList& errors);

/// One sentence about every random parameter: its moments, P(parameter <= 0), and a warning when a Gauss point leaves
/// less than a fifth of the mean.
std::vector<std::string> describeTails(const Study& study);

/// One sentence per coefficient of variation that is swept, with a warning from where on the tail rules.
std::vector<std::string> describeSweeps(const Study& study);

}  // namespace harmos::study
