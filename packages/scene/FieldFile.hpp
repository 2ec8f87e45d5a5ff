#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/files/ExodusWriter.hpp>

namespace harmos::scene {

/// A number per load step for the Exodus files.
struct GlobalVariable {
  std::string name;
  std::vector<double> values;
};

/// Adds "<name>_x", "<name>_y" and in 3-D "<name>_z".
void addVector(std::vector<std::string>& names, const std::string& name, int dimension);

/// What the Exodus files of one run have in common; rank 0 writes.
class FieldFile {
 public:
  /// `input` goes into the information records. `times` and `comm` must outlive this object.
  FieldFile(std::string title, const std::string& input, const std::vector<double>& times,
            std::vector<GlobalVariable> globals, const Teuchos::Comm<int>& comm);

  double time(int step) const { return times_[step]; }
  /// A file that holds the unloaded state already; null but on rank 0.
  std::unique_ptr<files::ExodusWriter> open(const std::string& path, const files::ResultMesh& mesh,
                                            files::ResultVariables variables) const;
  void fillGlobals(files::ResultStep& step, int number) const;
  /// Adds up on rank 0 what each rank has filled in. Collective.
  void gather(std::vector<double>& values) const;

 private:
  std::string title_;
  std::vector<std::string> information_;
  const std::vector<double>& times_;
  std::vector<GlobalVariable> globals_;
  const Teuchos::Comm<int>& comm_;
};

}  // namespace harmos::scene
