#pragma once

#include <string>
#include <vector>

#include <harmos/latin/PairFields.hpp>

namespace harmos::latin {

/// What is printed and written at most: so far from slipping or gaping that the number says nothing.
inline constexpr double largestSafety = 1000.0;

/// How far a law is from letting go: which safeties it has at a load step.
struct ContactKind {
  bool gapes = false;  ///< it bears pressure only
  bool slips = false;  ///< it has friction that it could lose

  /// Of an interface at a load step, from 0, of which one pair at least is so; `times` as those of PairFields.
  static ContactKind of(const assembly::Interface& interface, const std::vector<double>& times, int step);
};

/// Safeties of the pairs of an interface [-], steps x pairs as PairFields::at(), 1 and above, at most largestSafety.
struct Safety {
  /// By what the shear may grow before the pair slips, 1 where it does: mu p / |t_t| of Coulomb's law, of others
  /// InterfaceLaw::shearLimit() over |t_t|. Where nothing bears shear, and without friction: largestSafety.
  std::vector<double> slip;
  /// p_max / (p_max - p), p_max the largest pressure so far: by what the unloading may grow before the pair gapes, 1
  /// where it has done so. Of pairs that were never pressed, and that are pressed more than ever: largestSafety.
  std::vector<double> gaping;
  /// Whether the pair has been pressed by a hundredth of the largest pressure of the interface over all steps: others
  /// touch by accident, and do not decide. steps x pairs.
  std::vector<bool> counts;
};

/// Safeties of one interface; those that its law does not have are largestSafety. Not collective.
Safety safety(const assembly::Interface& interface, const PairFields& fields);

/// What an interface as a whole has left, sums over its pairs at a load step.
struct ContactSums {
  double pressure = 0.0;         ///< sum of h p [force]
  double capacity = 0.0;         ///< sum of h times the shear that friction bears, mu p of Coulomb's law [force]
  double shear = 0.0;            ///< sum of h |t_t| [force]
  double largestPressure = 0.0;  ///< of `pressure` up to the load step [force]

  /// `capacity` over `shear`: 1 when every pair slips; never more than mu F_n / F_t of a plane interface.
  double slip() const;
  /// As that of a pair, of `pressure` over `largestPressure`.
  double gaping() const;
};

/// Adds the pairs of one interface at a load step to its sums, but for `largestPressure`.
void add(const assembly::Interface& interface, const PairFields& fields, int step, ContactSums& sums);

}  // namespace harmos::latin
