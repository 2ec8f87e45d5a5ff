#include <harmos/scene/Problem.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/SoleThread.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/scene/Interfaces.hpp>
#include <harmos/scene/MemoryPerRank.hpp>
#include <harmos/scene/MeshSource.hpp>
#include <harmos/scene/detail/AutomaticPieces.hpp>
#include <harmos/scene/detail/CohesiveZones.hpp>
#include <harmos/scene/detail/Contradictions.hpp>
#include <harmos/scene/detail/Dimensions.hpp>
#include <harmos/scene/detail/Fields.hpp>
#include <harmos/scene/detail/PathFollowing.hpp>
#include <harmos/scene/detail/ResponseRegistry.hpp>
#include <harmos/scene/detail/Surfaces.hpp>
#include <harmos/scene/detail/UnresolvedFields.hpp>

namespace harmos::scene {

namespace {

/// Throws on every rank the errors of the first rank that has any.
void throwTogether(const input::ErrorList& errors, const Teuchos::Comm<int>& comm) {
  const int mine = errors.count() > 0 ? comm.getRank() : comm.getSize();
  int first = mine;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MIN, mine, Teuchos::outArg(first));
  if (first == comm.getSize()) return;
  std::string text = errors.message();
  int length = static_cast<int>(text.size());
  Teuchos::broadcast(comm, first, Teuchos::outArg(length));
  text.resize(length);
  Teuchos::broadcast(comm, first, length, text.data());
  throw base::Error(text, base::ExitCode::input);
}

/// Some faults of laws come to light at their points only, such as an axis along the normal of the surface: asks every
/// law for its first load step, pressed and dragged, so that they are found before anything is solved. What else a law
/// may throw there says nothing, for it may be at home elsewhere.
void askLaws(const assembly::Assembly& assembly, const std::string& path, input::ErrorList& errors) {
  for (const assembly::Interface& interface : assembly.interfaces) {
    if (laws::isCoupled(*interface.law)) continue;
    const auto pairs = static_cast<std::size_t>(interface.pairs());
    std::vector<laws::LocalLine> lines;
    for (const double gap : interface.gap) lines.push_back({{-1.0 - std::abs(gap), 1.0, 1.0}, 1.0});
    const std::vector<double> old(pairs * static_cast<std::size_t>(interface.law->historySize()), 0.0);
    std::vector<double> now(old.size());
    std::vector<laws::LocalState> states(pairs);
    laws::NodeArrays nodes = interface.nodes(assembly.times, 0);
    nodes.line = lines.data();
    nodes.oldHistory = old.data();
    nodes.newHistory = now.data();
    nodes.state = states.data();
    try {
      interface.solve(0, nodes);
    } catch (const base::Error& error) {
      if (error.code() == base::ExitCode::input) errors.add(path, error.what());
    }
  }
}

/// Bodies, interfaces and responses of a problem whose mesh is known; parts in so many `pieces`, or else as the scene
/// says. Reports errors as makeProblem() throws them; those in blocks, sets and fields it throws on all ranks.
std::shared_ptr<const laws::SpatialFields> joinParts(const Scene& scene, const std::map<std::string, int>& pieces,
                                                     const Teuchos::Comm<int>& comm, Problem& problem,
                                                     input::ErrorList& errors) {
  Surfaces found;
  std::optional<mesh::InterfaceFinder> finder;
  problem.bodies = {};
  problem.responses.clear();
  do {  // again while pieces divide what points of joined meshes see
    KeptTogether together = std::move(problem.bodies.together);
    for (auto& [part, lists] : found.crossed) {
      std::move(lists.begin(), lists.end(), std::back_inserter(together[part]));
    }
    problem.bodies = makeBodies(scene, problem.mesh, errors, together, pieces);
    problem.bodies.together = std::move(together);
    throwTogether(errors, comm);
    finder.emplace(problem.mesh, problem.bodies.pieces, depthOf(problem.model));
    found = findSurfaces(scene, problem.mesh, problem.model, problem.bodies, *finder, errors);
  } while (!found.crossed.empty() && errors.count() == 0);
  problem.surfaces = std::move(found.all);
  problem.joined = std::move(found.joined);
  assembly::Assembly& assembly = problem.assembly;
  assembly = {};
  assembly.dimension = elasticity::componentsOf(problem.model.kinematics);
  assembly.times = scene.times;
  const int before = errors.count();
  const FieldContext fieldContext{problem.mesh, problem.bodies.pieces, problem.surfaces, scene.input, scene.path,
                                  scene.times};
  auto fields =
      std::make_shared<const laws::SpatialFields>(makeFields(scene.input.lists("Fields"), fieldContext, errors));
  if (errors.count() > before) throwTogether(errors, comm);  // else laws would miss them
  Interfaces made = makeInterfaces(scene, problem.mesh.dimension, problem.bodies.pieces, problem.surfaces,
                                   scene.hasConsistentMass, fields);
  assembly.interfaces = std::move(made.interfaces);
  problem.places = std::move(made.places);
  if (errors.count() == 0) {
    checkContradictions(
        scene, {problem.mesh, problem.bodies.pieces, problem.surfaces, assembly.interfaces, assembly.dimension},
        errors);
  }
  problem.temperatures = std::make_shared<Temperatures>(scene, problem.mesh, errors);
  const ResponseContext context{problem.mesh,  problem.bodies.pieces, *finder, assembly, problem.bodies,
                                problem.model, *problem.temperatures};
  for (const input::Parameters& response : scene.input.lists("Responses")) {
    errors.collect(response.where(), [&] {
      auto created = builtInResponses().create(response, context);
      if (response.has("Scale")) created->setScale(response.number("Scale"));
      problem.responses.push_back(std::move(created));
    });
  }
  if (errors.count() == 0) askLaws(assembly, scene.path, errors);
  if (errors.count() == 0) addPath(scene.input, assembly, problem.responses, errors);
  return fields;
}

/// The same with large parts in pieces where that pays; as the scene says where it does not, or cannot be done.
std::shared_ptr<const laws::SpatialFields> joinCutParts(const Scene& scene, const Teuchos::Comm<int>& comm,
                                                        Problem& problem, input::ErrorList& errors) {
  auto fields = joinParts(scene, {}, comm, problem, errors);
  if (errors.count() > 0) return fields;
  PieceChoice choice = choosePieces(scene, problem.mesh, problem.bodies, problem.assembly.interfaces,
                                    problem.assembly.dimension, comm.getSize(), memoryOfAllRanks(comm));
  if (choice.pieces.empty()) {
    for (PartOptions& part : problem.bodies.parts) part.iterates |= choice.iterated.count(part.name) > 0;
    problem.iterated = std::move(choice.iterated);
    problem.cuts = std::move(choice.text);
    return fields;
  }
  try {
    input::ErrorList ofCuts;
    fields = joinParts(scene, choice.pieces, comm, problem, ofCuts);
    throwTogether(ofCuts, comm);
  } catch (const base::Error& error) {
    if (error.code() != base::ExitCode::input) throw;
    return joinParts(scene, {}, comm, problem, errors);
  }
  problem.pieces = std::move(choice.pieces);
  problem.cuts = std::move(choice.text);
  return fields;
}

}  // namespace

