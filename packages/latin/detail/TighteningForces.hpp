#pragma once

#include <functional>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/statics/RigidAssembly.hpp>

/// Faces on which a law brings about a force along the normal, whatever moves (laws::CoupledLaw::normalForce), in rigid
/// statics: the force is a load of both sides, and the joint bears everything else.
namespace harmos::latin {

/// Whether the law of an interface does so at a load step, counted from 0.
bool bringsNormalForce(const assembly::Interface& interface, int step);

/// Adds the forces [force, global components] of a load step to both sides of all such faces: `add` takes a body, a
/// place and the force. Every rank adds all of them.
void addNormalForces(const assembly::Assembly& assembly, int step,
                     const std::function<void(std::size_t, const base::Vector3&, const base::Vector3&)>& add);

/// Makes the joints of such faces slide along their normals: of the tractions that they may bear, those along the
/// normal are left out, and two tangential ones, before and behind the face, bear the moments. Joint::interface must be
/// the position in the assembly.
void slideAlongNormals(const assembly::Assembly& assembly, int step, statics::RigidAssembly& rigid);

}  // namespace harmos::latin
