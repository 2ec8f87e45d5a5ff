#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/files/ResultMesh.hpp>

namespace harmos::files {

/// Writes results to one Exodus II file (EX_LARGE_MODEL), to be called on one rank only.
///
/// Every element variable exists on every block (truth table all ones), because readers such as meshio require it; what
/// a block does not have is 0. A QA record names Harmos and its version; information lines longer than 80 characters
/// are continued after a backslash. Numbers above 2147483647 are not written. Names of blocks, of side sets and of node
/// sets must be unique among their kind. The file appears under its name with commit(); a writer destroyed before
/// leaves no trace. Where Exodus cannot write, base::Error is thrown.
class ExodusWriter {
 public:
  /// Writes mesh, names and `information`; the `title` is cut to 80 characters. Throws base::Error when a name occurs
  /// twice or the file cannot be written.
  ExodusWriter(const std::string& path, const std::string& title, ResultMesh mesh, ResultVariables variables,
               const std::vector<std::string>& information = {});
  ~ExodusWriter();

  /// As given; lives as long as the writer.
  const ResultMesh& mesh() const;
  /// As given; lives as long as the writer.
  const ResultVariables& variables() const;
  /// Appends one time; throws base::Error when the sizes do not fit the mesh and the variables.
  void write(const ResultStep& step);
  /// Completes the file and gives it its name, replacing an older one; nothing can be written afterwards.
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace harmos::files
