#pragma once

#include <string>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/input/Registry.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::scene {

struct Bodies;
struct Model;
class Temperatures;

/// What responses are made of, besides their entries.
struct ResponseContext {
  const mesh::Mesh& mesh;
  const std::vector<mesh::Piece>& pieces;
  const mesh::InterfaceFinder& finder;
  const assembly::Assembly& assembly;  // its interfaces carry the names of the scene
  const Bodies& bodies;                // of the same pieces
  const Model& model;
  const Temperatures& temperatures;

  /// Positions of the interfaces of these names, an interface between pieces having several; without names, of all.
  std::vector<int> interfacesNamed(const std::vector<std::string>& names) const;
  /// The same for the names that `entry` lists; absent: of all.
  std::vector<int> interfacesOf(const input::Parameters& response, const std::string& entry) const;
};

/// The responses that a scene may name.
using ResponseRegistry = input::Registry<latin::Response, const ResponseContext&>;

/// The entry that all responses have.
void describeScale(input::ParameterSpec& spec);

/// Adds the response written as struct R under R::name: R::describe(spec) declares its entries, R::make(parameters,
/// context) builds it.
template <class R>
void addResponse(ResponseRegistry& responses, const ResponseRegistry::Check& check = {}) {
  input::ParameterSpec spec(R::name);
  R::describe(spec);
  describeScale(spec);
  responses.add(std::move(spec), R::make, check);
}

/// All responses: the list in packages/scene/CMakeLists.txt.
const ResponseRegistry& builtInResponses();

/// The vector that an entry of two or three numbers gives.
base::Vector3 vectorOf(const input::Parameters& parameters, const std::string& entry);
/// The same of length 1.
base::Vector3 directionOf(const input::Parameters& parameters, const std::string& entry);

}  // namespace harmos::scene

/// Ends the file of a response: defines the function that the generated list calls.
#define HARMOS_RESPONSE(Response)                   \
  void add##Response(ResponseRegistry& responses) { \
    addResponse<Response>(responses);               \
  }

/// The same with a check of what its entries say together: Response::check(parameters, errors).
#define HARMOS_CHECKED_RESPONSE(Response)              \
  void add##Response(ResponseRegistry& responses) {    \
    addResponse<Response>(responses, Response::check); \
  }
