#include <harmos/study/StudyGroup.hpp>

#include <algorithm>
#include <cassert>
#include <iomanip>
#include <map>
#include <sstream>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/results/StatusName.hpp>
#include <harmos/scene/LawParameters.hpp>
#include <harmos/scene/MeshError.hpp>

namespace harmos::study {

namespace {

/// Lets only the result of one configuration through.
class OnlyOne : public results::ResultSink {
 public:
  OnlyOne(int id, results::ResultSink& sink) : id_(id), sink_(sink) {}
  void record(const results::ConfigurationResult& result) override {
    if (result.id == id_) sink_.record(result);
  }

 private:
  int id_;
  results::ResultSink& sink_;
};

/// Adds to results what is known of the error of the mesh.
class WithMeshErrors : public results::ResultSink {
 public:
  WithMeshErrors(const MeshErrorSample* sample, results::ResultSink& sink) : sample_(sample), sink_(sink) {}
  void record(const results::ConfigurationResult& result) override {
    results::ConfigurationResult whole = result;
    if (sample_ && results::isSolved(result.status)) whole.meshErrors = sample_->errorsOf(result.id);
    sink_.record(whole);
  }
  void note(const std::string& name, const results::Note& note) override { sink_.note(name, note); }

 private:
  const MeshErrorSample* sample_;
  results::ResultSink& sink_;
};

/// What the report says of the estimates of a study.
void noteTrust(const parametric::Trust& summary, results::ResultSink& sink) {
  std::ostringstream text;
  text << std::setprecision(2);
  if (summary.calibrations > 0) {
    const std::vector<double>& ofResponses = summary.ratios.responses;
    const double least = ofResponses.empty() ? 1.0 : *std::min_element(ofResponses.begin(), ofResponses.end());
    text << summary.calibrations << " configurations solved tightly; ratio of indicator to error at least "
         << summary.ratios.force << " (forces) and " << least << " (responses); " << summary.reopened
         << " taken up again";
    sink.note("calibration of the error estimate", {text.str()});
    text.str("");
  }
  if (summary.audits + summary.openAudits > 0) {
    text << summary.falseClaims << " of " << summary.audits
         << " random configurations had a larger error than accepted, "
         << "the largest " << summary.largestAudit << " of what was asked for; false claims at most "
         << 100.0 * summary.falseClaimBound << " % at 95 % confidence";
    if (summary.openAudits > 0) text << "; " << summary.openAudits << " more audits came to no end";
    sink.note("audit of the error estimate", {text.str(), summary.falseClaims > 0});
  }
}

scene::Scene firstAdmissible(const Study& study, const std::vector<design::Configuration>& configurations,
                             const laws::LawRegistry& laws) {
  assert(!configurations.empty());
  for (std::size_t i = 0;; ++i) {
    try {
      return study.sceneFor(configurations[i].values, laws);
    } catch (const base::Error& error) {
      if (error.code() != base::ExitCode::input || i + 1 == configurations.size()) throw;
    }
  }
}

/// Of the first admissible configuration, or where its laws cannot act on the mesh, of the last or the one in the
/// middle; the error is that of the first.
std::pair<scene::Scene, scene::Problem> firstPossible(const Study& study,
                                                      const std::vector<design::Configuration>& configurations,
                                                      const laws::LawRegistry& laws,
                                                      const std::function<scene::Problem(const scene::Scene&)>& make) {
  scene::Scene first = firstAdmissible(study, configurations, laws);
  try {
    scene::Problem problem = make(first);
    return {std::move(first), std::move(problem)};
  } catch (const base::Error& error) {
    if (error.code() != base::ExitCode::input) throw;
    for (const std::size_t i : {configurations.size() - 1, configurations.size() / 2}) {
      try {
        scene::Scene other = study.sceneFor(configurations[i].values, laws);
        scene::Problem problem = make(other);
        return {std::move(other), std::move(problem)};
      } catch (const base::Error& again) {
        if (again.code() != base::ExitCode::input) throw;
      }
    }
    throw;
  }
}

}  // namespace

StudyGroup::StudyGroup(const Study& study, const laws::LawRegistry& laws, Teuchos::RCP<const Teuchos::Comm<int>> comm,
                       base::Timers& timers, std::pair<scene::Scene, scene::Problem> made)
    : study_(study),
      laws_(laws),
      comm_(std::move(comm)),
      timers_(timers),
      scene_(std::move(made.first)),
      problem_(std::move(made.second)) {}

StudyGroup::StudyGroup(const Study& study, const std::vector<design::Configuration>& configurations,
                       const laws::LawRegistry& laws, Teuchos::RCP<const Teuchos::Comm<int>> comm, base::Timers& timers)
    : StudyGroup(study, laws, comm, timers, firstPossible(study, configurations, laws, [&](const scene::Scene& scene) {
                   return scene::makeProblem(scene, *comm, timers);
                 })) {}

StudyGroup::StudyGroup(const Study& study, const std::vector<design::Configuration>& configurations,
                       const laws::LawRegistry& laws, Teuchos::RCP<const Teuchos::Comm<int>> comm, base::Timers& timers,
                       const scene::Problem& made)
    : StudyGroup(study, laws, std::move(comm), timers,
                 firstPossible(study, configurations, laws, [&](const scene::Scene& scene) {
                   scene::Problem problem = made;
                   scene::useLaws(scene, problem.assembly);
                   return problem;
                 })) {}

void StudyGroup::solve(const std::vector<design::Configuration>& configurations, results::ResultSink& sink) {
  if (configurations.empty()) return;
  if (!engine_) {
    engine_ = makeEngine(configurations.size());
    engine_->resume(std::exchange(earlier_, {}));
  }
  WithMeshErrors whole(sample_, sink);
  engine_->run(configurations, whole);
  noteTrust(engine_->summary(), sink);
  if (sample_) sample_->report(sink);
}

void StudyGroup::solveAlone(const design::Configuration& configuration, results::ResultSink& sink) {
  WithMeshErrors whole(sample_, sink);
  makeEngine(1)->run({configuration}, whole);
}

void StudyGroup::walk(const design::Configuration& from, const design::Configuration& to, int steps,
                      results::ResultSink& sink) {
  std::vector<design::Configuration> path = {from};
  for (int step = 1; step < steps; ++step) {
    design::Configuration between;
    between.id = -step;  // of no row
    for (std::size_t p = 0; p < from.values.size(); ++p) {
      between.values.push_back(from.values[p] + (to.values[p] - from.values[p]) * step / steps);
    }
    path.push_back(std::move(between));
  }
  path.push_back(to);
  WithMeshErrors whole(sample_, sink);
  OnlyOne last(to.id, whole);
  makeEngine(path.size())->run(path, last);
}

std::unique_ptr<parametric::ParametricStudy> StudyGroup::makeEngine(std::size_t configurations) {
  auto engine = std::make_unique<parametric::ParametricStudy>(
      problem_.assembly, [this](const std::vector<double>& values) { install(values); }, problem_.responses,
      parametric::optionsForStudy(scene_.solver, configurations, problem_.assembly.steps()), comm_, timers_);
  if (interrupted_) engine->setInterrupt(interrupted_);
  engine->setWidestBatch(study_.sideBySide);
  if (sample_ && scene_.wantsMeshErrors && scene_.solver.stages.formulation == latin::Formulation::displacement) {
    engine->setObserver([this](const design::Configuration& configuration, latin::FixedPoint& fixedPoint,
                               const latin::Iterate& state) { estimateMeshErrors(configuration, fixedPoint, state); });
  }
  return engine;
}

void StudyGroup::estimateMeshErrors(const design::Configuration& configuration, latin::FixedPoint& fixedPoint,
                                    const latin::Iterate& state) {
  if (!sample_->wants(configuration)) return;
  const auto estimating = timers_.start("mesh error");
  std::vector<std::shared_ptr<const latin::Response>> responses;
  for (const std::size_t curve : sample_->curves()) responses.push_back(problem_.responses[curve]);
  std::vector<results::MeshErrorRecord> errors;
  for (const auto& error : scene::estimateMeshErrors(problem_, fixedPoint, state, responses, *comm_).responses) {
    errors.push_back(scene::recordOf(error));
  }
  sample_->add(configuration, std::move(errors));
}

void StudyGroup::install(const std::vector<double>& values) {
  const auto installing = timers_.start("laws");
  scene::useLaws(study_.sceneFor(values, laws_), problem_.assembly);
}

std::vector<std::vector<design::Configuration>> groupByOperators(
    const std::vector<StudyParameter>& parameters, const std::vector<design::Configuration>& configurations) {
  std::vector<std::vector<design::Configuration>> groups;
  std::map<std::vector<double>, std::size_t> places;
  for (const design::Configuration& configuration : configurations) {
    std::vector<double> key;
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      if (parameters[p].effect == Effect::Kind::operators) key.push_back(configuration.values[p]);
    }
    const auto [place, isNew] = places.emplace(key, groups.size());
    if (isNew) groups.emplace_back();
    groups[place->second].push_back(configuration);
  }
  return groups;
}

}  // namespace harmos::study
