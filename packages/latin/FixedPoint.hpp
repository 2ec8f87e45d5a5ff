#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <harmos/latin/Iterate.hpp>
#include <harmos/latin/PointwiseLocalStage.hpp>
#include <harmos/latin/ResponseRange.hpp>

namespace harmos::latin {

class SelfStresses;
class TractionShare;

/// How the two stages are built; see LatinOptions for what the user may set.
struct StageOptions {
  Formulation formulation = Formulation::displacement;  ///< of both stages
  double searchDirectionScale = 1.0;                    ///< factor on the automatic search direction [-], > 0
  bool macroProblem = true;                             ///< whether the linear stage has one
  Elimination elimination = Elimination::affine;        ///< of outer boundaries; none in the velocity form
  substructure::SolverOptions solver;                   ///< of the operators of bodies and of the macro problem
  /// Folder for what of many load steps is not at hand (base::ColumnStore), which must be there; empty: memory.
  std::string scratch;
};

/// The LATIN iteration as a map: alpha -> T(alpha), one linear stage (with macro problem) and one local stage.
class FixedPoint {
 public:
  /// Makes the local stage; the arguments outlive it.
  using MakeLocalStage =
      std::function<std::unique_ptr<LocalStage>(const assembly::SearchDirection&, const TraceLayout&)>;

  /// Collective. Factors all operators. `assembly` and `timers` must outlive this object. The local stage is
  /// PointwiseLocalStage, or what is made instead of it. Throws base::Error as LinearStage.
  FixedPoint(const assembly::Assembly& assembly, const StageOptions& options,
             const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers,
             const MakeLocalStage& makeLocalStage = {});
  ~FixedPoint();
  FixedPoint(const FixedPoint&) = delete;
  FixedPoint& operator=(const FixedPoint&) = delete;

  /// Restricts the iteration to some load steps, in ascending order: the columns of a state are then these steps. All
  /// load steps after construction. Responses and pairFields() need all.
  void select(const std::vector<int>& steps);
  /// Selects all load steps again.
  void selectAll();
  /// Lets go of the fields of both stages, as large as all load steps together, until the next select() or selectAll();
  /// the local stage stays as it is. Ends the validity of all iterates.
  void releaseFields();
  /// Room for a field of all load steps, rows x steps, that is not asked for all the time: of more than stepsAtOnce
  /// in StageOptions::scratch. Throws base::Error as base::ColumnStore.
  base::ColumnStore store(int rows) const { return {rows, assembly_.steps(), fields_.scratch}; }
  /// From now on the first column follows on the last one of the last apply(). Displacement form only.
  void startFromHere() { local_->startFromHere(); }
  /// From now on the first column follows on the unloaded state again, as after construction.
  void startUnloaded() { local_->startUnloaded(); }

  /// At its end, also when a law throws, all load steps are selected again and follow on the unloaded state.
  class AllStepsAtEnd {
   public:
    /// `fixedPoint` must outlive it.
    explicit AllStepsAtEnd(FixedPoint& fixedPoint) : fixedPoint_(fixedPoint) {}
    ~AllStepsAtEnd() {
      fixedPoint_.startUnloaded();
      fixedPoint_.selectAll();
    }
    AllStepsAtEnd(const AllStepsAtEnd&) = delete;
    AllStepsAtEnd& operator=(const AllStepsAtEnd&) = delete;

   private:
    FixedPoint& fixedPoint_;
  };

  /// To be called when laws of the assembly have been replaced by others of the same kind: the operators do not depend
  /// on them (with Elimination::affine, as long as springs of boundaries stay), but loads do. Throws as
  /// EliminatedBoundaries::update().
  void updateLaws();

  /// Puts load cases of bodies in the place of the load steps, until updateLaws(); see BodyOperators::setLoads(). A
  /// state then belongs to select()ed cases, and only solveLinear() may be asked.
  void setLoads(std::vector<base::Matrix> loads, std::vector<base::Matrix> held) {
    linear_->setLoads(std::move(loads), std::move(held));
  }

