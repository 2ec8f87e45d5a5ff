#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/files/GermMap.hpp>
#include <harmos/results/Interpolant.hpp>

namespace harmos::files {

class Hdf5Source;

/// The piecewise linear interpolation that writeStatistics() has put into the file of a study, ready to be evaluated at
/// values of the random parameters.
class StoredInterpolant {
 public:
  /// Of all responses at one point, in their units.
  struct Prediction {
    std::vector<double> values;
    std::vector<double> deviations;  // one standard deviation each, calibrated
    bool isInside = true;            // of what is interpolated; beyond, responses count as constant
  };

  /// Of the first study in the file; nothing when it has no interpolation. Throws base::Error (input) when it is no
  /// file of a study, or the interpolation is not in terms of its parameters.
  static std::optional<StoredInterpolant> read(const std::string& path);

  /// Names of the random parameters, in the order of a point.
  const std::vector<std::string>& parameters() const { return parameters_; }
  /// Names of the responses.
  const std::vector<std::string>& responses() const { return responses_; }
  /// `point`: values of the parameters, in their units. Throws base::Error (input) for a lognormal parameter that is
  /// not positive.
  Prediction evaluate(const std::vector<double>& point) const;

 private:
  explicit StoredInterpolant(const Hdf5Source& statistics);

  std::vector<std::string> parameters_, responses_;
  std::vector<GermMap> maps_;
  std::optional<results::Interpolant> interpolant_;
};

}  // namespace harmos::files
