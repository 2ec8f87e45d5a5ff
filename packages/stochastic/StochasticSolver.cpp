#include <harmos/stochastic/StochasticSolver.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/assembly/AssemblyCheck.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/latin/Extrapolation.hpp>
#include <harmos/stochastic/detail/ModalAssembly.hpp>

namespace harmos::stochastic {
namespace {

// Residuals below this share of the state are round-off.
constexpr double noise = 1e-12;

/// The columns of a modal assembly are no load steps, at which a boundary could be asked for its law.
latin::StageOptions withoutElimination(latin::StageOptions options) {
  options.elimination = latin::Elimination::none;
  return options;
}

}  // namespace

StochasticSolver::StochasticSolver(const assembly::Assembly& assembly, std::shared_ptr<const Projection> projection,
                                   const StochasticOptions& options, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                                   base::Timers& timers)
    : StochasticSolver(base::SoleThread(comm->getSize()), assembly, std::move(projection), options, comm, timers) {}

StochasticSolver::StochasticSolver(const base::SoleThread& /*inside*/, const assembly::Assembly& assembly,
                                   std::shared_ptr<const Projection> projection, const StochasticOptions& options,
                                   const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers)
    : assembly_(assembly::demandValid(assembly, *comm)),
      projection_(std::move(projection)),
      options_(options),
      modal_(modalAssembly(assembly, projection_)),
      fixedPoint_(modal_, withoutElimination(options.stages), comm, timers,
                  [this](const assembly::SearchDirection& searchDirection, const latin::TraceLayout& layout) {
                    auto stage = std::make_unique<ChaosLocalStage>(modal_, searchDirection, layout, projection_);
                    local_ = stage.get();
                    return stage;
                  }),
      metric_(fixedPoint_.layout(), projection_->terms()),
      alpha_(fixedPoint_.layout().rows() * projection_->terms(), assembly.steps()) {
  if (options.stages.formulation != latin::Formulation::displacement) {
    throw base::Error("random interfaces need the displacement form", base::ExitCode::input);
  }
  local_->setLaws(constantLaws(assembly, *projection_), options_.method);
}

void StochasticSolver::setLaws(const Realisations& laws) {
  stochastic::setLaws(modal_, laws, projection_);
  local_->setLaws(laws, options_.method);
  fixedPoint_.updateLaws();
}

bool StochasticSolver::mustStop() const {
  const int here = interrupted_ && interrupted_() ? 1 : 0;
  int anywhere = 0;
  Teuchos::reduceAll(fixedPoint_.layout().comm(), Teuchos::REDUCE_MAX, here, Teuchos::outArg(anywhere));
  return anywhere != 0;
}

int StochasticSolver::iterations() const {
  return static_cast<int>((fixedPoint_.linearStage().columns() - columnsBefore_) / modal_.steps());
}

void StochasticSolver::select(int first, int count) {
  std::vector<int> columns(count * projection_->terms());
  std::iota(columns.begin(), columns.end(), column(first, 0));
  fixedPoint_.select(columns);
}

StochasticSolver::End StochasticSolver::iterate(latin::AndersonAcceleration& acceleration, int first, int count,
                                                double tolerance) {
  const int rows = fixedPoint_.layout().rows();
  const int columns = count * projection_->terms();
  base::Matrix image(alpha_.numRows(), count);
  // The same numbers, once with a column per load step and once with a column per coefficient.
  base::Matrix state(Teuchos::View, alpha_[first], alpha_.stride(), alpha_.numRows(), count);
  const base::Matrix modalState(Teuchos::View, alpha_[first], rows, rows, columns);
  base::Matrix modalImage(Teuchos::View, image.values(), rows, rows, columns);
  acceleration.resume();
  End end = End::stalled;
  // A load step that is not done by then is left as it is; a tighter run comes back to it.
  for (int iteration = 0; iteration < latin::March::maximumIterations; ++iteration) {
    const latin::Iterate& iterate = fixedPoint_.apply(modalState, modalImage);
    const double force = std::max(largestForce_, fixedPoint_.metric().norm(iterate.hattedTraction()));
    if (metric_.distance(image, state) <= std::max(tolerance * force, noise * metric_.norm(image))) {
      largestForce_ = force;
      end = End::reached;
      break;
    }
    if (mustStop()) return End::interrupted;
    if (iterations() >= options_.maximumIterations) return End::stopped;
    acceleration.advance(state, image);
    if (count == assembly_.steps()) {
      for (const auto& observer : observers_) observer({iterations(), iterations(), 0.0, 0.0, -1});
    }
  }
  state.assign(image);
  return end;
}

StochasticSolver::End StochasticSolver::run(double tolerance, bool isFresh) {
  const int steps = assembly_.steps();
  const int count = local_->hasMemory() ? 1 : steps;
  local_->startUnloaded();
  End end = End::reached;
  for (int first = 0; first < steps && (end == End::reached || end == End::stalled); first += count) {
    if (isFresh && count == 1) latin::extrapolate(alpha_, first, assembly_.times, alpha_[first]);
    select(first, count);
    const End here = iterate(accelerations_[first / count], first, count, tolerance);
    if (here != End::reached) end = here;
    local_->startFromHere();
    if (count == 1) {
      for (const auto& observer : observers_) observer({iterations(), iterations(), 0.0, 0.0, first});
    }
  }
  select(0, steps);
  local_->startUnloaded();
  const int rows = fixedPoint_.layout().rows();
  const base::Matrix modalState(Teuchos::View, alpha_.values(), rows, rows, modal_.steps());
  base::Matrix image(rows, modal_.steps());
  state_ = &fixedPoint_.apply(modalState, image);
  snapshot_ = std::make_unique<ChaosSnapshot>(*state_, sampler(), responses_, projection_->terms());
  return end;
}

StochasticResult StochasticSolver::solve(const base::Matrix* start) {
  const base::SoleThread inside(fixedPoint_.layout().comm().getSize());
  if (start != &alpha_) {
    alpha_.putScalar(0.0);
    if (start != nullptr) alpha_.assign(*start);
  }
  columnsBefore_ = fixedPoint_.linearStage().columns();
  largestForce_ = 0.0;
  const auto blocks = static_cast<std::size_t>(local_->hasMemory() ? assembly_.steps() : 1);
  accelerations_ = std::vector(blocks, latin::AndersonAcceleration(metric_, options_.memory, modal_.isAffine()));

  StochasticResult result;
  std::vector<double> estimates;
  double tolerance = options_.accuracy;
  const auto reach = [&](bool isFresh) {
    End end = run(tolerance, isFresh);
    while (end == End::stalled) end = run(tolerance, false);
    return end;
  };
  End end = reach(start == nullptr);
  while (end == End::reached && tolerance > noise) {
    tolerance *= latin::March::tightening;
    const auto before = std::move(snapshot_);
    end = reach(false);
    if (end != End::reached) break;
    estimates = snapshot_->distance(*before);
    if (*std::max_element(estimates.begin(), estimates.end()) <= options_.accuracy &&
        latin::fieldGap(*state_) <= latin::allowedGap * options_.accuracy) {
      result.outcome = latin::Outcome::certified;
      result.reason = "the error estimate is below the accuracy asked for";
      break;
    }
  }
  if (end == End::interrupted) {
    result.outcome = latin::Outcome::interrupted;
    result.reason = "interrupted";
  }
  deliver(result, estimates);
  return result;
}

void StochasticSolver::deliver(StochasticResult& result, const std::vector<double>& estimates) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < responses_.size(); ++i) {
    result.responses.push_back({responses_[i]->name(), projection_->basis(), snapshot_->response(i),
                                estimates.empty() ? unknown : estimates[i]});
  }
  result.forceErrorEstimate = estimates.empty() ? unknown : estimates[responses_.size()];
  result.displacementErrorEstimate = estimates.empty() ? unknown : estimates[responses_.size() + 1];
  result.errorEstimate = estimates.empty() ? unknown : *std::max_element(estimates.begin(), estimates.end());
  result.columns = fixedPoint_.linearStage().columns() - columnsBefore_;
  result.iterations = iterations();
  if (result.outcome != latin::Outcome::iterationLimit) return;
  if (iterations() < options_.maximumIterations) {
    result.reason = "the residual no longer falls; the estimate stays above the accuracy asked for";
    return;
  }
  latin::Imbalance imbalance = latin::largestImbalance(*state_);
  imbalance.step /= projection_->terms();
  result.reason = "limit of " + std::to_string(options_.maximumIterations) + " iterations; worst coefficient: " +
                  (imbalance.body < 0 ? "none" : latin::describe(imbalance, assembly_));
}

}  // namespace harmos::stochastic
