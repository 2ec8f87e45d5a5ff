#pragma once

#include <optional>
#include <vector>

#include <harmos/design/Surrogate.hpp>

namespace harmos::design {

/// A surrogate through those `values` that are known (finite), of at most 2000 of them, evenly chosen. `accuracy`:
/// relative to the largest value. `points` [point][parameter], one for each value. Nothing when fewer than 3 are known,
/// or a parameter has only one value among them. Throws what Surrogate throws.
std::optional<Surrogate> fitSurrogate(const std::vector<std::vector<double>>& points, const std::vector<double>& values,
                                      double accuracy);

}  // namespace harmos::design
