#pragma once

#include <string>

namespace harmos::files {

class Hdf5Source;

/// How a random parameter follows from its germ, as the file of a study has it: parameter = shift + scale germ, or the
/// exponential of it.
struct GermMap {
  std::string name;            ///< of the parameter
  double shift = 0.0;          ///< in the unit of the parameter, or of its logarithm
  double scale = 0.0;          ///< the same
  bool isExponential = false;  ///< the parameter is lognormal

  /// Of a group of a variable. Throws base::Error (input) when its value alone does not tell the germ.
  static GermMap read(const Hdf5Source& group, const std::string& name);
  /// The germ of a value. Throws base::Error (input) for a lognormal parameter that is not positive.
  double germ(double value) const;
};

}  // namespace harmos::files
