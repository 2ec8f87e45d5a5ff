#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/files/GermMap.hpp>
#include <harmos/probability/Polynomials.hpp>

namespace harmos::files {

class Hdf5Source;

/// The expansions that writeStatistics() has put into the file of a study, ready to be evaluated at values of the
/// random parameters.
class StoredExpansions {
 public:
  /// Of the first study in the file; nothing when it has no expansions. Throws base::Error (input) when it is no file
  /// of a study, or expansions are not in terms of its parameters.
  static std::optional<StoredExpansions> read(const std::string& path);

  /// Names of the random parameters, in the order of a point.
  const std::vector<std::string>& parameters() const { return parameters_; }
  /// Names of the responses that have an expansion.
  const std::vector<std::string>& responses() const { return responses_; }

  /// Of all responses, each in its unit, at a point of values of the parameters in theirs. Throws base::Error (input)
  /// for a lognormal parameter that is not positive; beyond the bounds of other parameters the polynomials go on.
  std::vector<double> evaluate(const std::vector<double>& point) const;
  /// Whether each germ lies between the outermost points of the Gauss rule of the expansions' order.
  /// Throws as evaluate().
  bool isInside(const std::vector<double>& point) const;
  /// Of a response, counted from 0, at a random point: one standard deviation of what the expansion is off, in the unit
  /// of the response; not a number when nothing is known of it.
  double deviation(std::size_t response) const { return deviations_[response]; }

 private:
  struct Germ {
    GermMap map;
    probability::Polynomials polynomials;
  };

  explicit StoredExpansions(const Hdf5Source& statistics);
  std::vector<double> germs(const std::vector<double>& point) const;

  int order_;
  std::vector<std::string> parameters_, responses_;
  std::vector<Germ> germs_;
  std::vector<std::vector<int>> indices_;          // degree in every germ, one row per polynomial
  std::vector<std::vector<double>> coefficients_;  // one row per response
  std::vector<double> deviations_;
};

}  // namespace harmos::files
