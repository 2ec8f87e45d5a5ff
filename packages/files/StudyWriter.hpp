#pragma once

#include <chrono>
#include <string>

#include <harmos/files/StochasticTables.hpp>
#include <harmos/files/StudyJournal.hpp>
#include <harmos/results/ResultSink.hpp>
#include <harmos/results/StudyResults.hpp>

/// Files that are read and written: Exodus meshes and fields, tables, records and journals.
namespace harmos::files {

/// Where the results of a study lie: DIR/STUDY.h5 and its companions.
struct StudyFiles {
  /// `study` is the path of the study's file; its name without folder and ending names the results.
  StudyFiles(const std::string& directory, const std::string& study);

  std::string file;            // STUDY.h5
  std::string journal;         // STUDY.journal
  std::string table;           // STUDY.csv
  std::string dakota;          // STUDY_dakota.dat
  StochasticFiles stochastic;  // of studies with random parameters

  /// The tables that appear at the end of a study, whether there are such files or not.
  std::vector<std::string> tables() const;
  /// All of these paths.
  std::vector<std::string> all() const;
};

/// Writes the files of a study as results come. For one process; others learn the results by other ways.
class StudyWriter : public results::ResultSink {
 public:
  /// Opens the journal, see there what it throws, adds the results of an earlier run to `results`, which must outlive
  /// the writer, and writes the HDF5 file. Tables of an earlier run are removed, so that nobody reads them as those of
  /// this one. `restart` forgets the results of an earlier run.
  ///
  /// Throws base::Error (input) when there is an HDF5 file without its journal, unless `restart`; base::Error when an
  /// old table cannot be removed or the HDF5 file cannot be written.
  StudyWriter(const StudyFiles& files, results::StudyResults& results, bool restart);

  /// See StudyJournal::damaged().
  int damaged() const { return journal_.damaged(); }
  /// Appends to the journal, then adds to the results, and brings the HDF5 file up to date every few seconds. Throws
  /// base::Error when journal or HDF5 file cannot be written.
  void record(const results::ConfigurationResult& result) override;
  /// Appends to the journal; throws as record().
  void note(const std::string& name, const results::Note& note) override;
  /// What finish() shall write of a study with random parameters; shared.
  void setStatistics(std::shared_ptr<const results::StochasticSummary> statistics) {
    results_.setStatistics(std::move(statistics));
  }
  /// A configuration that an adaptive design has chosen; its id must be the next one. Throws as record().
  void add(const design::Configuration& configuration);
  /// Writes the HDF5 file and the tables; `state` says how far the study is: complete, interrupted, aborted. Throws
  /// base::Error when it cannot.
  void finish(const std::string& state);

 private:
  void writeFile(const std::string& state);

  StudyFiles files_;
  results::StudyResults& results_;
  StudyJournal journal_;
  std::chrono::steady_clock::time_point nextFile_;
};

}  // namespace harmos::files