Problem makeProblem(const Scene& scene, const Teuchos::Comm<int>& comm, base::Timers& timers, Cutting cutting) {
  const base::SoleThread inside(comm.getSize());
  input::ErrorList errors;
  Problem problem;
  {
    const auto reading = timers.start("read");
    const input::Parameters& source = scene.input.list("Mesh");
    errors.collect(source.where(), [&] { problem.mesh = makeMesh(source, scene.path, &problem.warnings); });
    throwTogether(errors, comm);
    checkDimensions(scene.input, problem.mesh.dimension, errors);
    throwTogether(errors, comm);
  }
  const auto assembling = timers.start("assemble");
  problem.model = makeModel(scene.input.list("Model"), problem.mesh);
  const auto fields = cutting == Cutting::automatic ? joinCutParts(scene, comm, problem, errors)
                                                    : joinParts(scene, {}, comm, problem, errors);
  assembly::Assembly& assembly = problem.assembly;
  assembly.owner = distribute(problem.bodies, comm.getSize());
  problem.bodies.congruences =
      findCongruences(problem.bodies, problem.mesh, problem.model.kinematics, assembly.interfaces);
  assembly.bodies = assemble(scene, problem.mesh, problem.model, problem.bodies, *problem.temperatures, *fields,
                             assembly.owner, comm.getRank(), errors);
  throwTogether(errors, comm);
  problem.warnings.insert(problem.warnings.begin(), scene.warnings.begin(), scene.warnings.end());
  for (const JoinedMeshes& joined : problem.joined) {
    for (std::string& warning : joined.warnings()) problem.warnings.push_back(std::move(warning));
  }
  for (std::string& warning : coarseCohesiveZones(scene, assembly, problem.bodies, problem.model)) {
    problem.warnings.push_back(std::move(warning));
  }
  for (std::string& warning : unresolvedFields(scene.input, assembly, problem.model)) {
    problem.warnings.push_back(std::move(warning));
  }
  return problem;
}

}  // namespace harmos::scene
