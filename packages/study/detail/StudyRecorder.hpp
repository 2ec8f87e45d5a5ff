#pragma once

#include <functional>
#include <memory>

#include <harmos/files/StudyWriter.hpp>
#include <harmos/results/ResultSink.hpp>
#include <harmos/results/StudyResults.hpp>
#include <harmos/study/detail/StudyTeams.hpp>

namespace harmos::study {

/// Takes the results of a study: every rank keeps those of its own team, rank 0 of all keeps and writes all.
class StudyRecorder : public results::ResultSink {
 public:
  /// Opens the files on rank 0 of all; every rank learns the results of an earlier run. Collective over all ranks;
  /// throws on all of them what files::StudyWriter throws. The others must outlive it.
  StudyRecorder(const files::StudyFiles& files, bool restart, results::StudyResults& results, StudyTeams& teams);

  /// After every result that this rank keeps.
  void setObserver(std::function<void(const results::StudyResults&)> observer) { observer_ = std::move(observer); }

  void record(const results::ConfigurationResult& result) override;
  void note(const std::string& name, const results::Note& note) override;
  /// A configuration that an adaptive design has chosen.
  void add(const design::Configuration& configuration);
  /// What a study with random parameters has come to; written by finish().
  void setStatistics(std::shared_ptr<const results::StochasticSummary> statistics);
  /// What the leader of another team has reported.
  void receive(const std::string& report);
  /// Rank 0 of all: writes the files for the last time.
  void finish(const std::string& state);

  const results::StudyResults& results() const { return results_; }
  /// Whether a configuration has failed or not converged since the files were opened.
  bool hasFailed() const { return hasFailed_; }
  /// Of the journal.
  int damaged() const { return writer_ ? writer_->damaged() : 0; }
  /// Results could not be written, which is no fault of a configuration.
  bool cannotWrite() const { return cannotWrite_; }

 private:
  void write(const std::function<void(files::StudyWriter&)>& action);
  bool isMessenger() const { return teams_.leads() && !teams_.ownsFiles(); }

  results::StudyResults& results_;
  StudyTeams& teams_;
  std::unique_ptr<files::StudyWriter> writer_;  // of rank 0 of all: adds to the results what it has written
  std::function<void(const results::StudyResults&)> observer_;
  bool cannotWrite_ = false;
  bool hasFailed_ = false;
};

}  // namespace harmos::study
