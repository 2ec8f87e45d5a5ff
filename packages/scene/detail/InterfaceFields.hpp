#pragma once

#include <vector>

#include <harmos/latin/LawFields.hpp>
#include <harmos/latin/PairFields.hpp>
#include <harmos/latin/Safety.hpp>

namespace harmos::scene {

/// What the interfaces of a state do at all load steps, complete on every rank; each in the order of the assembly.
struct InterfaceFields {
  /// Collective. All load steps must be selected.
  explicit InterfaceFields(const latin::Iterate& state);

  std::vector<latin::PairFields> fields;  ///< tractions, jumps, status
  std::vector<latin::LawFields> law;      ///< latin::lawFields()
  std::vector<latin::Safety> safety;      ///< latin::safety()
};

}  // namespace harmos::scene
