#include <harmos/study/StudyGroup.hpp>

#include <cassert>
#include <iomanip>
#include <map>
#include <sstream>

#include <harmos/base/Error.hpp>

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

/// What the report says of the estimates of a study.
void noteTrust(const parametric::Trust& summary, results::ResultSink& sink) {
  std::ostringstream text;
  text << std::setprecision(2);
  if (summary.calibrations > 0) {
    text << summary.calibrations << " configurations solved tightly; ratio of indicator to error at least "
         << summary.forceRatio << " (forces) and " << summary.responseRatio << " (responses); " << summary.reopened
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

}  // namespace

StudyGroup::StudyGroup(const Study& study, const std::vector<design::Configuration>& configurations,
                       const laws::LawRegistry& laws, Teuchos::RCP<const Teuchos::Comm<int>> comm, base::Timers& timers)
    : study_(study),
      laws_(laws),
      comm_(std::move(comm)),
      timers_(timers),
      scene_(firstAdmissible(study, configurations, laws)),
      problem_(scene::makeProblem(scene_, *comm_, timers)) {}

StudyGroup::StudyGroup(const Study& study, const std::vector<design::Configuration>& configurations,
                       const laws::LawRegistry& laws, Teuchos::RCP<const Teuchos::Comm<int>> comm, base::Timers& timers,
                       const scene::Problem& made)
    : study_(study),
      laws_(laws),
      comm_(std::move(comm)),
      timers_(timers),
      scene_(firstAdmissible(study, configurations, laws)),
      problem_(made) {
  useLawsOf(scene_);
}

void StudyGroup::solve(const std::vector<design::Configuration>& configurations, results::ResultSink& sink) {
  if (configurations.empty()) return;
  if (!engine_) engine_ = makeEngine(configurations.size());
  engine_->run(configurations, sink);
  noteTrust(engine_->summary(), sink);
}

void StudyGroup::solveAlone(const design::Configuration& configuration, results::ResultSink& sink) {
  makeEngine(1)->run({configuration}, sink);
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
  OnlyOne last(to.id, sink);
  makeEngine(path.size())->run(path, last);
}

std::unique_ptr<parametric::ParametricStudy> StudyGroup::makeEngine(std::size_t configurations) {
  auto engine = std::make_unique<parametric::ParametricStudy>(
      problem_.assembly, [this](const std::vector<double>& values) { install(values); }, problem_.responses,
      parametric::optionsForStudy(scene_.solver, configurations), comm_, timers_);
  if (interrupted_) engine->setInterrupt(interrupted_);
  return engine;
}

void StudyGroup::install(const std::vector<double>& values) {
  const auto installing = timers_.start("laws");
  useLawsOf(study_.sceneFor(values, laws_));
}

void StudyGroup::useLawsOf(const scene::Scene& scene) {
  for (assembly::Interface& interface : problem_.assembly.interfaces) {
    const auto law = scene.laws.find(interface.name);
    if (law != scene.laws.end()) interface.law = law->second;  // else a cut through a part, which no parameter changes
  }
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
