#include <harmos/files/NodalVariable.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/files/detail/ExodusResults.hpp>
#include <harmos/files/detail/ForeignReading.hpp>

namespace harmos::files {

namespace {

std::vector<double> read(const std::string& path, const std::string& name, int step) {
  const ExodusResults results(path);
  const std::vector<std::string>& names = results.variables().nodal;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw base::Error(path + " has no nodal variable \"" + name + "\".\n  " +
                          (names.empty() ? "It has none at all." : base::suggestName(name, names, "It has")),
                      base::ExitCode::input);
  }
  const int steps = static_cast<int>(results.times().size());
  if (steps == 0 || step > steps) {
    throw base::Error(path + " has " + std::to_string(steps) + " time steps; number " +
                          std::to_string(std::max(step, 1)) + " is asked for.",
                      base::ExitCode::input);
  }
  return results.nodal((step == 0 ? steps : step) - 1, static_cast<int>(found - names.begin()));
}

}  // namespace

std::vector<double> readNodalVariable(const std::string& path, const std::string& name, int step) {
  std::vector<double> values;
  readForeign(
      {path}, [&](ByteWriter& writer) { writer.put(read(path, name, step)); },
      [&](ByteReader& reader) { reader.get(values); });
  return values;
}

}  // namespace harmos::files
