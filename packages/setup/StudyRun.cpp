#include <harmos/setup/StudyRun.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/setup/FailurePolicy.hpp>
#include <harmos/setup/StudyDesign.hpp>
#include <harmos/setup/StudyGroup.hpp>
#include <harmos/setup/StudyIdentity.hpp>
#include <harmos/study/StatusName.hpp>

namespace harmos::setup {

namespace {

using study::Configuration;
using study::ConfigurationResult;

void broadcast(std::string& text, const Teuchos::Comm<int>& comm) {
  int length = static_cast<int>(text.size());
  Teuchos::broadcast(comm, 0, Teuchos::outArg(length));
  text.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast(comm, 0, length, text.data());
}

void forEachLine(const std::string& text, const std::function<void(const std::string&)>& action) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    action(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

/// Opens the files on rank 0; all ranks learn the results of an earlier run, or throw the same error.
std::unique_ptr<output::StudyWriter> openFiles(const output::StudyFiles& files,
                                               const output::StudyDescription& description, bool restart,
                                               output::StudyResults& results, const Teuchos::Comm<int>& comm) {
  std::unique_ptr<output::StudyWriter> writer;
  std::string error, added, lines;
  int code = 0;
  if (comm.getRank() == 0) {
    try {
      writer = std::make_unique<output::StudyWriter>(files, description, restart);
      const auto& all = writer->results().configurations();
      for (std::size_t i = description.configurations.size(); i < all.size(); ++i) {
        added += output::configurationToJson(all[i]) + "\n";
      }
      for (const ConfigurationResult& result : writer->results().all()) lines += output::resultToJson(result) + "\n";
    } catch (const base::Error& failure) {
      error = failure.what();
      code = static_cast<int>(failure.code());
    }
  }
  broadcast(error, comm);
  Teuchos::broadcast(comm, 0, Teuchos::outArg(code));
  if (!error.empty()) throw base::Error(error, static_cast<base::ExitCode>(code));
  broadcast(added, comm);
  broadcast(lines, comm);
  forEachLine(added, [&](const std::string& line) { results.add(output::configurationFromJson(line)); });
  forEachLine(lines, [&](const std::string& line) { results.set(output::resultFromJson(line)); });
  return writer;
}

/// Keeps what comes on every rank and writes it on rank 0.
class Recorder : public study::ResultSink {
 public:
  Recorder(output::StudyResults& results, output::StudyWriter* writer, const StudyRunRequest& request, bool aborts)
      : results_(results), writer_(writer), request_(request), aborts_(aborts) {}

  void record(const ConfigurationResult& result) override {
    results_.set(result);
    write([&] { writer_->record(result); });
    if (aborts_ && mayBeHelped(result)) isAborted_ = true;
    if (request_.observer) request_.observer(results_);
  }
  void note(const std::string& name, const std::string& text) override {
    results_.note(name, text);
    write([&] { writer_->note(name, text); });
  }
  void add(const Configuration& configuration) {
    results_.add(configuration);
    write([&] { writer_->add(configuration); });
  }
  /// Results could not be written, which is no fault of a configuration.
  bool cannotWrite() const { return cannotWrite_; }
  bool isAborted() const { return isAborted_; }
  bool mustStop() const { return isAborted_ || (request_.interrupted && request_.interrupted()); }
  const output::StudyResults& results() const { return results_; }

 private:
  void write(const std::function<void()>& action) {
    if (!writer_) return;
    cannotWrite_ = true;
    action();
    cannotWrite_ = false;
  }

  output::StudyResults& results_;
  output::StudyWriter* writer_;
  bool cannotWrite_ = false;
  const StudyRunRequest& request_;
  bool aborts_;
  bool isAborted_ = false;
};

/// Passes a solution on; of a further failure only the reason is added to that of the first.
class SecondChance : public study::ResultSink {
 public:
  SecondChance(ConfigurationResult first, std::string what, study::ResultSink& sink)
      : first_(std::move(first)), what_(std::move(what)), sink_(sink) {}

  void record(const ConfigurationResult& result) override {
    isSolved_ = study::isSolved(result.status);
    ConfigurationResult sum = isSolved_ ? result : first_;
    sum.reason = isSolved_ ? result.reason + " (" + what_ + ")" : first_.reason + " " + what_ + ": " + result.reason;
    sum.iterations = first_.iterations + result.iterations;
    sum.linearStages = first_.linearStages + result.linearStages;
    sum.cpuSeconds = first_.cpuSeconds + result.cpuSeconds;
    first_ = sum;
    sink_.record(sum);
  }
  bool isSolved() const { return isSolved_; }

 private:
  ConfigurationResult first_;
  std::string what_;
  study::ResultSink& sink_;
  bool isSolved_ = false;
};

/// Solves the groups of a study one after the other and helps what fails.
class Runner {
 public:
  Runner(const Study& study, const laws::LawRegistry& laws, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
         Recorder& recorder)
      : study_(study), laws_(laws), comm_(comm), recorder_(recorder), policy_(study.input) {}

  /// `ready`: the only group, if it has been made already.
  void run(std::unique_ptr<StudyGroup> ready, base::Timers& timers) {
    if (ready) {
      for (std::size_t i = study_.configurations.size(); i < recorder_.results().configurations().size(); ++i) {
        ready->add(recorder_.results().configurations()[i]);
      }
      solve(*ready);
      if (study_.isAdaptive()) refine(*ready);
      return;
    }
    for (const auto& configurations : groupByOperators(study_)) {
      const bool isOpen = std::any_of(configurations.begin(), configurations.end(),
                                      [&](const Configuration& c) { return needsWork(c.id); });
      if (mustStop()) return;
      if (!isOpen) continue;
      try {
        StudyGroup group(study_, configurations, laws_, comm_, timers);
        solve(group);
      } catch (const base::Error& error) {
        if (error.code() != base::ExitCode::input) throw;
        for (const Configuration& configuration : configurations) {
          if (!recorder_.results().find(configuration.id)) recordFailure(configuration, error);
        }
      }
    }
  }

  /// The same answer on every rank.
  bool mustStop() const {
    const int mine = recorder_.mustStop() ? 1 : 0;
    int any = mine;
    Teuchos::reduceAll(*comm_, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(any));
    return any != 0;
  }

 private:
  bool needsWork(int id) const {
    const ConfigurationResult* result = recorder_.results().find(id);
    return !result || mayBeHelped(*result);
  }

  void recordFailure(const Configuration& configuration, const base::Error& error) {
    ConfigurationResult result;
    result.id = configuration.id;
    result.status = error.code() == base::ExitCode::input ? study::Status::inadmissible : study::Status::failed;
    result.reason = error.what();
    result.errorEstimate = std::numeric_limits<double>::quiet_NaN();
    recorder_.record(result);
  }

  void solve(StudyGroup& group) {
    group.setInterrupt([this] { return recorder_.mustStop(); });
    std::vector<ConfigurationResult> done = recorder_.results().all();
    if (policy_.kind == FailurePolicy::Kind::abort) {
      done.erase(std::remove_if(done.begin(), done.end(), mayBeHelped), done.end());
    }
    try {
      group.solve(done, recorder_);
    } catch (const base::Error& error) {
      // An operator that cannot be factored, on one rank perhaps: the others wait for it.
      if (comm_->getSize() > 1 && error.code() != base::ExitCode::input) throw;
      if (recorder_.cannotWrite()) throw;
      for (const Configuration& configuration : group.configurations()) {
        if (!recorder_.results().find(configuration.id)) recordFailure(configuration, error);
      }
      return;
    }
    for (const Configuration& configuration : group.configurations()) {
      if (mustStop()) return;
      const ConfigurationResult* result = recorder_.results().find(configuration.id);
      if (!result || !mayBeHelped(*result)) continue;
      if (policy_.kind == FailurePolicy::Kind::retry) retry(group, configuration, *result);
      if (policy_.kind == FailurePolicy::Kind::continuation) walkTo(group, configuration, *result);
    }
  }

  void refine(StudyGroup& group) {
    const base::Parameters& design = study_.input.list("Design");
    study::Refinement refinement(study_.plan->axes(), refinementOptions(design),
                                 [this](const auto& point) { return study_.plan->complete(point).has_value(); });
    const auto& names = recorder_.results().description().responses;
    const auto response = std::find_if(names.begin(), names.end(),
                                       [&](const auto& each) { return each.name == design.text("Response"); });
    while (!mustStop()) {
      std::vector<std::vector<double>> points;
      std::vector<double> values;
      for (const Configuration& configuration : recorder_.results().configurations()) {
        auto& point = points.emplace_back();
        for (std::size_t p = 0; p < study_.parameters.size(); ++p) {
          if (study_.parameters[p].formula.empty()) point.push_back(configuration.values[p]);
        }
        const ConfigurationResult* result = recorder_.results().find(configuration.id);
        const bool isSolved = result && study::isSolved(result->status);
        values.push_back(isSolved ? recorder_.results().responses(
                                        configuration.id)[static_cast<std::size_t>(response - names.begin())]
                                  : std::numeric_limits<double>::quiet_NaN());
      }
      const auto batch = refinement.next(points, values, recorder_.results().description().accuracy);
      recorder_.note("surface of " + response->name,
                     (refinement.isReached() ? "reached: " : "not reached: ") + refinement.summary());
      if (batch.empty()) return;
      for (const auto& point : batch) {
        const int id = static_cast<int>(recorder_.results().configurations().size()) + 1;
        recorder_.add({id, *study_.plan->complete(point)});
        group.add(recorder_.results().configurations().back());
      }
      solve(group);
    }
  }

  void retry(StudyGroup& group, const Configuration& configuration, const ConfigurationResult& result) {
    SecondChance chance(result, "Again from a cold start", recorder_);
    for (int attempt = 0; attempt < policy_.attempts && !chance.isSolved() && !mustStop(); ++attempt) {
      group.solveAlone(configuration, chance);
    }
  }

  void walkTo(StudyGroup& group, const Configuration& configuration, const ConfigurationResult& result) {
    const Configuration* from = nearestSolved(group, configuration);
    if (!from) return;
    SecondChance chance(result, "Walked to from configuration " + std::to_string(from->id), recorder_);
    for (int steps = 2; steps <= policy_.steps && !chance.isSolved() && !mustStop(); steps *= 2) {
      group.walk(*from, configuration, steps, chance);
    }
  }

  /// Null when none is solved. Distances are measured in units of the parameters' ranges.
  const Configuration* nearestSolved(const StudyGroup& group, const Configuration& configuration) const {
    const Configuration* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Configuration& other : group.configurations()) {
      const ConfigurationResult* result = recorder_.results().find(other.id);
      if (!result || !study::isSolved(result->status)) continue;
      double square = 0.0;
      for (std::size_t p = 0; p < other.values.size(); ++p) {
        const auto [low, high] = std::minmax_element(
            group.configurations().begin(), group.configurations().end(),
            [p](const Configuration& a, const Configuration& b) { return a.values[p] < b.values[p]; });
        const double range = high->values[p] - low->values[p];
        if (range > 0.0) square += std::pow((other.values[p] - configuration.values[p]) / range, 2);
      }
      if (square < least) {
        least = square;
        nearest = &other;
      }
    }
    return nearest;
  }

  const Study& study_;
  const laws::LawRegistry& laws_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  Recorder& recorder_;
  FailurePolicy policy_;
};

int exitCodeOf(const output::StudyResults& results) {
  const auto count = [&](study::Status status) { return results.count(status); };
  const int solved = count(study::Status::certified) + count(study::Status::calibrated);
  const int unbalanced = count(study::Status::noEquilibrium);
  if (solved == results.count()) return static_cast<int>(base::ExitCode::ok);
  return static_cast<int>(solved + unbalanced == results.count() ? base::ExitCode::noEquilibrium
                                                                 : base::ExitCode::notConverged);
}

}  // namespace

StudyRunResult runStudy(const StudyRunRequest& request, const laws::LawRegistry& laws,
                        const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  base::Timers timers;
  StudyRunResult run{
      std::make_unique<const Study>(readStudy(request.study, request.overrides, request.pointsFile, laws)),
      {},
      {},
      output::StudyFiles(request.directory, request.study),
      "",
      0};
  const Study& study = *run.study;
  run.description = std::make_unique<const output::StudyDescription>(describe(study));
  run.results = std::make_unique<output::StudyResults>(*run.description);

  // What is wrong with the mesh is known before anything is written.
  const auto groups = groupByOperators(study);
  std::unique_ptr<StudyGroup> onlyGroup;
  if (groups.size() == 1) {
    onlyGroup = std::make_unique<StudyGroup>(study, groups.front(), laws, comm, timers);
  } else {
    makeProblem(study.scene, *comm, timers);
  }
  const auto writer = openFiles(run.files, *run.description, request.restart, *run.results, *comm);
  if (request.started) request.started(study, *run.results, writer ? writer->damaged() : 0);

  const FailurePolicy policy(study.input);
  Recorder recorder(*run.results, writer.get(), request, policy.kind == FailurePolicy::Kind::abort);
  Runner runner(study, laws, comm, recorder);
  try {
    runner.run(std::move(onlyGroup), timers);
  } catch (...) {
    if (writer) writer->finish("interrupted");
    throw;
  }
  const bool isStopped = runner.mustStop();
  run.state = recorder.isAborted() ? "aborted" : isStopped ? "interrupted" : "complete";
  if (writer) writer->finish(run.state);
  run.exitCode = exitCodeOf(*run.results);
  if (recorder.isAborted()) run.exitCode = static_cast<int>(base::ExitCode::failure);
  if (!recorder.isAborted() && isStopped) run.exitCode = 130;
  return run;
}

}  // namespace harmos::setup
