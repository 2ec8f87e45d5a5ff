#pragma once

#include <harmos/assembly/Interface.hpp>
#include <harmos/scene/Bodies.hpp>

namespace harmos::scene {

/// Distance [length] of neighbouring points of an interface where it is largest, from the areas that they stand for:
/// the width of an element. 0 without points; those on the axis of axisymmetry do not count.
double largestSpacing(const assembly::Interface& interface, int dimension, const Model& model);

}  // namespace harmos::scene
