#pragma once

#include <string>

#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/ResultFiles.hpp>

namespace harmos::files {

/// The results of a run that goes on. They are written aside, in the folder DIR/SCENE.partial.PID, and replace those of
/// an earlier run together when all are complete; without commit() the earlier ones stay.
///
/// The record is not among them: it always tells of the last run, see RunRecord::earlier.
class PendingResults {
 public:
  /// `final`: where the results are to lie in the end. Creates their folder and the one aside, and removes those that
  /// killed processes have left there; throws base::Error when it cannot. For one process.
  explicit PendingResults(ResultFiles final);
  /// Removes the folder aside with what is left in it.
  ~PendingResults();
  PendingResults(const PendingResults&) = delete;
  PendingResults& operator=(const PendingResults&) = delete;

  /// Where to write, but for the record.
  const ResultFiles& files() const { return aside_; }
  /// Moves the results to where they belong; hasFields: those of parts and interfaces are among them, or else those of
  /// an earlier run are removed. Throws base::Error when one of them was not written or cannot be moved or removed, or
  /// when the folder of the results is gone.
  void commit(bool hasFields = true) const;

 private:
  ResultFiles final_;
  Unfinished folder_;
  ResultFiles aside_;
  int lock_ = -1;  // descriptor of the folder, which tells others that this process lives
};

}  // namespace harmos::files
