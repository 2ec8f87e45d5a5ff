#pragma once

#include <functional>

#include <harmos/latin/LinearStage.hpp>
#include <harmos/latin/LocalStage.hpp>
#include <harmos/latin/StateMetric.hpp>

namespace harmos::latin {

/// How the two stages are built; see LatinOptions for what the user may set.
struct StageOptions {
  Formulation formulation = Formulation::displacement;  ///< of both stages
  double searchDirectionScale = 1.0;                    ///< factor on the automatic search direction [-], > 0
  bool macroProblem = true;                             ///< whether the linear stage has one
  substructure::SolverOptions solver;                   ///< of the operators of bodies and of the macro problem
};

/// The LATIN iteration as a map: alpha -> T(alpha), one linear stage (with macro problem) and one local stage.
class FixedPoint {
 public:
  /// Collective. Factors all operators. `assembly` and `timers` must outlive this object. Throws base::Error as
  /// BodyOperators and MacroProblem.
  FixedPoint(const assembly::Assembly& assembly, const StageOptions& options,
             const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers);

  /// Restricts the iteration to some load steps, in ascending order: the columns of a state are then these steps. All
  /// load steps after construction. Responses and pairFields() need all.
  void select(const std::vector<int>& steps);
  /// Selects all load steps again.
  void selectAll();
  /// From now on the first column follows on the last one of the last apply(), or again on the unloaded state.
  void startFromHere() { local_.startFromHere(); }
  /// The latter.
  void startUnloaded() { local_.startUnloaded(); }

  /// To be called when laws of the assembly have been replaced by others of the same kind: the operators do not depend
  /// on them, but loads do.
  void updateLaws() { linear_.updateLoads(); }

  /// Puts another map from beta to f^ [stress] in the place of the local stage. Columns, histories and statuses are
  /// then its own affair.
  void replaceLocalStage(std::function<void(const base::Matrix& beta, base::Matrix& traction)> stage) {
    replacement_ = std::move(stage);
  }

  /// Collective. image = T(alpha) [stress], both rows of the layout x columns selected, and two objects; the fields of
  /// the iteration are kept. Throws base::Error as LocalStage::solve().
  void apply(const base::Matrix& alpha, base::Matrix& image);

  // Fields of the last apply(); rows as in TraceLayout, one column per load step.
  /// beta = f - k w [stress] of the linear stage (velocity form: f - k dw).
  const base::Matrix& beta() const { return beta_; }
  /// w [length] of the linear stage.
  const base::Matrix& trace() const { return linear_.trace(); }
  /// f [stress] of the linear stage, in equilibrium with the bodies.
  const base::Matrix& traction() const { return linear_.traction(); }
  /// w^ [length] of the local stage.
  const base::Matrix& hattedTrace() const;
  /// f^ [stress] of the local stage, which obeys the interface laws.
  const base::Matrix& hattedTraction() const { return hattedTraction_; }
  /// u [length] of a node of an owned body, linear stage.
  base::Vector3 displacement(int body, int node, int column) const { return linear_.displacement(body, node, column); }

  /// The assembly that was given.
  const assembly::Assembly& assembly() const { return assembly_; }
  /// k [stress/length] of every pair.
  const assembly::SearchDirection& searchDirection() const { return searchDirection_; }
  /// Where rows of fields belong.
  const TraceLayout& layout() const { return layout_; }
  /// The norm of states.
  const StateMetric& metric() const { return metric_; }
  /// The linear stage, with its work so far.
  const LinearStage& linearStage() const { return linear_; }
  /// The local stage; unused when it was replaced.
  const LocalStage& localStage() const { return local_; }
  /// The same, for those who solve load steps by themselves.
  LocalStage& localStage() { return local_; }
  /// Of both stages.
  Formulation formulation() const { return formulation_; }
  /// Factor on the automatic search direction.
  double searchDirectionScale() const { return searchDirectionScale_; }

 private:
  const assembly::Assembly& assembly_;
  Formulation formulation_;
  double searchDirectionScale_;
  base::Timers& timers_;
  assembly::SearchDirection searchDirection_;
  TraceLayout layout_;
  StateMetric metric_;
  LinearStage linear_;
  LocalStage local_;
  std::function<void(const base::Matrix&, base::Matrix&)> replacement_;  // of local_; empty: none
  base::Matrix beta_;
  base::Matrix hattedTraction_;
  mutable base::Matrix hattedTrace_;  // computed when asked for
  mutable bool hasHattedTrace_ = false;
};

}  // namespace harmos::latin
