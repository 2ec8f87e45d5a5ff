#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <harmos/base/SoleThread.hpp>
#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/stochastic/ChaosLocalStage.hpp>
#include <harmos/stochastic/ChaosSnapshot.hpp>
#include <harmos/stochastic/StochasticOptions.hpp>
#include <harmos/stochastic/StochasticResult.hpp>

/// Random laws and loads by polynomial chaos inside LATIN, and the direct method that it is compared with.
namespace harmos::stochastic {

/// Solves an assembly whose interface laws and prescribed tractions are random by polynomial chaos inside LATIN.
///
/// All fields are expanded, X = sum of X_a psi_a(xi). The linear stage is that of latin::FixedPoint on modal columns
/// (see modalAssembly): its operators are constant, factored once, and serve any laws. The local stage is
/// ChaosLocalStage. The fixed point is iterated with Anderson acceleration over all polynomials of a load step
/// together; all load steps at once, or one after the other when a law remembers.
///
/// Stop: a run to a residual and a run to a tenth of it differ by about the error of the first. This difference is the
/// estimate for the second, which is delivered when the estimate is within the accuracy and the gap of the fields
/// within ten times it; otherwise the residual is lowered. Source: Champaney, Blanze, Boucard (2004), section 4, eqs
/// (25)-(27).
class StochasticSolver {
 public:
  /// Collective. Factors all operators. The laws of `assembly` are not random; `assembly` and `timers` must outlive the
  /// solver. Throws base::Error as latin::LatinSolver, and (input) for the velocity form.
  StochasticSolver(const assembly::Assembly& assembly, std::shared_ptr<const Projection> projection,
                   const StochasticOptions& options, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                   base::Timers& timers);

  StochasticSolver(const StochasticSolver&) = delete;
  StochasticSolver& operator=(const StochasticSolver&) = delete;

  /// Replaces the laws; the operators stay. Throws base::Error (input) when they are not of the kind of those of the
  /// assembly, or not fit for the method.
  void setLaws(const Realisations& laws);
  /// Adds a response whose accuracy is promised as well, and shares it. To be called before solve().
  void addResponse(std::shared_ptr<const latin::Response> response) { responses_.push_back(std::move(response)); }
  /// Called on every rank after every iteration over all load steps, or after every load step of a march.
  void addObserver(std::function<void(const latin::IterationReport&)> observer) {
    observers_.push_back(std::move(observer));
  }
  /// Asked on every rank after every iteration; the run stops when it is true on any rank.
  void setInterrupt(std::function<bool()> interrupted) { interrupted_ = std::move(interrupted); }

  /// Collective. Runs from 0, or from a state that a run has left in alpha(), its own or another one's.
  StochasticResult solve(const base::Matrix* start = nullptr);
  /// Fields of the delivered state: their coefficients. See column(). To be asked after a solve() only.
  const latin::Iterate& state() const {
    assert(state_ != nullptr && "nothing has been solved");
    return *state_;
  }
  /// Column of state() that holds a coefficient; load step and polynomial from 0.
  int column(int step, int term) const { return step * projection_->terms() + term; }
  /// The delivered state [stress]: the rows of the layout for every polynomial below each other, x load steps.
  const base::Matrix& alpha() const { return alpha_; }
  /// Collective. The responses of the delivered state as functions of the germs.
  ResponseSampler sampler() const { return {assembly_, state(), projection_, responses_}; }

 private:
  /// While a thread is inside.
  StochasticSolver(const base::SoleThread& inside, const assembly::Assembly& assembly,
                   std::shared_ptr<const Projection> projection, const StochasticOptions& options,
                   const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers);
  enum class End { reached, stalled, stopped, interrupted };

  void select(int first, int count);
  /// Iterates the load steps first .. first + count - 1.
  End iterate(latin::AndersonAcceleration& acceleration, int first, int count, double tolerance);
  /// Visits all load steps, then takes the quantities that are promised.
  End run(double tolerance, bool isFresh);
  bool mustStop() const;
  int iterations() const;
  void deliver(StochasticResult& result, const std::vector<double>& estimates);

  const assembly::Assembly& assembly_;
  std::shared_ptr<const Projection> projection_;
  StochasticOptions options_;
  assembly::Assembly modal_;
  ChaosLocalStage* local_ = nullptr;  // of fixedPoint_
  latin::FixedPoint fixedPoint_;
  latin::StateMetric metric_;  // of states with all polynomials
  std::vector<std::shared_ptr<const latin::Response>> responses_;
  std::vector<std::function<void(const latin::IterationReport&)>> observers_;
  std::function<bool()> interrupted_;
  std::vector<latin::AndersonAcceleration> accelerations_;  // one, or one per load step
  base::Matrix alpha_;
  const latin::Iterate* state_ = nullptr;  // on all modal columns
  std::unique_ptr<ChaosSnapshot> snapshot_;
  double largestForce_ = 0.0;
  long columnsBefore_ = 0;
};

}  // namespace harmos::stochastic
