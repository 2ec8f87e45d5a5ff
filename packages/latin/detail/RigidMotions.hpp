#pragma once

#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Matrix.hpp>

namespace harmos::latin {

/// k h x of one side of an interface: k [stress/length] per pair, h [area] its mass, x [length] with `dimension` rows a
/// pair and any number of columns.
base::Matrix weighted(const assembly::Interface& interface, int dimension, const std::vector<double>& k,
                      const base::Matrix& x);

/// Columns P [length] that span the rigid motions of `pairs` that an interface can feel, with P^T k h P = 1: 3 in the
/// plane, 6 in space, fewer where the points lie on a line or are one; 0 at its other pairs. k [stress/length] is given
/// for all of them. With a consistent mass h, `pairs` must be all.
base::Matrix rigidMotions(const assembly::Interface& interface, int dimension, const std::vector<double>& k,
                          const std::vector<int>& pairs);

}  // namespace harmos::latin
