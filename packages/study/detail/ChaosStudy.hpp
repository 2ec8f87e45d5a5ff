#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/base/Timers.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/results/StochasticSummary.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/stochastic/StochasticSolver.hpp>
#include <harmos/study/ChaosCost.hpp>
#include <harmos/study/StochasticTails.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::study {

/// Solves the expansions that a study of the type Chaos asks for: one order or as many as its tolerance wants, then the
/// sweep. All calls are collective over the communicator.
class ChaosStudy {
 public:
  /// Builds mesh and bodies and chooses the local stage. All arguments must outlive it. Throws as makeProblem() and
  /// demandMemory(), and base::Error (input) where a law cannot act at its places with values that are needed.
  ChaosStudy(const Study& study, const laws::LawRegistry& laws, Teuchos::RCP<const Teuchos::Comm<int>> comm,
             base::Timers& timers);

  ChaosStudy(const ChaosStudy&) = delete;
  ChaosStudy& operator=(const ChaosStudy&) = delete;

  void setInterrupt(std::function<bool()> interrupted) { interrupted_ = std::move(interrupted); }
  /// Told what has been solved, one sentence at a time.
  void setObserver(std::function<void(const std::string&)> observer) { observer_ = std::move(observer); }

  /// Throws base::Error (input) when a law is not fit for Galerkin's local stage.
  latin::Outcome solve();
  /// Whether there are expansions, though perhaps not all that was asked for.
  bool isSolved() const { return result_.outcome == latin::Outcome::certified; }
  /// What ended solve().
  const std::string& reason() const { return reason_; }

  /// Of the last order that was solved: sample of every response of the study at points of germs, [response][point];
  /// nothing is solved.
  std::vector<std::vector<double>> sample(const std::vector<std::vector<double>>& germs) const;
  /// Expansions, moments by order, and the sweep. `summary` holds the rest.
  void summarise(results::StochasticSummary& summary) const;

  const scene::Problem& problem() const { return problem_; }
  const stochastic::StochasticSolver& solver() const { return *solver_; }
  const probability::Basis& basis() const { return *projection_->basis(); }
  /// Columns of the linear stage that were solved in all.
  long columns() const { return columns_; }
  bool isGalerkin() const { return isGalerkin_; }
  /// How laws meet the expansions, what that takes, and why.
  const ChaosChoice& choice() const { return choice_; }

 private:
  void start(int order);
  latin::Outcome run(const base::Matrix* start);
  stochastic::Realisations realise(const probability::RandomVector& variables) const;
  latin::Outcome raiseOrder();
  /// Whether random laws look at where they act, see scene::demandPlaces().
  bool demandsPlaces() const;
  Demand demandOfPlaces() const;
  /// Whether the scene allows the values that an expansion of this order needs.
  bool admits(int order) const;
  latin::Outcome sweep();
  std::vector<probability::Expansion> expansions() const;
  results::StochasticSummary::Order momentsAt(int order) const;

  const Study& study_;
  const ChaosOptions& options_;
  const laws::LawRegistry& laws_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  base::Timers& timers_;
  scene::Scene scene_;
  scene::Problem problem_;
  std::vector<bool> isRandom_;  // by interface
  ChaosChoice choice_;
  bool isGalerkin_;
  std::function<bool()> interrupted_;
  std::function<void(const std::string&)> observer_;

  std::shared_ptr<const stochastic::Projection> projection_;
  std::unique_ptr<stochastic::StochasticSolver> solver_;
  stochastic::StochasticResult result_;
  std::vector<probability::Expansion> expansions_;
  std::vector<results::StochasticSummary::Order> orders_;
  std::vector<results::StochasticSummary::Point> points_;
  long columns_ = 0;
  std::string reason_;
};

}  // namespace harmos::study
