#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/TangentSpace.hpp>

namespace harmos::latin {

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
/// have left, and spaces last no longer than that: what is kept of directions does not grow with the load steps.
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
    /// What each load step keeps of its own residual, no more than it was asked for, or of the largest, if that is
    /// more.
    std::vector<double> shares;
    /// What the residual can hide: largest |R_t| / (s_t d), s_t the smallest singular value of I - J in the space of
    /// the step, d the longest way that a step was moved. Slow modes are all but absent from the residual.
    double hidden = 0.0;
    /// That of the corrected state, valid as FixedPoint::apply() says; null where none was found.
    const Iterate* iterate = nullptr;
  };

  /// `fixedPoint` must outlive it. `precision`: single, where images may be found so.
  explicit CausalCorrection(FixedPoint& fixedPoint, substructure::Precision precision = substructure::Precision::exact);

  /// Where a correction ends.
  struct Goal {
    double reduction;  ///< largest |R_t| over that before
    /// Of the fields of the result, relative [-]: where the way of a load step tells a larger one, each goes as far as
    /// its own way asks for, in later corrections, too.
    double error = std::numeric_limits<double>::infinity();
    /// Of later corrections, as `reduction`, larger than it: enough for a load step whose fields have not moved by more
    /// than `near`.
    double roughly = 0.0;
    double near = 0.0;  ///< relative to the largest fields [-]
  };

  /// Collective, all load steps selected. Moves `alpha`, whose iterate is given, until every load step has |R| <=
  /// reduction x the largest |R| of the start, both as weighed, and no more than half of the way can be hidden; in
  /// later corrections also reduction x its own |R| of the start, or a tenth of the former where that is more, with
  /// `roughly` in the place of `reduction` where that is enough. Or until `stages` linear stages were spent, or the
  /// residuals no longer fall. No iterate is valid afterwards but that of the result, whose image is in `image`
  /// [stress] then. Throws base::Error as LocalStage::solve().
  Result correct(const Iterate& iterate, base::Matrix& alpha, base::Matrix& image, const Goal& goal, int stages);

 private:
  struct Step {
    std::optional<TangentSpace> tangent;  // of the load steps at hand
    bool isStale = true;                  // the tangents are not those of a state like this one
    double steepness = 1.0;               // smallest singular value of I - J in spaces that were let go
    double residual = 0.0;                // |R|
    double before = 0.0;                  // |R| at the start
    int directions = 0;                   // new ones since then
    double share = 1.0;                   // that is asked for, of the largest |R| at the start
    double moved = 0.0;                   // |alpha - start|
    bool isLeft = true;                   // has not come to the target
    double weight = 1.0;  // of the target: its share of this load step, small where small residuals mean long ways
  };

  void start(const Iterate& iterate, base::Matrix& alpha);
  /// Lets go of the fields of all load steps.
  void finish();
  /// Solves the local stage of a load step; returns |R|, and leaves R in residual_.
  double evaluate(int step);
  /// Gauss-Newton in the space of one load step, after those before it were settled.
  void reduce(int step);
  /// Moves a load step in its space if that makes |R| less; false when not even a quarter of the step does.
  bool takeStep(int step, const CorrectionSpace::LeastSquares& direction);
  /// The residuals of the load steps at hand from `first` on in turn, as small as their spaces allow; the steps before
  /// have come to their end.
  void sweep(int first);
  /// Those of the load steps at hand that have not come to their end.
  std::vector<int> unfinished();
  /// Of unfinished load steps those that go on: in later corrections first those with too large a residual; when these
  /// have gone their ways, which all are measured by, those where most can be hidden.
  std::vector<int> foremost(const std::vector<int>& steps) const;
  /// Of the load steps so far; later ones go at least half of their residual.
  double longestWay() const;
  /// |R| that a load step is brought to. Later corrections tell errors by their ways: each load step must go some, or
  /// what is wrong with it would go unseen beside larger residuals of others.
  double targetOf(const Step& step) const;
  /// The smallest singular value of I - J that was met at a load step.
  static double smallestSingularValue(const Step& step);
  /// Of the load steps from `begin` on and before `end`, over the weights.
  double largestResidual(int begin, int end) const;
  double largestResidual() const { return largestResidual(0, alpha_->numCols()); }
  double hidden() const;
  /// Collective. Less weight for load steps that would leave more than goal.error; whether there are any.
  bool sharpen(const Goal& goal);
  /// Collective. Whether no load step has moved its fields by more than goal.near; asks more of those that have.
  bool settleThoseNear(const Goal& goal);
  /// Brings all load steps to their end, some after the others, within so many linear stages.
  void approach(int stages);
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
  std::vector<Step> steps_;
  int begin_ = 0, end_ = 0;               // of the load steps at hand
  int first_ = 0;                         // load step that the local stage begins at
  double before_ = 0.0;                   // largest |R| at the start, over the weights
  bool isLater_ = false;                  // every load step must move
  double noise_ = 0.0;                    // residuals below this one are round-off
  base::ColumnStore start_, startImage_;  // alpha and its beta at the beginning
  base::Matrix* alpha_ = nullptr;         // the caller's
  base::Matrix beta_, residual_;
};

}  // namespace harmos::latin
