#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// What round-off does to the promised quantities of a state, found by an experiment: bodies are loaded with forces
/// like those that round-off leaves in their equations (BodyOperators::perturb()), many times larger, so that the
/// answer is told from round-off itself; the state is corrected for them, and the changes divided by the same number.
///
/// The forces are those of entries of K that are off by one unit in their last place, with signs drawn; those of
/// congruent bodies alike, as they are in the operator that they share. A stiffness that is off does not annihilate
/// rigid motions, which is what makes slender structures sensitive. The answer is the largest of several draws times a
/// factor for what else rounds (factors, solves, sums), and no less than what solutions of bodies are off, see
/// docs/method/round-off.md.
class RoundOff {
 public:
  /// What was found.
  struct Estimate {
    std::vector<double> errors;  ///< relative, as Snapshot::distance()
    int body = -1;               ///< position in the assembly of the body with the largest forces
  };

  /// Both must outlive it.
  RoundOff(FixedPoint& fixedPoint, const std::vector<std::shared_ptr<const Response>>& responses)
      : fixedPoint_(fixedPoint), responses_(responses) {}

  /// Collective, all load steps selected. False when round-off is so small beside the forces that no flexibility of
  /// the structure can make it a share of `accuracy` [-] that matters; costs no solve.
  bool mayMatter(const Iterate& iterate, double accuracy) const;
  /// Collective, all load steps selected. Whether motions of the parts are resisted by so little (SoftMotions) that it
  /// can matter although mayMatter() says that it does not; costs no solve. In the velocity form, and where loads are
  /// to be found, it is not known.
  bool mayMoveParts(const Iterate& iterate, double accuracy) const;

  /// Collective. Of alpha, whose iterate is given. Costs one linear stage where the answer is far below `accuracy`, a
  /// correction for each draw else. No iterate is valid afterwards.
  Estimate estimate(const Iterate& iterate, const base::Matrix& alpha, double accuracy);

 private:
  /// Of each body, with a margin: no response and no field is taken for known better than a solution of a body.
  std::vector<double> solutionErrors() const;
  /// Collective. Round-off of the terms of K u over the largest sum of the forces of interfaces at a load step [-];
  /// infinite: there are none.
  double shareOfForces(const Iterate& iterate) const;

  FixedPoint& fixedPoint_;
  const std::vector<std::shared_ptr<const Response>>& responses_;
};

/// Why double precision does not give an accuracy, for the user: what is attainable, and what would help. `names` of
/// the errors.
std::string describe(const RoundOff::Estimate& estimate, const std::vector<std::string>& names,
                     const assembly::Assembly& assembly);

/// The same where parts have moved so far that their forces are known to `error` [-] only.
std::string describeFarMotions(double error);

/// Of the accuracy, what round-off may take at most where the rest is not known to suffice.
inline constexpr double shareOfRoundOff = 0.5;

}  // namespace harmos::latin
