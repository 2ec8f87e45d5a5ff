#pragma once

#include <vector>

#include <harmos/latin/PairFields.hpp>

namespace harmos::latin {

/// Work per area [stress length] that is lost at the pairs of an interface up to each load step, steps x pairs as in
/// PairFields::at(); zero where the law does not dissipate. Not collective.
///
/// In every load step t.(delta - delta_old) - keptWork(), see laws::InterfaceLaw; normal and tangential. The numbers
/// that a law remembers are no fields: it is asked again along the load steps, on lines through its jumps and
/// tractions.
std::vector<double> lostWork(const assembly::Interface& interface, const PairFields& fields);

}  // namespace harmos::latin
