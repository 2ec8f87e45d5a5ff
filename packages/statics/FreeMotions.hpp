#pragma once

#include <harmos/statics/RigidAssembly.hpp>

namespace harmos::statics {

/// A direction along which a joint holds its sides together.
struct Hold {
  int joint = -1;             ///< position in RigidAssembly::joints; what its tractions may be does not matter
  base::Vector3 direction{};  ///< unit vector, global components
};

/// A basis of the rigid motions that neither a hold nor a coupling feels: every jump along a hold is 0, and so is the
/// work of every coupling.
///
/// Each motion is one vector per body; its largest displacement over the sizes of the bodies is 1. Motions of few
/// bodies and along few axes come out as such. Not collective.
std::vector<std::vector<Motion>> findFreeMotions(const RigidAssembly& assembly, const std::vector<Hold>& holds);

}  // namespace harmos::statics
