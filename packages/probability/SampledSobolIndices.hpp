#pragma once

#include <functional>
#include <vector>

#include <harmos/probability/Expansion.hpp>

namespace harmos::probability {

/// Values of some responses, [response][point], each in its unit, at points of germs, [point][germ].
using Responses = std::function<std::vector<std::vector<double>>(const std::vector<std::vector<double>>& points)>;

/// Sobol' indices of single germs, [response][germ], of functions that are cheap to evaluate.
///
/// `a` and `b`: independent samples of equal size, [point][germ], not empty. Besides them, points of `a` in which one
/// germ is taken from `b` are evaluated. NaN at zero variance. Throws base::Error when a response is not finite.
/// Source: Saltelli et al., Comput. Phys. Commun. 181 (2010), doi:10.1016/j.cpc.2009.09.018, table 2 (b) and (f).
std::vector<std::vector<SobolIndex>> sobolIndices(const Responses& evaluate, const std::vector<std::vector<double>>& a,
                                                  const std::vector<std::vector<double>>& b);

}  // namespace harmos::probability
