#pragma once

#include <vector>

#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// The mean jump q [length] that a law over a whole face keeps since an earlier load step, as a bolt does that was
/// tightened by force (laws::CoupledLaw::keepsJumpSince()): what that step makes of q, later ones depend on.
struct KeptJump {
  int step;                   ///< from 0: at whose end it was found
  ResponseGradient gradient;  ///< of q with respect to the displacements of that step
  ResponseGradient force;     ///< of the resultant of the tractions along the jump, on the pairs of the face
};

/// What the laws of an assembly keep at a load step, from 0. Not collective: the same on all ranks.
std::vector<KeptJump> keptJumps(const assembly::Assembly& assembly, int step);

}  // namespace harmos::latin
