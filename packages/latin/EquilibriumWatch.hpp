#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <harmos/latin/FreeMotion.hpp>

namespace harmos::latin {

/// Notices during an iteration that the interface laws cannot carry the loads, or not yet.
///
/// Looks at every ninth iteration. When a body has lacked the same reaction under the same forces four times in a row,
/// to within 5 %, it is followed along; see followImbalance(). With a scale of the
/// search direction below 0.01 it does not look.
class EquilibriumWatch {
 public:
  /// Imbalances below a tenth of `accuracy` (relative, see Imbalance) do not count. `isSure` is asked on every rank
  /// whether there is an equilibrium at a column of the state: then no lack of it is found; may be empty.
  /// `rigidBodies`: which bodies are followed as one, as in largestImbalance(); those that are fixed are not, for they
  /// lack what another one does not get.
  explicit EquilibriumWatch(double accuracy, std::function<bool(int)> isSure = {}, std::vector<int> rigidBodies = {})
      : accuracy_(accuracy), isSure_(std::move(isSure)), rigidBodies_(std::move(rigidBodies)) {}

  /// Nothing yet; the laws cannot carry the loads; something stops the body farther on.
  enum class Finding { nothing, noEquilibrium, landing };

  /// Collective; to be asked after every iteration, with image = T(alpha) and its iterate, which may be replaced by
  /// another one of the same alpha. After `landing`, alpha has been moved to where something stops the body.
  Finding look(FixedPoint& fixedPoint, const Iterate*& iterate, base::Matrix& alpha, base::Matrix& image);
  /// Collective. What a body lacks for good at `alpha`, from which the joint slides on at one rate
  /// (StepNewton::settle()), with whatever scale of the search direction: none where something resists the body, or
  /// there surely is an equilibrium. Costs what followImbalance() does, and one linear stage; no iterate is valid
  /// afterwards.
  std::optional<Imbalance> lackAt(FixedPoint& fixedPoint, const base::Matrix& alpha) const;
  /// The last one looked at; there is none before the ninth iteration, nor right after a landing.
  const Imbalance& imbalance() const { return history_.back(); }

 private:
  bool persists() const;

  double accuracy_;
  std::function<bool(int)> isSure_;
  std::vector<int> rigidBodies_;
  int iterations_ = 0;
  std::vector<Imbalance> history_;
};

}  // namespace harmos::latin
