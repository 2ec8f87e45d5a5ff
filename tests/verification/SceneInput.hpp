#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/input/InputTree.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::verification {

/// The XML of a scene, and what a test changes in it before it is solved.
class SceneInput {
 public:
  /// A path below the folder of the verification tests.
  static SceneInput fromFile(const std::string& path);

  /// As --set; named lists must be there.
  SceneInput& set(const std::string& assignment);
  /// Adds XML elements to the list "List/Sublist"; lists of that name which are there already are replaced.
  SceneInput& add(const std::string& list, const std::string& xml);
  /// Removes the list or parameter "List/Name".
  SceneInput& remove(const std::string& path);
  /// Replaces the mesh by what `change` makes of it, through an Exodus file. Collective over all processes.
  SceneInput& changeMesh(const std::function<void(mesh::Mesh&)>& change);

  /// Replaces the mesh by the same one in an Exodus file that has a nodal variable at one time. Collective likewise.
  SceneInput& addNodalVariable(const std::string& name, const std::function<double(const base::Vector3&)>& value);

  scene::Scene scene() const;
  /// The mesh of the scene as it is now.
  mesh::Mesh mesh() const;

 private:
  SceneInput& write(const mesh::Mesh& mesh, const std::vector<std::string>& names,
                    const std::vector<std::vector<double>>& values);
  input::InputNode& list(const std::string& path);

  std::string path_;
  input::InputTree input_;
  std::vector<std::string> overrides_;
};

/// One element in XML; numbers with all their digits.
std::string xmlList(const std::string& name, const std::string& content);
std::string xmlText(const std::string& name, const std::string& value);
std::string xmlNumber(const std::string& name, double value);
std::string xmlNumbers(const std::string& name, const std::vector<double>& values);

/// The assignment for SceneInput::set(), with all digits of the value.
std::string assignment(const std::string& path, double value);

/// Responses "Interface Force" and "Maximum" in XML.
std::string forceResponse(const std::string& name, const std::string& interface, const std::vector<double>& direction);
std::string maximumResponse(const std::string& name, const std::string& interface, const std::string& field);

}  // namespace harmos::verification
