#pragma once

#include <optional>
#include <vector>

#include <harmos/files/ResultFiles.hpp>
#include <harmos/files/SolutionRecord.hpp>
#include <harmos/latin/Iterate.hpp>
#include <harmos/scene/FieldFile.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/scene/Scene.hpp>
#include <harmos/scene/detail/InterfaceFields.hpp>

namespace harmos::scene {

/// Writes the files of parts and of interfaces, unloaded state included; collective, rank 0 writes.
///
/// Parts: disp_x.. [length], stress_xx.. and von_mises [stress], element means; if they are asked for, at the nodes
/// nodal_stress_xx.., nodal_von_mises, principal_1 to principal_3 [stress] of every part by itself. Interfaces:
/// disp_x.. of side 1, contact_pressure = -t.n, traction_x.. on side 1 [stress], contact_status, opening = jump.n plus
/// initial gap [length], slip_x.. and slip_magnitude (tangential jump, side 2 minus side 1 [length]), dissipation since
/// the start [energy/area], safety_slip and safety_gaping [-], area. Jumps are 0 where they have no meaning: on
/// boundaries that no contact law governs. Behind them the outputs() of laws, 0 where the law has none of this name.
/// `state` must hold the fields of the last apply(); files appear only when complete. Of load steps only the first
/// `solvedSteps` are written. Returns, on rank 0, the largest von Mises stress of the last of them, if there is one.
std::optional<files::StressPeak> writeFields(const Scene& scene, const Problem& problem, const latin::Iterate& state,
                                             const InterfaceFields& fields, const std::vector<GlobalVariable>& globals,
                                             int solvedSteps, const files::ResultFiles& files,
                                             const Teuchos::Comm<int>& comm);

}  // namespace harmos::scene
