#pragma once

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {

/// The frame of an interface node from its normal (any length; zero: the x axis). t1 is the direction, in the tangent
/// plane, of the axis that is least normal to the interface, the first of x, y, z among equals; in 2-D t1 = t2 x n.
base::Frame frameFromNormal(const base::Vector3& normal, int dimension);

}  // namespace harmos::mesh
