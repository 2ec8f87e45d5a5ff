#pragma once

#include <string>

#include <harmos/statics/RigidAssembly.hpp>

namespace harmos::statics {

/// A motion in words, such as "along (1, 0, 0)" or "turning about (0, 0, 1) through (2, 0, 0)", in three digits.
/// `motion` is not 0. A rotation comes with a place on its axis; one with a translation along the axis is told as both.
std::string describe(const RigidBody& body, const Motion& motion);

/// "(1, 0.5, 0)", in four digits; components below 1e-6 of the largest one are 0.
std::string describe(const base::Vector3& vector);

}  // namespace harmos::statics
