#pragma once

#include <functional>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/statics/RigidAssembly.hpp>

/// Faces of bolts that are being tightened (laws::CoupledLaw::tighteningForce), in rigid statics: the force is a load
/// of the faces that it acts on, and the joint bears everything else.
namespace harmos::latin {

/// Whether the law of an interface brings about its force at a load step, counted from 0.
bool isTightened(const assembly::Interface& interface, int step);

/// Adds the forces [force, global components] of a load step to both sides of all such faces: `add` takes a body, a
/// place and the force. Every rank adds all of them.
void addTighteningForces(const assembly::Assembly& assembly, int step,
                         const std::function<void(std::size_t, const base::Vector3&, const base::Vector3&)>& add);

/// Makes the joints of such faces slide along their force: of the tractions that they may bear, those along it are left
/// out, and two across it, before and behind the face, bear the moments. Couplings of faces that lie apart leave it out
/// by themselves. Joint::interface must be the position in the assembly.
void slideAlongForces(const assembly::Assembly& assembly, int step, statics::RigidAssembly& rigid);

}  // namespace harmos::latin
