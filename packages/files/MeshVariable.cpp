#include <harmos/files/MeshVariable.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/files/detail/ExodusResults.hpp>
#include <harmos/files/detail/ForeignReading.hpp>

namespace harmos::files {

namespace {

/// Its position in a list of names; -1: it is not there.
int positionOf(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

MeshVariable read(const std::string& path, const std::string& name, const std::optional<int>& step) {
  const ExodusResults results(path);
  MeshVariable variable;
  int position = positionOf(name, results.variables().nodal);
  if (position < 0) {
    position = positionOf(name, results.variables().element);
    variable.isNodal = false;
  }
  if (position < 0) {
    std::vector<std::string> known = results.variables().nodal;
    known.insert(known.end(), results.variables().element.begin(), results.variables().element.end());
    throw base::Error(path + " has no variable \"" + name + "\" of nodes or elements.\n  " +
                          (known.empty() ? "It has none at all." : base::suggestName(name, known, "It has")),
                      base::ExitCode::input);
  }
  const int steps = static_cast<int>(results.times().size());
  if (steps == 0 || (step && *step > steps)) {
    throw base::Error(path + " has " + std::to_string(steps) + " time steps; number " +
                          std::to_string(std::max(step.value_or(1), 1)) + " is asked for.",
                      base::ExitCode::input);
  }
  const int first = step ? (*step == 0 ? steps : *step) - 1 : 0, end = step ? first + 1 : steps;
  for (int s = first; s < end; ++s) {
    variable.times.push_back(results.times()[static_cast<std::size_t>(s)]);
    variable.values.push_back(variable.isNodal ? results.nodal(s, position) : results.element(s, position));
  }
  for (const ResultMesh::Block& block : results.mesh().blocks) {
    variable.blocks.push_back(block.name);
    variable.blockSizes.push_back(block.nodesPerElement > 0 ? block.elements() : 0);
  }
  return variable;
}

}  // namespace

MeshVariable readMeshVariable(const std::string& path, const std::string& name, const std::optional<int>& step) {
  MeshVariable variable;
  readForeign(
      {path},
      [&](ByteWriter& writer) {
        const MeshVariable found = read(path, name, step);
        writer.put(found.isNodal);
        writer.put(found.times);
        writer.put(found.values);
        writer.put(found.blocks);
        writer.put(found.blockSizes);
      },
      [&](ByteReader& reader) {
        reader.get(variable.isNodal);
        reader.get(variable.times);
        reader.get(variable.values);
        reader.get(variable.blocks);
        reader.get(variable.blockSizes);
      });
  return variable;
}

}  // namespace harmos::files
