#include <harmos/scene/Bodies.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/ShareOut.hpp>
#include <harmos/elasticity/Stiffness.hpp>
#include <harmos/mesh/Congruence.hpp>
#include <harmos/mesh/Partition.hpp>
#include <harmos/mesh/PlaneCut.hpp>
#include <harmos/scene/detail/BodyLoads.hpp>

namespace harmos::scene {

namespace {

using input::Parameters;
using Names = std::vector<std::string>;

Names blocksOf(const Parameters& part) {
  return part.has("Blocks") ? part.texts("Blocks") : Names{part.name()};
}

/// Every block of the mesh belongs to exactly one part, or is declared unused.
void checkBlocks(const Scene& scene, const mesh::Mesh& mesh, input::ErrorList& errors) {
  Names known;
  for (const mesh::ElementBlock& block : mesh.blocks) known.push_back(block.name);
  known.insert(known.end(), mesh.unreadBlocks.begin(), mesh.unreadBlocks.end());
  std::map<std::string, std::string> usedAt;
  const auto use = [&](const std::string& block, const std::string& where) {
    if (std::find(known.begin(), known.end(), block) == known.end()) {
      errors.add(where, "the mesh has no element block \"" + block + "\".",
                 base::suggestName(block, known, "Element blocks"));
      return;
    }
    const auto [first, isNew] = usedAt.emplace(block, where);
    if (!isNew) {
      errors.add(where, "the element block \"" + block + "\" is used already at " + first->second + ".",
                 "An element block belongs to one part.");
    }
  };
  for (const Parameters& part : scene.input.lists("Parts")) {
    for (const std::string& block : blocksOf(part)) use(block, part.where("Blocks"));
  }
  const Parameters& source = scene.input.list("Mesh");
  if (source.has("Unused Blocks")) {
    for (const std::string& block : source.texts("Unused Blocks")) use(block, source.where("Unused Blocks"));
  }
  Names unused;
  for (const std::string& block : known) {
    if (usedAt.count(block) == 0) unused.push_back(block);
  }
  if (unused.empty()) return;
  errors.add(source.where(), "these element blocks belong to no part: " + base::joinNames(unused) + ".",
             "Add them to Parts, or to \"Unused Blocks\" of this list.");
}

bool isIsotropic(const elasticity::ElasticityMatrix& c) {
  const double tolerance = 1e-12 * c[0][0];
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      double expected = 0.0;
      if (i < 3 && j < 3) expected = i == j ? c[0][0] : c[0][1];
      if (i >= 3 && i == j) expected = 0.5 * (c[0][0] - c[0][1]);
      if (std::abs(c[i][j] - expected) > tolerance) return false;
    }
  }
  return true;
}

// Of the largest radius: radii of equal bodies differ by rounding.
constexpr double equalRadii = 1e-9;

/// Whether a motion leaves all nodes of a piece at their distance from the axis.
bool haveEqualRadii(const mesh::Mesh& mesh, const mesh::Piece& first, const mesh::Piece& second,
                    const std::vector<int>& image) {
  double largest = 0.0, difference = 0.0;
  for (std::size_t node = 0; node < image.size(); ++node) {
    const double radius = mesh.nodes[first.nodes[node]][0];
    largest = std::max(largest, std::abs(radius));
    difference = std::max(difference, std::abs(radius - mesh.nodes[second.nodes[image[node]]][0]));
  }
  return difference <= equalRadii * largest;
}

/// Whether a motion carries not only the elements of one body onto those of another, but also their stiffness.
bool keepsStiffness(const Bodies& bodies, const mesh::Mesh& mesh, elasticity::Kinematics kinematics, std::size_t first,
                    std::size_t second, const mesh::Congruence& congruence) {
  constexpr base::Frame identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (elasticity::isAxisymmetric(kinematics) &&
      !haveEqualRadii(mesh, bodies.pieces[first], bodies.pieces[second], congruence.node)) {
    return false;
  }
  return congruence.rotation == identity || isIsotropic(bodies.materials[first]->elasticity());
}

/// For every node of every body a number that tells how many joints it belongs to, and how many boundaries that do not
/// only load it.
std::vector<std::vector<int>> nodeKinds(const Bodies& bodies, const std::vector<assembly::Interface>& interfaces) {
  constexpr int boundary = 1024;
  std::vector<std::vector<int>> kinds;
  for (const mesh::Piece& piece : bodies.pieces) kinds.emplace_back(piece.nodes.size(), 0);
  for (const assembly::Interface& interface : interfaces) {
    if (interface.law->prescribesTraction()) continue;
    for (int side = 0; side < interface.sides(); ++side) {
      const mesh::TraceOperator& trace = interface.trace(side);
      for (int p = 0; p < trace.points(); ++p) {
        for (const mesh::TraceOperator::Entry& entry : trace.row(p))
          kinds[interface.body(side)][entry.node] += interface.sides() == 1 ? boundary : 1;
      }
    }
  }
  return kinds;
}

