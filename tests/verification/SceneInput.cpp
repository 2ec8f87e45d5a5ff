#include "SceneInput.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>

#include <harmos/base/Numerals.hpp>
#include <harmos/files/ExodusWriter.hpp>
#include <harmos/scene/MeshSource.hpp>

namespace harmos::verification {

namespace {

/// A name for a mesh that the ranks of this run share and no other run has.
std::string newMeshFile(const Teuchos::Comm<int>& comm) {
  static int count = 0;
  int process = static_cast<int>(getpid());
  Teuchos::broadcast(comm, 0, Teuchos::outArg(process));
  const std::string name = "harmos_verification_" + std::to_string(process) + "_" + std::to_string(count++) + ".e";
  return (std::filesystem::temp_directory_path() / name).string();
}

/// Files that are removed when the tests end.
struct MeshFiles {
  std::vector<std::string> paths;
  ~MeshFiles() {
    for (const std::string& path : paths) std::remove(path.c_str());
  }
};

}  // namespace

SceneInput SceneInput::fromFile(const std::string& path) {
  SceneInput scene;
  scene.path_ = (std::filesystem::path(HARMOS_VERIFICATION_DIR) / path).string();
  scene.input_ = input::InputTree::fromFile(scene.path_);
  return scene;
}

SceneInput& SceneInput::set(const std::string& assignment) {
  overrides_.push_back(assignment);
  return *this;
}

input::InputNode& SceneInput::list(const std::string& path) {
  input::InputNode* node = &input_.root;
  for (const auto& name : std::filesystem::path(path)) {
    input::InputNode* child = node->child(name.string());
    if (child == nullptr) {
      child = &node->children.emplace_back();
      child->tag = input::InputNode::listTag;
      child->location = "verification test";
      child->setAttribute("name", name.string());
    }
    node = child;
  }
  return *node;
}

SceneInput& SceneInput::add(const std::string& path, const std::string& xml) {
  const std::string wrapped = "<ParameterList name=\"added\">" + xml + "</ParameterList>";
  const input::InputTree added = input::InputTree::fromText(wrapped, "verification test");
  auto& children = list(path).children;
  for (const input::InputNode& node : added.root.children) {
    children.erase(std::remove_if(children.begin(), children.end(),
                                  [&](const input::InputNode& old) { return old.name() == node.name(); }),
                   children.end());
    children.push_back(node);
  }
  return *this;
}

SceneInput& SceneInput::remove(const std::string& path) {
  const std::filesystem::path whole(path);
  auto& children = list(whole.parent_path().string()).children;
  const std::string name = whole.filename().string();
  children.erase(
      std::remove_if(children.begin(), children.end(), [&](const input::InputNode& old) { return old.name() == name; }),
      children.end());
  return *this;
}

SceneInput& SceneInput::changeMesh(const std::function<void(mesh::Mesh&)>& change) {
  mesh::Mesh mesh = this->mesh();
  change(mesh);
  return write(mesh, {}, {});
}

SceneInput& SceneInput::addNodalVariable(const std::string& name,
                                         const std::function<double(const base::Vector3&)>& value) {
  const mesh::Mesh mesh = this->mesh();
  std::vector<double> values;
  for (const base::Vector3& x : mesh.nodes) values.push_back(value(x));
  return write(mesh, {name}, {values});
}

SceneInput& SceneInput::write(const mesh::Mesh& mesh, const std::vector<std::string>& names,
                              const std::vector<std::vector<double>>& values) {
  static MeshFiles files;
  const auto comm = Tpetra::getDefaultComm();
  const std::string file = newMeshFile(*comm);
  if (comm->getRank() == 0) {
    files.paths.push_back(file);
    files::ExodusWriter writer(file, "Verification", files::resultMesh(mesh), {names, {}, {}});
    if (!names.empty()) writer.write({1.0, values, {}, {}});
    writer.commit();
  }
  comm->barrier();
  overrides_.erase(std::remove_if(overrides_.begin(), overrides_.end(),
                                  [](const std::string& assignment) { return assignment.rfind("Mesh/", 0) == 0; }),
                   overrides_.end());
  remove("Mesh");
  return add("Mesh",
             "<Parameter name=\"Type\" type=\"string\" value=\"Exodus\"/>"
             "<Parameter name=\"File\" type=\"string\" value=\"" +
                 file + "\"/>");
}

scene::Scene SceneInput::scene() const {
  return scene::makeScene(input_, path_, overrides_, laws::builtInLaws());
}

mesh::Mesh SceneInput::mesh() const {
  return scene::makeMesh(scene().input.list("Mesh"), path_);
}

namespace {

std::string xmlParameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

}  // namespace

std::string xmlList(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
}

std::string xmlText(const std::string& name, const std::string& value) {
  return xmlParameter(name, "string", value);
}

std::string xmlNumber(const std::string& name, double value) {
  return xmlParameter(name, "double", base::toText(value));
}

std::string xmlNumbers(const std::string& name, const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + base::toText(value);
  return xmlParameter(name, "Array(double)", "{" + text + "}");
}

std::string assignment(const std::string& path, double value) {
  return path + "=" + base::toText(value);
}

std::string forceResponse(const std::string& name, const std::string& interface, const std::vector<double>& direction) {
  return xmlList(
      name, xmlText("Type", "Interface Force") + xmlText("Interface", interface) + xmlNumbers("Direction", direction));
}

std::string maximumResponse(const std::string& name, const std::string& interface, const std::string& field) {
  return xmlList(name, xmlText("Type", "Maximum") + "<Parameter name=\"Interfaces\" type=\"Array(string)\" value=\"{" +
                           interface + "}\"/>" + xmlText("Field", field));
}

}  // namespace harmos::verification
