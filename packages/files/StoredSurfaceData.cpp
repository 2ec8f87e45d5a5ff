#include <harmos/files/StoredSurfaceData.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/files/detail/Hdf5Source.hpp>
#include <harmos/files/detail/StudyFile.hpp>
#include <harmos/results/StatusName.hpp>

namespace harmos::files {

results::SurfaceData readSurfaceData(const std::string& path) {
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
  std::vector<bool> isSolved;
  for (const std::string& name : study.group("configurations").group("status").textValues()) {
    const auto status = results::statusNamed(name);  // none when open
    isSolved.push_back(status && results::isSolved(*status));
  }
  const auto column = [&](const Hdf5Source& array) {
    std::vector<double> values = array.values();
    if (values.size() == isSolved.size()) return values;
    throw base::Error("Cannot read " + path + ": it is damaged: the sizes of its arrays do not fit together.",
                      base::ExitCode::input);
  };
  const Hdf5Source parameters = study.group("parameters");
  for (const std::string& name : parameters.texts("order")) {
    const Hdf5Source array = parameters.group(name);
    if (array.text("formula").empty()) data.addParameter(name, column(array));
  }
  const Hdf5Source responses = study.group("responses");
  for (const std::string& name : responses.texts("order")) {
    data.addResponse(name, column(responses.group(name)), isSolved);
  }
  return data;
}

}  // namespace harmos::files
