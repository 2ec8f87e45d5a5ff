#include <harmos/setup/MeshSource.hpp>

#include <filesystem>

#include <harmos/mesh/BoltedJoint.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/ExodusReader.hpp>
#include <harmos/mesh/GluedAssembly.hpp>

namespace harmos::setup {

namespace {

struct Source {
  base::ParameterSpec form;
  mesh::Mesh (*make)(const base::Parameters&);
  std::optional<int> (*dimension)(const base::Parameters&, base::ErrorList&);
};

template <int dimension>
std::optional<int> always(const base::Parameters&, base::ErrorList&) {
  return dimension;
}

std::optional<int> ofBoxes(const base::Parameters& source, base::ErrorList& errors) {
  const int before = errors.count();
  const std::vector<mesh::Box> boxes = mesh::readBoxes(source, errors);
  if (errors.count() > before) return std::nullopt;
  return mesh::dimensionOf(boxes.front().element);
}

std::vector<Source> generators() {
  return {{mesh::describeBoltedJoint(), &mesh::boltedJoint, &always<3>},
          {mesh::describeGluedAssembly(), &mesh::gluedAssembly, &always<2>},
          {mesh::describeBoxes(), &mesh::boxes, &ofBoxes}};
}

}  // namespace

std::vector<base::ParameterSpec> meshForms() {
  base::ParameterSpec exodus("Exodus");
  exodus.summary(
      "A mesh in an Exodus II file: 8-node hexahedra, 6-node wedges, 5-node pyramids, 4-node tetrahedra; in "
      "the plane 4-node quadrilaterals, 3-node triangles.");
  exodus.text("File").required().doc("Path of the file; a relative one starts at the folder of the scene.");
  std::vector<base::ParameterSpec> forms{exodus};
  for (const Source& source : generators()) forms.push_back(source.form);
  return forms;
}

std::optional<int> meshDimension(const base::Parameters& source, base::ErrorList& errors) {
  for (const Source& generator : generators()) {
    if (generator.form.name() == source.type()) return generator.dimension(source, errors);
  }
  return std::nullopt;
}

mesh::Mesh makeMesh(const base::Parameters& source, const std::string& scenePath) {
  for (const Source& generator : generators()) {
    if (generator.form.name() == source.type()) return generator.make(source);
  }
  const auto folder = std::filesystem::path(scenePath).parent_path();
  return mesh::readExodus((folder / source.text("File")).string());
}

}  // namespace harmos::setup
