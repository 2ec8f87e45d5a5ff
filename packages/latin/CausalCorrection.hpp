#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <harmos/latin/CorrectionSpace.hpp>
#include <harmos/latin/CorrectionTargets.hpp>
#include <harmos/latin/FixedPoint.hpp>

namespace harmos::latin {

class SoftMotions;
class StepSpace;
class UnfinishedSteps;

/// Corrects a state towards alpha = T(alpha), every load step in a space of its own, one after the other.
///
/// Where some load steps have not reached the target, one linear stage for all of these finds the images y of new
/// directions v, the residuals R = T(alpha) - alpha made independent of the directions before. Then, from the first
/// load step to the last, alpha + V c and its image beta + Y c are known without a solve, so that local stages alone
/// find the true residual, with the history that the corrected steps before have left: c by Gauss-Newton, with the
/// tangents of PairTangents, in which a step is taken, or a half or a quarter of it, only where |R| falls. The spaces
/// last from one correction to the next, since y depends on no state; the g = (I - J) v are found anew where a tangent
/// no longer predicts the residual, without a solve. Norms are those of StateMetric. Displacement form, with the local
/// stage PointwiseLocalStage.
///
/// Of many load steps, stepsAtOnce are brought to their end together, then the next ones, with the history that they
/// have left, and spaces last no longer than that, but for those of as many load steps whose modes are softest, as
/// where all but a few points slide: what is kept of directions does not grow with the load steps.
///
/// Images y may be found in single precision, since they only say where to go: where any was, the way ends with an
/// application of T in double precision, and what is said of the residual is what that has found. Where it is larger
/// than the images promised, the correction goes on from there in double precision (iterative refinement).
/// Source of the idea: recycling Krylov subspaces, Parks et al. (2006), doi:10.1137/040607277.
class CausalCorrection {
 public:
  /// What a correction has come to.
  struct Result {
    double reduction = 1.0;  ///< largest |R_t| over the load steps t, over that before, both as weighed then
    /// What each load step keeps of its own residual, or of the largest, if that is more.
    std::vector<double> shares;
    /// What the residual can hide: largest |R_t| / (s_t d), s_t the smallest singular value of I - J in the space of
    /// the step, d the longest way that a step was moved. Slow modes are all but absent from the residual.
    /// Infinite where a residual asks for a way that only round-off asks for, along motions that hardly anything
    /// resists.
    double hidden = 0.0;
    /// That of the corrected state, valid as FixedPoint::apply() says; null where none was found.
    const Iterate* iterate = nullptr;
  };

  /// `fixedPoint` must outlive it. `precision`: single, where images may be found so.
  explicit CausalCorrection(FixedPoint& fixedPoint, substructure::Precision precision = substructure::Precision::exact);

  ~CausalCorrection();
  CausalCorrection(const CausalCorrection&) = delete;
  CausalCorrection& operator=(const CausalCorrection&) = delete;

  /// Where a correction ends.
  using Goal = CorrectionTargets::Goal;

  /// Collective, all load steps selected. Moves `alpha`, whose iterate is given, until every load step has |R| <=
  /// reduction x the largest |R| of the start, both as weighed, and no more than half of the way can be hidden; in
  /// later corrections also reduction x its own |R| of the start, or a tenth of the former where that is more. Or until
  /// `stages` linear stages were spent, or the residuals no longer fall. Where they have grown, `alpha` is left as it
  /// was. No iterate is valid afterwards but that of the result, whose image is in `image` [stress] then. Throws
  /// base::Error as LocalStage::solve().
  Result correct(const Iterate& iterate, base::Matrix& alpha, base::Matrix& image, const Goal& goal, int stages);

 private:
  void start(const Iterate& iterate, base::Matrix& alpha);
  /// Lets go of the fields of all load steps.
  void finish();
  /// Solves the local stage of a load step; returns |R|, and leaves R in residual_.
  double solveLocal(int step);
  /// The same, and settles what bodies do not feel: SelfStresses::settle().
  double evaluate(int step);
  /// Gauss-Newton in the space of one load step, after those before it were settled.
  void reduce(int step);
  /// Moves a load step if that comes to a residual |R| which `accepts`; false, and the local stage has met another
  /// state, when not.
  bool tryMove(int step, const std::function<void(double* alpha, double* beta)>& move,
               const std::function<bool(double reached)>& accepts);
  /// Moves a load step in its space if that makes |R| less; false when not even a quarter of the step does.
  bool takeStep(int step, const CorrectionSpace::LeastSquares& direction);
  /// Moves a load step along motions that its space cannot hold, StepSpace::faintMotions(), unless its residual grows
  /// or asks for too much.
  void settleFaintMotions(int step);
  /// What `treat` makes of the load steps at hand from `first` on in turn; the steps before have come to their end.
  void sweep(int first, void (CausalCorrection::*treat)(int step));
  /// Collective. How far the fields of each load step have moved, relative to the largest [-].
  std::vector<double> ways() const;
  /// Brings all load steps to their end, some after the others, within so many linear stages.
  void approach(int stages);
  /// Of many load steps: lets go of all spaces but the softest, stepsAtOnce at most.
  void letGo();
  /// Lets the spaces of the load steps at hand grow until these have come to their end, or what is left says that they
  /// will not.
  void approachTogether(int stages);
  /// Puts the true residuals in the place of those that the images have given, and lets go of beta_ and residual_;
  /// returns the iterate.
  const Iterate& verify(base::Matrix& image);
  /// How exactly the images of the next directions are found.
  substructure::Precision precision();
  /// New directions for some load steps; false when there are none.
  bool extend(const std::vector<int>& steps);

  FixedPoint& fixedPoint_;
  substructure::Precision finest_;   // single: where that does no harm
  substructure::Precision allowed_;  // now
  bool isRough_ = false;             // some images were found in single precision
  InterfaceLines lines_;
  std::unique_ptr<SoftMotions> softMotions_;
  std::vector<StepSpace> steps_;
  double reach_ = 0.0;       // of ways along motions that hardly anything resists; 0: nothing was corrected yet
  bool goesAstray_ = false;  // a residual has asked for more
  CorrectionTargets targets_;
  std::unique_ptr<UnfinishedSteps> unfinished_;
  int begin_ = 0, end_ = 0;               // of the load steps at hand
  int first_ = 0;                         // load step that the local stage begins at
  double noise_ = 0.0;                    // residuals below this one are round-off
  base::ColumnStore start_, startImage_;  // alpha and its beta at the beginning
  base::Matrix* alpha_ = nullptr;         // the caller's
  base::Matrix beta_, residual_;
};

}  // namespace harmos::latin
