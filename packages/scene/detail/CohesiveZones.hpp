#pragma once

#include <string>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/scene/Bodies.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// What to tell the user of interfaces with fracture energies: a sentence on each whose pairs lie further apart than
/// half of the cohesive zone, the length E G / t^2 over which a crack sends its tractions ahead, the least of both
/// modes; E: the smallest normal stiffness of both parts [stress], G: the fracture energy, t: the strength. A coarser
/// mesh meets a row of small snaps instead of a crack that runs. Nothing is said of axisymmetry. `assembly` needs its
/// interfaces only.
/// Source of the length: Hillerborg, Modeer, Petersson (1976), doi:10.1016/0008-8846(76)90007-7.
std::vector<std::string> coarseCohesiveZones(const Scene& scene, const assembly::Assembly& assembly,
                                             const Bodies& bodies, const Model& model);

}  // namespace harmos::scene
