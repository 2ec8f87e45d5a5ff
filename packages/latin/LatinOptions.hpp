#pragma once

#include <harmos/latin/FixedPoint.hpp>

namespace harmos::input {
class ParameterSpec;
class Parameters;
}  // namespace harmos::input

namespace harmos::latin {

/// How the fixed point alpha = T(alpha) is iterated.
enum class Algorithm {
  accelerated,  ///< per-step Anderson acceleration
  plain,        ///< alpha <- T(alpha), as in the source
  relaxed       ///< alpha <- alpha + relaxation (T(alpha) - alpha)
};

/// What the user may set; everything but the accuracy has a default that should not need changing.
struct LatinOptions {
  double accuracy = 1e-3;        ///< largest relative error of every response and of the interface fields
  int maximumIterations = 1000;  ///< linear stages, those of the error estimate included
  Algorithm algorithm = Algorithm::accelerated;  ///< plain and relaxed: the iterations of the literature
  double relaxation = 0.8;                       ///< of Algorithm::relaxed [-], in (0, 1]
  int memory = 30;                               ///< differences that the acceleration keeps per load step
  /// How often a march that stagnates may go on with a tenth of the search direction; where that leads nowhere, the run
  /// begins anew with a tenth of it and one restart less, then without any. After such a run the fixed point keeps the
  /// last one.
  int restarts = 2;
  /// Whether displacements are counted from the rigid motion of each body where round-off asks for it, see
  /// FixedPoint::recentre(); after such a run the fixed point keeps these motions.
  bool recentres = true;
  StageOptions stages;  ///< how both stages are built

  LatinOptions() = default;
  /// From a checked list Solver, of which nothing is kept.
  explicit LatinOptions(const input::Parameters& parameters);
  /// Declares the entries of the list Solver with their defaults and limits.
  static void describe(input::ParameterSpec& spec);
};

/// Returns its argument. Throws base::Error (input) where a number is out of its range: accuracies above 0 and below 1,
/// iterations and memory at least 1, no negative number of restarts, relaxations above 0 and at most 1, scales above 0
/// and finite.
const LatinOptions& demandValid(const LatinOptions& options);

}  // namespace harmos::latin
