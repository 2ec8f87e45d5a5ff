#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include <harmos/design/Configuration.hpp>
#include <harmos/results/MeshErrorRecord.hpp>
#include <harmos/results/ResultSink.hpp>
#include <harmos/results/StudyResults.hpp>

namespace harmos::study {

/// The few configurations of a study at which the error of the mesh is estimated, and what it is there.
///
/// The mesh is the same for all, or of the same size, so that what it does to a response changes slowly: solved
/// configurations are taken as they come while there are fewer than one in five, and five at most, each at least half a
/// range of some parameter away from all others. The same on all ranks of a team.
class MeshErrorSample {
 public:
  /// Begins with what `results` holds, which must outlive it and tells as well how many configurations there are.
  explicit MeshErrorSample(const results::StudyResults& results);

  /// The scene's responses that the study makes its own of, by position; all where it makes none.
  const std::vector<std::size_t>& curves() const { return curves_; }
  /// At how many of so many configurations it is estimated, at most.
  static std::size_t mostOf(std::size_t configurations);
  /// Whether the error of the mesh should be estimated at this solution; not again at one that is known already.
  bool wants(const design::Configuration& configuration) const;
  /// What the estimate has come to.
  void add(const design::Configuration& configuration, std::vector<results::MeshErrorRecord> errors);
  /// The errors of a configuration; empty where they were not estimated.
  std::vector<results::MeshErrorRecord> errorsOf(int id) const;
  /// Says in a note "error of the mesh" what is known, if anything is.
  void report(results::ResultSink& sink) const;

 private:
  struct Estimate {
    std::vector<double> values;  // of the parameters
    std::vector<results::MeshErrorRecord> errors;
  };

  const results::StudyResults& results_;
  std::vector<std::size_t> curves_;
  std::vector<double> ranges_;         // of the parameters
  std::map<int, Estimate> estimates_;  // by id
};

}  // namespace harmos::study
