#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/files/ExodusWriter.hpp>

namespace harmos::scene {

/// A number per load step for the Exodus files.
struct GlobalVariable {
  std::string name;            // as it stands in the file
  std::vector<double> values;  // per load step, in its own unit
};

/// Adds "<name>_x", "<name>_y" and in 3-D "<name>_z" to `names`.
void addVector(std::vector<std::string>& names, const std::string& name, int dimension);

/// What the Exodus files of one run have in common; rank 0 writes.
class FieldFile {
 public:
  /// `title` and `input`, line by line, go into every file, the latter into the information records. `times`, the
  /// ends of the load steps to write [time], and `comm` must outlive this object; `globals` have a value for each.
  FieldFile(std::string title, const std::string& input, const std::vector<double>& times,
            std::vector<GlobalVariable> globals, const Teuchos::Comm<int>& comm);

  /// Load steps that are written, from the first.
  int steps() const { return static_cast<int>(times_.size()); }
  /// End of load step `step`, from 0 [time]; not checked.
  double time(int step) const { return times_[step]; }
  /// A file that holds the unloaded state already; null but on rank 0. The global variables are added to `variables`.
  /// Throws what files::ExodusWriter throws.
  std::unique_ptr<files::ExodusWriter> open(const std::string& path, const files::ResultMesh& mesh,
                                            files::ResultVariables variables) const;
  /// On rank 0, where there is a `writer`, writes load step `number`, from 0, with the global variables. Throws what
  /// files::ExodusWriter throws, and base::Error (notConverged), which names the field, where a value is not finite:
  /// readers choke on it.
  void write(files::ExodusWriter* writer, files::ResultStep& step, int number) const;
  /// Adds up on rank 0 what each rank has filled in; elsewhere the values are lost. Collective; as many values on every
  /// rank.
  void gather(std::vector<double>& values) const;

 private:
  std::string title_;
  std::vector<std::string> information_;
  const std::vector<double>& times_;
  std::vector<GlobalVariable> globals_;
  const Teuchos::Comm<int>& comm_;
};

}  // namespace harmos::scene
