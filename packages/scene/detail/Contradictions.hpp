#pragma once

#include <harmos/input/ErrorList.hpp>
#include <harmos/scene/Scene.hpp>
#include <harmos/scene/detail/LawPlaces.hpp>

namespace harmos::scene {

/// Reports to `errors` what no displacement or no traction can obey:
/// * nodes whose displacement along one direction boundaries hold at different values, at any load step; nodes that
///   Perfect interfaces join count as one,
/// * pairs of an interface, or of a boundary with the ground, whose law forbids the jump that boundaries hold,
/// * tractions that everywhere act along a direction that another boundary holds on the same faces,
/// * faces with two laws that are not affine, or with such a law and one that holds its normal: what each of them
///   carries is not determined.
/// Affine laws are asked at all load steps, whatever they are called.
void checkContradictions(const Scene& scene, const LawPlaces& places, input::ErrorList& errors);

}  // namespace harmos::scene
