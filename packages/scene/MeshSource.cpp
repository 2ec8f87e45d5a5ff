#include <harmos/scene/MeshSource.hpp>

#include <cmath>
#include <filesystem>

#include <harmos/base/Error.hpp>
#include <harmos/files/MeshFile.hpp>
#include <harmos/mesh/BoltedJoint.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/CurvedFaces.hpp>
#include <harmos/mesh/GluedAssembly.hpp>
#include <harmos/mesh/Refinement.hpp>

namespace harmos::scene {

namespace {

struct Source {
  input::ParameterSpec form;
  mesh::Mesh (*make)(const input::Parameters&);
  std::vector<mesh::BlockSize> (*sizes)(const input::Parameters&);
  std::optional<int> (*dimension)(const input::Parameters&, input::ErrorList&);
};

int refinementsOf(const input::Parameters& source) {
  return source.has("Refine") ? source.integer("Refine") : 0;
}

bool isRaised(const input::Parameters& source) {
  return source.has("Order") && source.integer("Order") == 2;
}

template <int dimension>
std::optional<int> always(const input::Parameters&, input::ErrorList&) {
  return dimension;
}

std::optional<int> ofBoxes(const input::Parameters& source, input::ErrorList& errors) {
  const int before = errors.count();
  const std::vector<mesh::Box> boxes = mesh::readBoxes(source, errors);
  if (errors.count() > before) return std::nullopt;
  return mesh::dimensionOf(boxes.front().element);
}

std::vector<Source> generators() {
  return {{mesh::describeBoltedJoint(), &mesh::boltedJoint, &mesh::boltedJointSizes, &always<3>},
          {mesh::describeGluedAssembly(), &mesh::gluedAssembly, &mesh::gluedAssemblySizes, &always<2>},
          {mesh::describeBoxes(), &mesh::boxes, &mesh::boxesSizes, &ofBoxes}};
}

}  // namespace

std::vector<input::ParameterSpec> meshForms() {
  input::ParameterSpec exodus("Exodus");
  exodus.summary(
      "A mesh in an Exodus II file: hexahedra of 8, 20 or 27 nodes, wedges of 6 or 15, pyramids of 5, tetrahedra of 4 "
      "or 10; in the plane quadrilaterals of 4, 8 or 9 nodes, triangles of 3 or 6.");
  exodus.text("File").required().doc(
      "Path of the file; a relative one starts at the folder of the scene. Files that end in .msh (Gmsh), .inp "
      "(Abaqus, "
      "CalculiX), .unv, .med, .vtu or .vtk are read as what they are.");
  std::vector<input::ParameterSpec> forms{exodus};
  for (const Source& source : generators()) forms.push_back(source.form);
  return forms;
}

std::optional<int> meshDimension(const input::Parameters& source, input::ErrorList& errors) {
  for (const Source& generator : generators()) {
    if (generator.form.name() == source.type()) return generator.dimension(source, errors);
  }
  return std::nullopt;
}

std::vector<mesh::BlockSize> meshSizes(const input::Parameters& source) {
  std::vector<mesh::BlockSize> sizes;
  for (const Source& generator : generators()) {
    if (generator.form.name() == source.type()) sizes = generator.sizes(source);
  }
  for (mesh::BlockSize& block : sizes) {
    block.elements *= std::pow(2.0, mesh::dimensionOf(block.type) * refinementsOf(source));
    if (isRaised(source)) block.type = mesh::raised(block.type);
  }
  return sizes;
}

std::optional<std::string> meshFile(const input::Parameters& source, const std::string& scenePath) {
  if (!source.has("File")) return std::nullopt;
  return (std::filesystem::path(scenePath).parent_path() / source.text("File")).string();
}

namespace {

mesh::Mesh givenMesh(const input::Parameters& source, const std::string& scenePath,
                     std::vector<std::string>* warnings) {
  for (const Source& generator : generators()) {
    if (generator.form.name() == source.type()) return generator.make(source);
  }
  const bool hasUnused = source.has("Unused Blocks");
  return files::readMesh(*meshFile(source, scenePath),
                         hasUnused ? source.texts("Unused Blocks") : std::vector<std::string>{}, warnings);
}

}  // namespace

mesh::Mesh makeMesh(const input::Parameters& source, const std::string& scenePath, std::vector<std::string>* warnings) {
  mesh::Mesh mesh = givenMesh(source, scenePath, warnings);
  std::vector<mesh::CurvedFaces> curved;
  std::string faults;
  for (const input::Parameters& surface : source.lists("Curved Surfaces")) {
    using Kind = mesh::CurvedSurface::Kind;
    const std::string type = surface.text("Type");
    const Kind kind = type == "Sphere" ? Kind::sphere : type == "Cone" ? Kind::cone : Kind::cylinder;
    try {
      curved.push_back(mesh::curvedFaces(mesh, surface.name(), kind, surface.texts("Side Sets")));
    } catch (const base::Error& error) {
      faults += (faults.empty() ? "" : "\n  ") + std::string(error.what());
    }
  }
  if (!faults.empty()) throw base::Error(faults, base::ExitCode::input);
  const auto replace = [&](mesh::Mesh (*finer)(const mesh::Mesh&)) {
    const int first = static_cast<int>(mesh.nodes.size());
    mesh = finer(mesh);
    mesh::moveOnto(curved, first, mesh);
  };
  const int refinements = refinementsOf(source);
  const int straight = refinements > 0 || isRaised(source) ? mesh::straightBeside(mesh, curved) : 0;
  if (straight > 0 && warnings != nullptr) {
    warnings->push_back(
        std::to_string(straight) +
        " faces lie on Curved Surfaces but are in none of their side sets: they stay straight, and gaps "
        "or overlaps open to faces that are curved. Name side sets of both parts that touch there.");
  }
  for (int i = refinements; i > 0; --i) replace(&mesh::refined);
  if (isRaised(source)) replace(&mesh::raised);
  return mesh;
}

}  // namespace harmos::scene
