#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <harmos/latin/Response.hpp>

namespace harmos::latin {

class TractionShare;

/// What a response may be at every load step where the problem does not determine it: the bodies feel nothing of how
/// pairs share what they transmit, but the response does; or there are other solutions. Empty lists where it is
/// determined.
struct ResponseRange {
  std::vector<double> lower;  ///< [unit of the response]; minus infinity: no end
  std::vector<double> upper;  ///< the same; infinity
  bool goesToOtherMotions =
      false;                 ///< the ends are values of solutions with other displacements; others may go further
  bool isOneOfMany = false;  ///< the values that are given are some within, not those of the least tractions

  /// The load step, from 0, at which it is widest; -1 where the response is determined.
  int widest() const;
  /// Largest width over the load steps [unit of the response]; 0 where the response is determined.
  double width() const;
  /// Makes it hold what another solution says, beside the `values` that are given, both per load step, where that is
  /// outside by more than `tolerance` [unit of the response].
  void extend(const std::vector<double>& values, const std::vector<double>& others, double tolerance);
};

/// 'response "N" is not determined: at load step 2 it may be anything from 1 to 3 ...', one sentence for the user.
/// `values` per load step, as they are given; `range` has a width.
std::string describe(const std::string& response, const ResponseRange& range, const std::vector<double>& values);

/// What the problem does not determine at a state.
struct Indeterminacy {
  std::vector<ResponseRange> responses;  ///< of all responses, in their order
  /// Names of interfaces whose friction depends on pressures that are not determined: where these are others, slip may
  /// be another, too, so that there are other solutions.
  std::vector<std::string> pressures;
  /// Ways to states near such solutions: tractions [stress] to be added to the present ones, rows of the layout x load
  /// steps.
  std::vector<base::Matrix> ways;
};

/// What to say of Indeterminacy::pressures, one sentence for the user.
std::string describePressures(const std::vector<std::string>& interfaces);

/// Collective. The ranges of responses at a state over all tractions that the laws admit at its jumps and that move no
/// body, found by linear programmes along Response::slope(), group by group of pairs, and by evaluating the responses
/// at what these find: every value is one that occurs. Exact for resultants in the plane; in space cones are met from
/// inside, 2 % too narrow at most; of a maximum the range may be wider. `add` adds tractions [stress] to the state,
/// which is as before at the end. `tolerance` as TractionShare.
Indeterminacy findIndeterminacy(const TractionShare& share, const Iterate& state,
                                const std::vector<std::shared_ptr<const Response>>& responses, double tolerance,
                                const std::function<void(const base::Matrix&)>& add);

}  // namespace harmos::latin
