#pragma once

#include <memory>
#include <optional>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Timers.hpp>
#include <harmos/latin/BodyOperators.hpp>
#include <harmos/latin/Formulation.hpp>
#include <harmos/latin/LoadFactor.hpp>
#include <harmos/latin/MacroProblem.hpp>
#include <harmos/latin/UnfeltStates.hpp>

namespace harmos::latin {

/// Linear stage: equilibrium of every body with the descent search direction E- (13), f - f^ = -k (w - w^).
///
/// Displacement form, eq. (24): (K + k h) u = h alpha + l with alpha = f^ + k w^; all load steps in one block solve.
/// Velocity form, eqs. (19)-(23) with k = k_v / dt, so that one factor serves every step size: the state is
/// alpha = f^ + k dw^ with dw the displacement increment of the step, and (K + k h) u_t = h (alpha_t + k w_{t-1}) +
/// l_t, step after step. A PathControl makes a share of l one more unknown, see LoadFactor; displacement form only. K:
/// [force/length], h: [area], k: [stress/length], l: loads of the body [force].
class LinearStage {
 public:
  /// Collective. Factors all operators. `assembly`, `layout`, `eliminated` and `timers` must outlive it. Throws
  /// base::Error as BodyOperators and MacroProblem.
  LinearStage(const assembly::Assembly& assembly, const assembly::SearchDirection& searchDirection,
              const TraceLayout& layout, const EliminatedBoundaries& eliminated, Formulation formulation,
              bool withMacroProblem, const substructure::SolverOptions& options, base::Timers& timers);

  /// Sets which load step each column of a field is, or BodyOperators::withoutLoads; to be called before the first
  /// solve.
  void select(const std::vector<int>& steps);

  /// To be called when the laws of boundaries without unknowns have been replaced.
  void updateLoads();
  /// Puts other load cases in the place of the load steps, until updateLoads(); see BodyOperators::setLoads(). Bodies
  /// are then moved by them alone. Displacement form only.
  void setLoads(std::vector<base::Matrix> loads, std::vector<base::Matrix> held);

  /// Motions that all displacements are counted from, from now on: u' and w' of u = rho + u', w = rho + w' take the
  /// place of u and w. They must outlive it; updateLoads() is to be called when they change. Displacement form only.
  void setReference(const ReferenceMotions& reference) { operators_.setReference(reference); }

  /// As BodyOperators::perturb(), also for the macro problem.
  void perturb(unsigned seed, double times);
  /// Undoes it.
  void unperturb();

  /// Collective. From alpha [stress] to beta = f - k w [stress] (velocity form: f - k dw); keeps w. In single precision
  /// only after prepareSingle().
  void solve(const base::Matrix& alpha, base::Matrix& beta,
             substructure::Precision precision = substructure::Precision::exact);
  /// Collective. Prepares solves in single precision, the first time it is called. Returns the largest relative error
  /// of w [-] that they make in the bodies of any rank, see SubstructureSolver::singleError(); 0: they are exact.
  double prepareSingle();

  /// Adds tractions [stress] to those of the last solve of all columns, and to its beta, that move no body.
  void addBalanced(const base::Matrix& tractions, base::Matrix& beta);

  /// Trace w [length] and traction f [stress] of the last solve.
  const base::Matrix& trace() const { return trace_; }
  /// The latter [stress].
  const base::Matrix& traction() const { return traction_; }

  /// Displacement u [length] of a node of an owned body in the last solve.
  base::Vector3 displacement(int body, int node, int column) const {
    return operators_.displacement(body, node, column);
  }

  /// Load factor lambda [-] of every column of the last solve, where there is a PathControl.
  const std::vector<double>& loadFactors() const { return loadFactor_->factors(); }

  /// Work so far: columns solved over the number of load steps, so that a solve of all load steps counts as one.
  int stages() const { return static_cast<int>((columnsSolved_ + assembly_.steps() - 1) / assembly_.steps()); }
  /// Goes on counting from what another stage has solved.
  void countFrom(long columns) { columnsSolved_ = columns; }
  /// Columns solved so far.
  long columns() const { return columnsSolved_; }
  /// The factored operators of the bodies owned here.
  const BodyOperators& operators() const { return operators_; }
  /// Unknowns of the macro problem; 0 without one.
  int macroUnknowns() const { return macro_ ? macro_->unknowns() : 0; }
  /// What it does not feel of alpha: nothing without a macro problem.
  const UnfeltStates& unfelt() const { return unfelt_; }
  /// Of the macro problem, see MacroProblem::softness(); 1 without one.
  double softness() const { return macro_ ? macro_->softness() : 1.0; }

 private:
  /// h f of the columns first .. first + count - 1 [force], by themselves.
  base::Matrix forcesOf(const base::Matrix& traction, int first, int count) const;
  /// Solves for the loads that a PathControl multiplies, by themselves. The fields of the last solve are lost.
  void prepareLoadFactor();
  void solveSteps(base::Matrix& alpha, int first, int count, substructure::Precision precision);

  const assembly::Assembly& assembly_;
  const TraceLayout& layout_;
  Formulation formulation_;
  std::vector<int> steps_;             // load step of every column
  std::optional<double> singleError_;  // once it is known
  base::Timers& timers_;
  BodyOperators operators_;
  std::unique_ptr<MacroProblem> macro_;
  UnfeltStates unfelt_;
  std::unique_ptr<LoadFactor> loadFactor_;  // null: all loads are given
  base::Matrix trace_;
  base::Matrix traction_;  // during a solve alpha with the correction of the macro problem
  long columnsSolved_ = 0;
};

}  // namespace harmos::latin
