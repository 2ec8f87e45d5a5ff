#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <harmos/elasticity/Material.hpp>
#include <harmos/input/InputTree.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/latin/LatinOptions.hpp>
#include <harmos/laws/LawRegistry.hpp>

/// Scenes: from XML to an assembly and its responses, and from the solution to files.
namespace harmos::scene {

/// Which results are computed besides responses and sums.
struct OutputChoice {
  bool fields = true;                    // of parts and interfaces, in Exodus files
  bool nodalStress = false;              // recovered at the nodes, with von Mises and principal stresses
  std::vector<std::string> derivatives;  // entries of laws, with respect to which responses are differentiated
};

/// A checked scene: all that can be known before a mesh is read.
struct Scene {
  std::string path;         // of the scene's file
  input::Parameters input;  // all defaults filled in, histories attached
  latin::LatinOptions solver;
  bool hasConsistentMass = false;  // of interfaces, where they have faces
  bool wantsMeshErrors = true;     // of every response, beside the error of the solver; never with a path
  OutputChoice output;
  std::vector<double> times;  // end of each load step [time], ascending from above 0
  std::map<std::string, std::shared_ptr<const elasticity::Material>> materials;  // by name in the list Materials
  std::map<std::string, std::shared_ptr<const laws::InterfaceLaw>> laws;         // by name of interface or boundary
  std::vector<std::string>
      warnings;  // what the input says without effect or likely wrong: a sentence each, with its place
  std::shared_ptr<const laws::InterfaceLaw> cutLaw;  // between the pieces of one part
};

/// Checks an input against sceneSpec(), and every name that it refers to except those of the mesh.
/// Each of `overrides` is "List/Sublist/Name=value". `path` is where the input comes from: relative names of files
/// start at its folder. Laws are those of `laws` and of the plugins that the input names, see lawsOf(). Throws one
/// base::Error (input) that lists all errors, those of plugins before any other. Keeps nothing of `laws`.
Scene makeScene(const input::InputTree& input, const std::string& path, const std::vector<std::string>& overrides,
                const laws::LawRegistry& laws);

/// makeScene() of a file. Throws base::Error (input) also when it cannot be read. Not collective: every rank reads it.
Scene readScene(const std::string& path, const std::vector<std::string>& overrides, const laws::LawRegistry& laws);

/// The files that `scene` is read from: its own, that of its mesh if there is one, and its plugins.
std::vector<std::string> inputFiles(const Scene& scene);

}  // namespace harmos::scene
