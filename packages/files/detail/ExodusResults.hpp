#pragma once

#include <string>
#include <vector>

#include <harmos/files/ResultMesh.hpp>
#include <harmos/files/detail/ExodusHandle.hpp>

namespace harmos::files {

/// Reads a result file: mesh, names and times at once, values on request. Any element type is accepted.
class ExodusResults {
 public:
  /// Throws base::Error(ExitCode::input) when `path` is not an Exodus file or a truncated one.
  explicit ExodusResults(const std::string& path);

  const std::string& path() const { return path_; }
  const ResultMesh& mesh() const { return mesh_; }
  const ResultVariables& variables() const { return variables_; }
  const std::vector<double>& times() const { return times_; }
  /// Information records, continued lines joined.
  std::vector<std::string> information() const;

  /// Values at step `step` (from 0) of the variable at position `variable` in variables().
  double global(int step, int variable) const;
  std::vector<double> nodal(int step, int variable) const;
  /// Through all blocks; 0 on blocks that do not have the variable.
  std::vector<double> element(int step, int variable) const;

 private:
  void readBlocks();
  void readSets();
  void checkSize() const;

  std::string path_;
  ExodusHandle file_;
  ResultMesh mesh_;
  std::vector<long long> blockIds_;
  std::vector<int> truth_;  // [block][variable]
  ResultVariables variables_;
  std::vector<double> times_;
};

}  // namespace harmos::files
