#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <harmos/base/Timers.hpp>
#include <harmos/files/ResultFiles.hpp>
#include <harmos/files/SolutionRecord.hpp>
#include <harmos/results/MeshErrorRecord.hpp>

namespace harmos::files {

/// What a response may be at every load step, in its unit; infinite where there is no end.
struct RecordedRange {
  std::string response;              // its name
  std::vector<double> lower, upper;  // per load step
};

/// How a run went; what SCENE_result.json says.
struct RunRecord {
  std::string scene;  // path as given
  std::string units;  // length, force, time of all numbers, as the scene declares them; empty: it does not
  /// running, certified, "certified, not unique", not converged, no equilibrium, interrupted, failed
  std::string status;
  std::string reason;                // why it stopped, one sentence
  std::vector<std::string> remarks;  // on what the solution does not determine, one sentence each
  std::optional<int> exitCode;       // of the process, see base::ExitCode; 130: interrupted; nothing while it runs
  double accuracy = 0.0;             // relative error that was asked for
  double roundOffEstimate = 0.0;     // relative, what round-off takes of it at most; 0: far below the accuracy
  double errorEstimate = std::numeric_limits<double>::quiet_NaN();  // relative, of the whole solution; NaN: none
  std::vector<std::pair<std::string, double>> responseErrors;       // relative estimate per response and field
  std::vector<std::pair<std::string, double>> responseSizes;        // what these are relative to, in their units
  std::vector<RecordedRange> responseRanges;                        // of those that the problem does not determine
  std::vector<results::MeshErrorRecord> meshErrors;                 // of responses that have one
  std::vector<std::pair<std::string, double>> meshEnergyShares;     // per part: energy that its mesh does not show
  SolutionRecord solution;                                          // forces, energies, stress and safeties in the end
  int steps = 0, solvedSteps = 0;                                   // load steps, and how many of them are written
  int iterations = 0;                                               // of LATIN
  int linearStages = 0;                                             // whatever for
  int ranks = 1;                                                    // of MPI
  std::vector<base::Timers::Phase> phases;                          // of rank 0
  /// From when the scene had been read, on rank 0 [s].
  double wallSeconds = 0.0, cpuSeconds = 0.0;  // of the whole process on rank 0, all threads [s]
  std::vector<std::string> warnings;           // about the input, a sentence each
  std::string cuts;                            // of parts into pieces that the input leaves open, a sentence; or empty
  std::size_t peakMemory = 0;                  // largest of the ranks [byte]
  /// While there are no results of this run: the JSON of the record of that run whose results still lie beside it;
  /// empty when there are none.
  std::string earlier;
};

/// RunRecord::earlier for a run that is about to replace these results; empty when there are none or their record
/// cannot be read.
std::string earlierRecord(const ResultFiles& files);

/// The record as JSON; numbers that are not finite become null.
std::string toJson(const RunRecord& record);

/// Writes the record as JSON; numbers that are not finite become null. Replaces an older file in one step; throws
/// base::Error when it cannot.
void writeRunRecord(const std::string& path, const RunRecord& record);

}  // namespace harmos::files