  /// Collective. Makes search directions of another scale [-], > 0, and factors all operators anew; what the local
  /// stage remembers stays. A fixed point alpha = f^ + k w^ of before becomes f^ + c (alpha - f^), c the quotient of
  /// the scales. Ends the validity of all iterates. Throws as the constructor.
  void rescale(double scale);

  /// Collective, all load steps selected. From now on displacements are counted from the rigid motions of the bodies in
  /// `iterate`, that of alpha: alpha = f^ + k w^ becomes f^ + k (w^ - rho), and T that of such states; see
  /// ReferenceMotions. Displacement form, with the local stage PointwiseLocalStage. Ends the validity of all iterates.
  void recentre(const Iterate& iterate, base::Matrix& alpha);
  /// Counts from zero again; alpha becomes f^ + k w^.
  void uncentre(base::Matrix& alpha);
  /// Makes of alpha, counted from the motions, what it is counted from zero; changes nothing else.
  void addReference(base::Matrix& alpha) const { addDifference(reference_, ReferenceMotions(assembly_), alpha); }
  /// Whether recentre() can be called.
  bool canRecentre() const {
    return options_.formulation == Formulation::displacement && pointwise_ != nullptr && !assembly_.path;
  }
  /// Residuals below this share of a state are round-off.
  static constexpr double noise = 1e-13;
  /// Residuals [force length, square root] below this one are round-off in states of this norm, of the selected load
  /// steps: that of the linear stage, and that of laws, which see the motions that displacements are counted from.
  double roundOff(double norm) const;
  /// What displacements are counted from.
  const ReferenceMotions& reference() const { return reference_; }

  /// From now on T is that of bodies with other round-off, `times` as large, drawn by `seed`; to be called after an
  /// application to all load steps, whose displacements tell how large it is. See BodyOperators::perturb(). Ends the
  /// validity of all iterates.
  void perturb(unsigned seed, double times);
  /// T is again what it was.
  void unperturb();

  /// Collective. image = T(alpha) [stress], both rows of the layout x columns selected, and two objects. Throws
  /// base::Error as LocalStage::solve(). The fields of both stages are valid until the next apply(), select() or
  /// selectAll(). In single precision only after prepareSingle().
  const Iterate& apply(const base::Matrix& alpha, base::Matrix& image,
                       substructure::Precision precision = substructure::Precision::exact);
  /// Collective. See LinearStage::prepareSingle(); to be called again after rescale().
  double prepareSingle() { return linear_->prepareSingle(); }

  /// Collective, one load step selected. Settles what bodies do not feel in the present iterate, its alpha and its
  /// image [stress]: SelfStresses::settle(). Displacement form, with the local stage PointwiseLocalStage; otherwise
  /// nothing is done. Throws as apply().
  void settleUnfelt(base::Matrix& alpha, base::Matrix& image);
  /// Collective. Gives the present iterate, its alpha and its image [stress] those tractions that are defined where the
  /// bodies cannot tell what pairs share (TractionShare): T and its fixed points mean the same as before. `accuracy`
  /// [-]: relative, of the fields. The new tractions keep to the laws to a hundredth of it, or to twice the distance of
  /// both stages where that is more: across wider gaps nothing is shared. Returns what both have got [stress], rows of
  /// the layout x load steps; no columns where nothing is shared. All load steps must be selected.
  base::Matrix shareTractions(base::Matrix& alpha, base::Matrix& image, double accuracy);
  /// Collective. Takes from the present iterate, its alpha and its image what shareTractions() has given them.
  void takeBack(base::Matrix shared, base::Matrix& alpha, base::Matrix& image);
  /// Collective. What the present iterate does not determine to that accuracy, see findIndeterminacy().
  Indeterminacy indeterminacy(const std::vector<std::shared_ptr<const Response>>& responses, double accuracy);

