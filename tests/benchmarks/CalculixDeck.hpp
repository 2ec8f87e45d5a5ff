#pragma once

#include <iosfwd>

#include <harmos/scene/Problem.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::benchmarks {

/// How CalculiX is to enforce contact: pressure = penalty * overclosure, sticking traction = stick * slip, both
/// [stress/length].
struct ContactPenalty {
  double penalty;
  double stick;
};

/// Writes a scene as an input deck of CalculiX: the same nodes, elements, steps and increments.
///
/// Contact pairs are surface to surface; a preload jump g becomes, node pair by node pair, u2 - u1 + g n = 0 with a
/// reference node that carries g as its first displacement. Loads grow linearly within a step. Every mean displacement
/// that the scene asks for stands in comments "** MEAN name x y z" and "** WEIGHT node weight", and its nodes are
/// printed at every increment, as are the reaction forces of the reference nodes. Hexahedra of second degree become
/// C3D20R. Limits, thrown as base::Error naming the entry: hex8, hex20, tet4 and tet10, isotropic materials, uncut
/// parts, Coulomb Friction and Preload Jump between side sets, Prescribed Displacement, and Prescribed Traction normal
/// to its faces.
void writeCalculixDeck(std::ostream& out, const scene::Scene& scene, const scene::Problem& problem,
                       const ContactPenalty& contact);

}  // namespace harmos::benchmarks
