#pragma once

#include <array>
#include <optional>
#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/laws/InterfaceLaw.hpp>

/// What laws make of jumps that no traction changes: they are asked on lines without compliance, where all gives way
/// but what is rigid.
namespace harmos::scene {

/// The jump [length] at a load step, counted from 0, and an undeformed place [length], of a law that is affine at every
/// place: of those components in its frame that do not depend on the traction.
std::array<std::optional<double>, 3> fixedJump(const laws::InterfaceLaw& law, int step, const base::Vector3& place);

/// The jumps along the normal that a law allows nearest to `wanted`, one for each load step that ends at `times` [all
/// length]; of a law that sees jumps in the frame of the interface, at one pair of it.
///
/// A law with memory, or whose normal part depends on the tangential one, may forbid a jump now and allow it after
/// others. It is asked at the unloaded start, and again after it has been pressed and dragged by `reach` [length], the
/// size of the scene, in all load steps before; what it allows in one of the two counts as allowed, and so does
/// everything from the load step on at which it has no answer.
std::vector<double> nearestNormalJumps(const assembly::Interface& interface, int pair, const std::vector<double>& times,
                                       const std::vector<double>& wanted, double reach);

}  // namespace harmos::scene
