#include <harmos/files/StoredSurfaceData.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/files/detail/Hdf5.hpp>
#include <harmos/files/detail/StudyFile.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::files {

results::SurfaceData readSurfaceData(const std::string& path) {
  const QuietHdf5 quiet;
  const Hdf5Source root = Hdf5Source::open(path);
  if (!root.hasAttribute("schema") || root.text("schema") != "harmos-study") {
    throw base::Error(path + " is not the file of a study.", base::ExitCode::input);
  }
  if (root.integer("schema_version") > studySchemaVersion) {
    throw base::Error(path + " was written by a newer version of Harmos.", base::ExitCode::input);
  }
  const Hdf5Source study = root.group(root.names().front());
  results::SurfaceData data;
  data.accuracy = study.number("accuracy");
  const Hdf5Source parameters = study.group("parameters");
  for (const std::string& name : parameters.texts("order")) {
    const Hdf5Source array = parameters.group(name);
    if (array.text("formula").empty()) data.addParameter(name, array.values());
  }
  std::vector<bool> isSolved;
  for (const std::string& name : study.group("configurations").group("status").textValues()) {
    const auto status = results::statusNamed(name);  // none when open
    isSolved.push_back(status && results::isSolved(*status));
  }
  const Hdf5Source responses = study.group("responses");
  for (const std::string& name : responses.texts("order")) {
    data.addResponse(name, responses.group(name).values(), isSolved);
  }
  return data;
}

}  // namespace harmos::files
