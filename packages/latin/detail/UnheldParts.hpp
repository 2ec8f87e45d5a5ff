#pragma once

#include <string>
#include <vector>

#include <harmos/latin/Iterate.hpp>

namespace harmos::latin {

/// One sentence for every set of parts that nothing holds in the state of contact that was found: parts, load steps and
/// the rigid motions that no interface resists. Where they are is not determined, though their forces are. Collective.
///
/// Contacts that are open resist nothing, those that slide neither their normal nor, with friction, the direction
/// across their slip excepted; those that stick and joints that are bonded resist all that their laws can bear. Load
/// steps without any force between parts are left out. Of all load steps, which must be selected.
std::vector<std::string> describeUnheldParts(const Iterate& state);

}  // namespace harmos::latin