  /// Collective. The linear stage alone, for the load steps selected: beta [stress] of alpha, see LinearStage::solve().
  /// No iterate is valid afterwards.
  void solveLinear(const base::Matrix& alpha, base::Matrix& beta,
                   substructure::Precision precision = substructure::Precision::exact) {
    ++fields_.present;
    linear_->solve(alpha, beta, precision);
  }
  /// The same for these load steps, after releaseFields().
  void solveLinear(const std::vector<int>& steps, const base::Matrix& alpha, base::Matrix& beta,
                   substructure::Precision precision) {
    linear_->select(steps);
    solveLinear(alpha, beta, precision);
    linear_->select({});
  }

  /// Collective. A x [stress] of columns x [stress] that alpha changes by, where beta = A alpha + b, by itself: errors
  /// of single precision are relative to x, not to what the loads do. No iterate is valid afterwards, and select() or
  /// selectAll() must follow. Displacement form only.
  void solveChange(const base::Matrix& change, base::Matrix& image, substructure::Precision precision) {
    linear_->select(std::vector<int>(static_cast<std::size_t>(change.numCols()), BodyOperators::withoutLoads));
    solveLinear(change, image, precision);
  }

  /// The assembly that was given.
  const assembly::Assembly& assembly() const { return assembly_; }
  /// k [stress/length] of every pair.
  const assembly::SearchDirection& searchDirection() const { return searchDirection_; }
  /// The boundaries without unknowns that stand in the operators.
  const EliminatedBoundaries& eliminated() const { return eliminated_; }
  /// What these do to rigid motions.
  const HeldMotions& heldMotions() const { return heldMotions_; }
  /// The tractions that bodies do not feel.
  const SelfStresses& selfStresses() const { return *selfStresses_; }
  /// Where rows of fields belong.
  const TraceLayout& layout() const { return layout_; }
  /// The norm of states.
  const StateMetric& metric() const { return metric_; }
  /// The linear stage, with its work so far.
  const LinearStage& linearStage() const { return *linear_; }
  /// For those who solve load steps by themselves; only where no other local stage was made.
  PointwiseLocalStage& pointwiseStage();
  /// Kinematic unknown of both stages.
  Formulation formulation() const { return options_.formulation; }
  /// Factor on the automatic search direction.
  double searchDirectionScale() const { return options_.searchDirectionScale; }

 private:
  /// Lets go of what of an iterate is computed when asked for.
  void releaseDerived();
  /// alpha += k (rho1 - rho2).
  void addDifference(const ReferenceMotions& rho1, const ReferenceMotions& rho2, base::Matrix& alpha) const;
  /// Collective. Norm of k times the jumps of the motions [force length, square root], per load step.
  std::vector<double> jumpsOfReference() const;
  /// The local stage of the beta at hand; the image that belongs to it.
  void solveLocal(base::Matrix& image);
  /// Adds tractions [stress] to the present iterate that the bodies do not feel.
  void addBalanced(const base::Matrix& tractions);
  /// Throws base::Error (input) where a PathControl multiplies what the linear stage does not prescribe.
  void demandFollowable() const;
  /// After everything else, whose search direction they belong to.
  void makeShare();
  /// May give up the elimination, where boundaries leave the assembly free to move.
  std::unique_ptr<LinearStage> makeLinearStage();

  const assembly::Assembly& assembly_;
  StageOptions options_;
  base::Timers& timers_;
  assembly::SearchDirection searchDirection_;
  std::vector<ResistedMotions> resisted_;  // in the plane
  EliminatedBoundaries eliminated_;
  HeldMotions heldMotions_;
  TraceLayout layout_;
  StateMetric metric_;
  ReferenceMotions reference_;
  std::vector<double> referenceJumps_;  // per load step: norm of k times its jumps; empty: none
  std::unique_ptr<LinearStage> linear_;
  PointwiseLocalStage* pointwise_ = nullptr;  // local_, or null when that is another one
  std::unique_ptr<LocalStage> local_;
  std::unique_ptr<TractionShare> share_;
  std::unique_ptr<SelfStresses> selfStresses_;
  Iterate::Fields fields_;
  std::vector<Iterate> iterates_;  // in turns, so that an old one is known to be no longer valid
};

}  // namespace harmos::latin
