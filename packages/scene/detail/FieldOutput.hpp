#pragma once

#include <string>
#include <vector>

#include <harmos/files/ResultFiles.hpp>
#include <harmos/latin/Iterate.hpp>
#include <harmos/scene/FieldFile.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// Writes the files of parts and of interfaces, unloaded state included; collective, rank 0 writes.
///
/// Parts: disp_x.. [length], stress_xx.. and von_mises [stress], element means. Interfaces: disp_x.. of side 1,
/// contact_pressure = -t.n,
/// traction_x.. on side 1 [stress], contact_status, opening = jump.n plus initial gap [length], slip_x.. and
/// slip_magnitude (tangential jump, side 2 minus side 1 [length]), dissipation since the start [energy/area]. Jumps are
/// 0 where they have no meaning: on boundaries that no contact law governs. `state` must hold the fields of the last
/// apply(); files appear only when complete. Of load steps only the first
/// `solvedSteps` are written.
void writeFields(const Scene& scene, const Problem& problem, const latin::Iterate& state,
                 const std::vector<GlobalVariable>& globals, int solvedSteps, const files::ResultFiles& files,
                 const Teuchos::Comm<int>& comm);

}  // namespace harmos::scene
