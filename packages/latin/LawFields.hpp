#pragma once

#include <string>
#include <vector>

#include <harmos/latin/PairFields.hpp>

namespace harmos::latin {

/// What the law of an interface says of its pairs beyond tractions, jumps and status; lists as in PairFields::at().
struct LawFields {
  /// Work per area [stress length] that is lost up to each load step: in every load step t.(delta - delta_old) -
  /// keptWork(), see laws::InterfaceLaw; normal and tangential. 0 where the law does not dissipate.
  std::vector<double> lost;
  /// Energy of the springs of the law [stress length].
  std::vector<double> stored;
  /// Of each of the law's own outputs() the numbers of all load steps and pairs.
  std::vector<std::vector<double>> outputs;
};

/// The numbers that a law remembers are no fields: it is asked again along the load steps, on lines through its jumps
/// and tractions. Not collective. `fields` are those of the interface.
LawFields lawFields(const assembly::Interface& interface, const PairFields& fields);

}  // namespace harmos::latin
