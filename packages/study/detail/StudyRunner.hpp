#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <harmos/base/Error.hpp>
#include <harmos/base/Timers.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/study/FailurePolicy.hpp>
#include <harmos/study/StudyGroup.hpp>
#include <harmos/study/detail/StudyRecorder.hpp>
#include <harmos/study/detail/StudyTeams.hpp>

namespace harmos::study {

/// Solves the configurations that have no solution yet, a range of work at a time, and helps those that fail as the
/// study's failure policy says.
///
/// One team gets all configurations with the same operators at once. Several teams get ranges of the design's order, so
/// that neighbours stay together: large ones at first, small ones at the end, so that all end at about the same time.
class StudyRunner {
 public:
  /// All arguments must outlive it. `interrupted` may be empty.
  StudyRunner(const Study& study, const laws::LawRegistry& laws, StudyTeams& teams, StudyRecorder& recorder,
              std::function<bool()> interrupted, base::Timers& timers);

  /// `ready`: for configurations with the first operators, if it has been made already; else null. Collective over all
  /// ranks.
  void run(std::unique_ptr<StudyGroup> ready);

  /// Collective over all ranks, the same answer on each: whether the failure policy has ended the study; whether it was
  /// ended before all was done, so or by the user.
  bool isAborted() const;
  bool isStopped() const;

 private:
  /// On rank 0 of all: what is handed out next; nothing when none is left.
  std::optional<WorkRange> nextRange();
  void solveRange(const WorkRange& range);
  void solve(const std::vector<design::Configuration>& configurations);
  /// Adds points until the tolerance of an adaptive design is reached.
  void refine();
  /// The same for an interpolation between values of random parameters.
  void refineInterpolation();
  /// Solves points that a design has chosen, as new configurations.
  void solveAdded(const std::vector<std::vector<double>>& points);
  void retry(const design::Configuration& configuration, const results::ConfigurationResult& result);
  void walkTo(const design::Configuration& configuration, const results::ConfigurationResult& result);
  const design::Configuration* nearestSolved(const design::Configuration& configuration) const;
  void recordFailure(const design::Configuration& configuration, const base::Error& error);
  /// Gives the group, at its first solution, what another run has found. One team of ranks gets that.
  void handOn(std::size_t operators);
  bool needsWork(int id) const;
  bool isAbortedHere() const;
  bool mustStopHere();
  /// Collective over the team.
  bool mustStop();

  const Study& study_;
  const laws::LawRegistry& laws_;
  StudyTeams& teams_;
  StudyRecorder& recorder_;
  std::function<bool()> interrupted_;
  base::Timers& timers_;
  const FailurePolicy& policy_;
  std::vector<std::vector<design::Configuration>> open_;         // by operators; the same on every rank
  std::vector<std::vector<parametric::EarlierResult>> earlier_;  // likewise: of another run, until they are handed on
  std::vector<design::Configuration> handedOn_;                  // of these the group has those that were solved
  std::vector<design::Configuration> alike_;                     // all that share the present operators
  MeshErrorSample meshErrors_;
  std::unique_ptr<StudyGroup> group_;
  std::size_t groupNumber_ = 0;
  std::size_t nextOperators_ = 0, nextConfiguration_ = 0;  // rank 0 of all: what is handed out next
};

}  // namespace harmos::study
