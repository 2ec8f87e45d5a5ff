#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/base/Timers.hpp>
#include <harmos/latin/LatinOptions.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/parametric/ParametricStudy.hpp>
#include <harmos/scene/Problem.hpp>
#include <harmos/study/FailurePolicy.hpp>
#include <harmos/study/MeshErrorSample.hpp>
#include <harmos/study/Study.hpp>

namespace harmos::study {

/// The configurations of a study that share mesh, bodies and factors.
///
/// All calls are collective over the communicator. The factors are made by the first solve() and kept; solveAlone() and
/// walk() make their own.
class StudyGroup {
 public:
  /// Builds mesh and bodies for the first of `configurations` whose values are admissible, or for the last or the
  /// middle one where its laws cannot act on the mesh. The study, the laws and the timers must outlive it. Throws
  /// base::Error (input) when none is, and as makeProblem() does.
  StudyGroup(const Study& study, const std::vector<design::Configuration>& configurations,
             const laws::LawRegistry& laws, Teuchos::RCP<const Teuchos::Comm<int>> comm, base::Timers& timers);
  /// The same with a problem that is made already, for the same communicator; it is copied, its matrices are shared.
  StudyGroup(const Study& study, const std::vector<design::Configuration>& configurations,
             const laws::LawRegistry& laws, Teuchos::RCP<const Teuchos::Comm<int>> comm, base::Timers& timers,
             const scene::Problem& made);

  StudyGroup(const StudyGroup&) = delete;
  StudyGroup& operator=(const StudyGroup&) = delete;

  /// Asked on every rank between iterations; true on any rank ends the call. To be set before the first solve(), which
  /// keeps it.
  void setInterrupt(std::function<bool()> interrupted) { interrupted_ = std::move(interrupted); }
  /// Asked whether the error of the mesh is to be estimated at a solution, and told what came of it, which the results
  /// hold as well; must outlive the group. To be set before the first solve(); without it nothing is estimated.
  void setMeshErrorSample(MeshErrorSample& sample) { sample_ = &sample; }
  /// What another run of the study has found of configurations with these operators. To be set before the first
  /// solve().
  void setEarlier(std::vector<parametric::EarlierResult> earlier) { earlier_ = std::move(earlier); }
  /// Solves configurations that share the operators; there may be none. What is solved serves later calls. Throws
  /// base::Error when an operator cannot be factored; what fails in one configuration is its result.
  void solve(const std::vector<design::Configuration>& configurations, results::ResultSink& sink);
  /// Solves one configuration by itself, from a cold start.
  void solveAlone(const design::Configuration& configuration, results::ResultSink& sink);
  /// Walks to a configuration from another one in `steps` equal steps, >= 1; only its own result reaches the sink.
  void walk(const design::Configuration& from, const design::Configuration& to, int steps, results::ResultSink& sink);

 private:
  StudyGroup(const Study& study, const laws::LawRegistry& laws, Teuchos::RCP<const Teuchos::Comm<int>> comm,
             base::Timers& timers, std::pair<scene::Scene, scene::Problem> made);

  std::unique_ptr<parametric::ParametricStudy> makeEngine(std::size_t configurations);
  void install(const std::vector<double>& values);
  void estimateMeshErrors(const design::Configuration& configuration, latin::FixedPoint& fixedPoint,
                          const latin::Iterate& state);

  const Study& study_;
  const laws::LawRegistry& laws_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  base::Timers& timers_;
  std::function<bool()> interrupted_;
  MeshErrorSample* sample_ = nullptr;
  std::vector<parametric::EarlierResult> earlier_;
  scene::Scene scene_;
  scene::Problem problem_;
  std::unique_ptr<parametric::ParametricStudy> engine_;  // keeps factors and solutions between calls of solve()
};

/// Splits configurations into those that share operators, in the order of their first; one group when no parameter
/// changes any. Compares values of parameters exactly.
std::vector<std::vector<design::Configuration>> groupByOperators(
    const std::vector<StudyParameter>& parameters, const std::vector<design::Configuration>& configurations);

}  // namespace harmos::study
