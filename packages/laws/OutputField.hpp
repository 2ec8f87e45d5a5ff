#pragma once

#include <string>

namespace harmos::laws {

/// A number per pair and load step that a law adds to the results, such as a plastic slip or a damage.
struct OutputField {
  std::string name;  ///< in files: small letters, digits and underscores, at most 32
  std::string unit;  ///< such as "length" or "-"
  std::string doc;   ///< what it is, in a few words
};

}  // namespace harmos::laws
