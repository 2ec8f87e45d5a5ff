#pragma once

#include <array>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/assembly/Assembly.hpp>

namespace harmos::latin {

/// Which rigid motions of a body (translations, then rotations about any place; in the plane x, y and the turn) its own
/// stiffness resists. Where it resists both translations across an axis of the coordinates, the rotation is that about
/// this axis. None of a body of finite elements, but with axisymmetry; a host may have put springs to the ground into
/// its matrix.
using ResistedMotions = std::array<bool, 6>;

/// Of every body of the assembly. Collective: the owner of a body knows its matrix.
std::vector<ResistedMotions> resistedMotions(const assembly::Assembly& assembly, const Teuchos::Comm<int>& comm);

/// The same of assemblies whose nodes lie in one plane, as those of axisymmetry do; of others nothing is looked for.
/// Numbers as in space: the turn in the plane is the last. Of congruent bodies nothing is told. Collective likewise.
std::vector<ResistedMotions> resistedInPlane(const assembly::Assembly& assembly, const Teuchos::Comm<int>& comm);

/// A centre about which motions of a body are told apart as they are resisted: the one given, moved onto the axis of
/// the coordinates where both translations across it are resisted, but not the turn about it.
base::Vector3 centreOfMotions(const ResistedMotions& resisted, base::Vector3 centre);

}  // namespace harmos::latin