PartOptions optionsOf(const Parameters& part) {
  PartOptions options{part.name(),  part.where(), elasticity::formulationNamed(part.text("Formulation")),
                      std::nullopt, {},           false};
  options.iterates = part.has("Linear Solver") && part.text("Linear Solver") == "Iterative";
  if (part.hasList("Body Force")) {
    const Parameters& force = part.list("Body Force");
    options.bodyForce.emplace();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string name(1, "XYZ"[i]), field = name + " Field";
      (*options.bodyForce)[i] = {input::Field(force, name), force.has(field) ? force.text(field) : ""};
    }
  }
  return options;
}

/// The interface that divides a part along a plane; null: none.
const Parameters* sectionOf(const Scene& scene, const std::string& part) {
  for (const Parameters& interface : scene.input.lists("Interfaces")) {
    if (interface.has("Part") && interface.text("Part") == part) return &interface;
  }
  return nullptr;
}

/// The pieces of a part that the plane of an interface divides, each side with its share of them but at least one.
std::vector<mesh::Piece> dividedPart(const mesh::Mesh& mesh, const mesh::Piece& part, const Parameters& section,
                                     int count, const std::vector<mesh::Together>& together) {
  mesh::Plane plane;
  std::copy(section.numbers("Point").begin(), section.numbers("Point").end(), plane.point.begin());
  std::copy(section.numbers("Normal").begin(), section.numbers("Normal").end(), plane.normal.begin());
  auto [behind, beyond] = mesh::divideAlong(mesh, part, plane);
  const double share = static_cast<double>(behind.size()) / static_cast<double>(part.elements.size());
  const int first = std::clamp(static_cast<int>(std::lround(share * count)), 1, std::max(1, count - 1));
  std::vector<mesh::Piece> pieces;
  for (const int side : {-1, 1}) {
    const mesh::Piece half = mesh::makePiece(mesh, part.name, part.name, std::move(side < 0 ? behind : beyond));
    for (mesh::Piece& piece : mesh::cutPart(mesh, half, side < 0 ? first : std::max(1, count - first), together)) {
      piece.name = part.name + "." + std::to_string(pieces.size() + 1);
      piece.side = side;
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

}  // namespace

Model makeModel(const input::Parameters& parameters, const mesh::Mesh& mesh) {
  Model model;
  model.thickness = parameters.number("Thickness");
  model.kinematics =
      mesh.dimension == 3 ? elasticity::Kinematics::threeDimensional : elasticity::Kinematics::planeStrain;
  if (parameters.has("Kinematics")) model.kinematics = elasticity::kinematicsNamed(parameters.text("Kinematics"));
  return model;
}

mesh::Depth depthOf(const Model& model) {
  return elasticity::isAxisymmetric(model.kinematics) ? mesh::Depth::revolved() : mesh::Depth(model.thickness);
}

Bodies makeBodies(const Scene& scene, const mesh::Mesh& mesh, input::ErrorList& errors, const KeptTogether& together,
                  const std::map<std::string, int>& pieces) {
  checkBlocks(scene, mesh, errors);
  Bodies bodies;
  if (errors.count() > 0) return bodies;
  for (const Parameters& input : scene.input.lists("Parts")) {
    errors.collect(input.where(), [&] {
      const auto chosen = pieces.find(input.name());
      const int count = input.has("Pieces") ? input.integer("Pieces") : chosen != pieces.end() ? chosen->second : 1;
      PartOptions options = optionsOf(input);
      const mesh::Piece part = mesh::makePiece(mesh, input.name(), blocksOf(input));
      std::vector<mesh::Piece> made;
      const auto entry = together.find(input.name());
      const std::vector<mesh::Together> kept = entry == together.end() ? std::vector<mesh::Together>{} : entry->second;
      if (const Parameters* section = sectionOf(scene, input.name())) {
        options.section = section->name();
        errors.collect(section->where(), [&] { made = dividedPart(mesh, part, *section, count, kept); });
      } else {
        made = mesh::cutPart(mesh, part, count, kept);
      }
      for (mesh::Piece& piece : made) {
        bodies.pieces.push_back(std::move(piece));
        bodies.parts.push_back(options);
        bodies.materials.push_back(scene.materials.at(input.text("Material")));
        bodies.congruences.emplace_back();
      }
    });
  }
  return bodies;
}

std::vector<std::shared_ptr<const substructure::Congruence>> findCongruences(
    const Bodies& bodies, const mesh::Mesh& mesh, elasticity::Kinematics kinematics,
    const std::vector<assembly::Interface>& interfaces) {
  std::vector<std::shared_ptr<const substructure::Congruence>> congruences(bodies.pieces.size());
  const std::vector<std::vector<int>> kinds = nodeKinds(bodies, interfaces);
  // Of the bodies that equal each one, that one included, without repetition, in the order of its nodes.
  std::vector<std::vector<std::vector<int>>> known(bodies.pieces.size());
  for (std::size_t b = 0; b < congruences.size(); ++b) {
    for (std::size_t a = 0; a < b && !congruences[b]; ++a) {
      if (congruences[a] || bodies.materials[a] != bodies.materials[b] ||
          bodies.parts[a].formulation != bodies.parts[b].formulation) {
        continue;
      }
      const auto find = [&](const std::vector<int>& ofFirst, const std::vector<int>& ofSecond) {
        auto found = mesh::findCongruence(mesh, bodies.pieces[a], bodies.pieces[b], ofFirst, ofSecond);
        if (found && !keepsStiffness(bodies, mesh, kinematics, a, b, *found)) found.reset();
        return found;
      };
      std::optional<mesh::Congruence> found;
      for (std::size_t i = 0; i < known[a].size() && !found; ++i) found = find(known[a][i], kinds[b]);
      if (!found) found = find({}, {});
      if (!found) continue;
      std::vector<int> carried(found->node.size());
      for (std::size_t node = 0; node < carried.size(); ++node) carried[node] = kinds[b][found->node[node]];
      if (std::find(known[a].begin(), known[a].end(), carried) == known[a].end()) known[a].push_back(carried);
      auto congruence = std::make_shared<substructure::Congruence>();
      congruence->representative = static_cast<int>(a);
      congruence->node = std::move(found->node);
      congruence->rotation = found->rotation;
      congruences[b] = std::move(congruence);
    }
    if (!congruences[b]) known[b].push_back(kinds[b]);
  }
  return congruences;
}

std::vector<int> distribute(const Bodies& bodies, int ranks) {
  // A direct solve in space costs about n^(4/3); the solves, not the factorisation, are repeated.
  std::vector<double> cost;
  for (const mesh::Piece& piece : bodies.pieces)
    cost.push_back(std::pow(static_cast<double>(piece.nodes.size()), 4.0 / 3.0));
  return base::shareOut(cost, std::vector<double>(ranks, 0.0));
}

std::vector<substructure::Substructure> assemble(const Scene& scene, const mesh::Mesh& mesh, const Model& model,
                                                 const Bodies& bodies, const Temperatures& temperatures,
                                                 const laws::SpatialFields& fields, const std::vector<int>& owner,
                                                 int rank, input::ErrorList& errors) {
  const BodyLoads loads(scene, model.kinematics, temperatures, fields, errors);
  std::vector<substructure::Substructure> assembled(bodies.pieces.size());
  std::vector<bool> needsStiffness(assembled.size(), false);
  for (std::size_t b = 0; b < assembled.size(); ++b) {
    if (owner[b] != rank) continue;
    const auto& congruence = bodies.congruences[b];
    needsStiffness[congruence ? static_cast<std::size_t>(congruence->representative) : b] = true;
  }
  for (std::size_t b = 0; b < assembled.size(); ++b) {
    const mesh::Piece& piece = bodies.pieces[b];
    const PartOptions& part = bodies.parts[b];
    assembled[b].name = piece.name;
    assembled[b].part = piece.part;
    assembled[b].dimension = elasticity::componentsOf(model.kinematics);
    assembled[b].congruence = bodies.congruences[b];
    assembled[b].iterates = part.iterates;
    for (const int node : piece.nodes) assembled[b].nodes.push_back(mesh.nodes[node]);
    errors.collect(part.where, [&] {
      if (needsStiffness[b]) {
        assembled[b].stiffness = elasticity::assembleStiffness(mesh, piece, *bodies.materials[b], part.formulation,
                                                               model.kinematics, model.thickness);
      }
      if (owner[b] == rank) {
        assembled[b].loads = loads.of(
            {mesh, piece, *bodies.materials[b], part.formulation, model.kinematics, model.thickness}, part.bodyForce);
      }
    });
  }
  return assembled;
}

}  // namespace harmos::scene
