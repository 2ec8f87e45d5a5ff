#include <harmos/scene/detail/Surfaces.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/laws/AffineComponent.hpp>
#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/FieldLaw.hpp>
#include <harmos/laws/TurnedLaw.hpp>
#include <harmos/mesh/Skin.hpp>
#include <harmos/mortar/GroundSurfaces.hpp>
#include <harmos/scene/FaceNames.hpp>
#include <harmos/scene/TurnedPlaces.hpp>
#include <harmos/scene/detail/AxisBoundaries.hpp>
#include <harmos/scene/detail/CancelledNormal.hpp>
#include <harmos/scene/detail/HeldByBoundaries.hpp>
#include <harmos/scene/detail/JoinInput.hpp>
#include <harmos/scene/detail/MeshJoiner.hpp>
#include <harmos/scene/detail/PairCarriers.hpp>
#include <harmos/scene/detail/PartPairs.hpp>

namespace harmos::scene {

namespace {

using input::Parameters;

/// Counts places that a law cannot be given to, and keeps the first of them.
struct Misfits {
  int count = 0;
  base::Vector3 first{};

  void add(const base::Vector3& place) {
    if (count++ == 0) first = place;
  }
  std::string text() const {
    std::ostringstream out;
    out << count << (count == 1 ? " node" : " nodes, the first of them") << " at (" << first[0] << ", " << first[1]
        << ", " << first[2] << ")";
    return out.str();
  }
};

/// A law that depends on the normal needs one at every node, and some need that there is only one.
void checkNormals(const laws::InterfaceLaw& law, const std::vector<mesh::InterfaceSurface>& surfaces) {
  if (law.creases() == laws::Creases::ignore) return;
  Misfits without, several;
  for (const mesh::InterfaceSurface& surface : surfaces) {
    for (int p = 0; p < surface.pairs(); ++p) {
      if (isCopy(surface, p)) continue;
      const base::Vector3& place = surface.position[p];
      if (norm(surface.normal[p]) <= cancelledNormal * surface.area[p]) without.add(place);
      if (surface.patch[p] == 1) several.add(place);
    }
  }
  if (without.count > 0) {
    throw base::Error(
        "\"" + std::string(law.name()) + "\" depends on the normal, which " + without.text() +
            " does not have: inside of a part, or where normals cancel.\n  Choose nodes of a surface, or a "
            "law in global components.",
        base::ExitCode::input);
  }
  if (law.creases() == laws::Creases::refuse && several.count > 0) {
    throw base::Error("\"" + std::string(law.name()) +
                          "\" has no meaning at a crease, where the normal is not unique: " + several.text() +
                          ".\n  Divide the faces there into several sets, or raise Crease Angle.",
                      base::ExitCode::input);
  }
}

/// A law with axes of its own must have them everywhere; distances to it are means between nodes.
void checkAxes(const laws::InterfaceLaw& law, const Model& model, const mesh::Mesh& mesh, int steps,
               const std::vector<mesh::Piece>& pieces, std::vector<mesh::InterfaceSurface>& surfaces) {
  const auto* turned = laws::roleOf<laws::TurnedLaw>(law);
  if (turned == nullptr) return;
  turned->demandModel(mesh.dimension, elasticity::isAxisymmetric(model.kinematics));
  std::vector<base::Vector3> places;
  Misfits away;
  for (mesh::InterfaceSurface& surface : surfaces) {
    std::vector<base::Vector3> nodes;
    for (const int node : pieces[surface.piece1].nodes) nodes.push_back(mesh.nodes[node]);
    const auto more = placesOfNodes(surface.trace1, nodes);
    places.insert(places.end(), more.begin(), more.end());
    measureGaps(*turned, nodes, surface);
    for (int p = 0; p < surface.pairs() && turned->isOutside(); ++p) {
      const double outwards = dot(turned->axesAt(surface.position[p])[0], surface.normal[p]);
      if (outwards <= cancelledNormal * surface.area[p]) away.add(surface.position[p]);
    }
  }
  if (away.count > 0) {
    throw base::Error(base::quoted(law.name()) + " lies on the other side of the part as seen from " + away.text() +
                          ", whose faces look away from it.\n  Name the faces that look at the tool, or move the tool.",
                      base::ExitCode::input);
  }
  turned->demandPlaces(places, steps);
}

using FacePoints = std::vector<std::pair<base::Vector3, double>>;

/// A law that acts on the mean motion of a face needs one that can be turned about every axis.
void checkFace(const laws::InterfaceLaw& law, const Model& model, int dimension,
               const std::vector<mesh::InterfaceSurface>& surfaces) {
  if (dynamic_cast<const laws::FaceLaw*>(&law) == nullptr) return;
  const std::string name = base::quoted(law.name());
  const auto refuse = [](const std::string& text) { throw base::Error(text, base::ExitCode::input); };
  if (elasticity::isAxisymmetric(model.kinematics)) {
    refuse(name + " has no meaning in axisymmetry.\n  Model the part in space, or load it by tractions.");
  }
  FacePoints points;
  for (const mesh::InterfaceSurface& surface : surfaces) {
    for (int p = 0; p < surface.pairs(); ++p) points.emplace_back(surface.position[p], surface.share[p]);
  }
  if (laws::FaceMotions::of(points, dimension)) return;
  refuse(name + " turns its face, but all nodes here lie on one line or in one point.\n  Choose a larger face.");
}

/// Whether the tractions of a law need no field of their own: they are given, or what they hold or join, node by node.
bool actsOnNodes(const laws::InterfaceLaw& given, int steps) {
  const laws::InterfaceLaw& law = *laws::roleOf<laws::InterfaceLaw>(given);  // what joins the sides varies nowhere
  if (law.prescribesTraction()) return true;
  if (laws::isCoupled(law)) {
    const auto* ofFace = dynamic_cast<const laws::FaceLaw*>(&law);
    return ofFace == nullptr || !ofFace->leavesFaceFree();
  }
  if (!law.isAffine()) return false;
  for (int t = 0; t < steps; ++t) {
    for (const laws::AffineComponent& component : laws::affineComponents(law, t)) {
      if (component.stiffness != 0.0 && !std::isinf(component.stiffness)) return false;
    }
  }
  return true;
}

/// How many quadratic faces there are on which a law needs tractions between the nodes: areas of nodes are no weights
/// for them there.
std::size_t countUnsuitedFaces(const laws::InterfaceLaw& law, const mesh::Mesh& mesh, int steps,
                               const std::vector<mesh::InterfaceSurface>& surfaces) {
  if (actsOnNodes(law, steps)) return 0;
  std::size_t count = 0;
  for (const mesh::InterfaceSurface& surface : surfaces) {
    count += std::count_if(surface.face.begin(), surface.face.end(), [&](const std::vector<int>& face) {
      return static_cast<int>(face.size()) > mesh::cornersOfFace(mesh.dimension, face.size());
    });
  }
  return count;
}

/// The surfaces of an interface whose sides are joined by mortar integrals, matching or not.
std::vector<mesh::InterfaceSurface> joinedSurfacesOf(const Parameters& list, const mesh::PartPair& parts,
                                                     const mesh::InterfaceFinder& finder,
                                                     const mesh::InterfaceFinder::Joiner& join) {
  if (list.has("Part 1")) return finder.joinedParts(list.name(), parts.first, parts.second, join);
  return finder.joinedSideSets(list.name(), list.text("Side 1"), list.text("Side 2"), join);
}

/// Makes surfaces of this name of the faces of a side set by mortar integrals; `where` is for messages.
using Grounding = std::function<std::vector<mesh::InterfaceSurface>(const std::string& name, const std::string& where,
                                                                    const std::string& sideSet)>;

/// Gives a law that needs it points between which tractions are linear, where it acts on quadratic faces.
void suitQuadraticFaces(const Parameters& list, const mesh::PartPair& parts, const laws::InterfaceLaw& law,
                        const mesh::Mesh& mesh, int steps, const mesh::InterfaceFinder& finder,
                        const mesh::InterfaceFinder::Joiner& join, const Grounding& ground,
                        std::vector<mesh::InterfaceSurface>& surfaces) {
  const std::size_t count = countUnsuitedFaces(law, mesh, steps, surfaces);
  if (count == 0) return;
  if (list.has("Part 1") || (list.has("Side 1") && !list.has("Projection Direction"))) {
    surfaces = joinedSurfacesOf(list, parts, finder, join);
    return;
  }
  if (list.has("Side Set")) {
    surfaces = ground(list.name(), base::quoted(list.name()), list.text("Side Set"));
    return;
  }
  if (laws::isCoupled(law)) return;  // nodes have no faces: they count with their areas
  throw base::Error(
      "\"" + std::string(law.name()) + "\" cannot act on faces of quadratic elements here, of which there are " +
          std::to_string(count) +
          ".\n  Name the faces by a side set and leave out Projection Direction, mesh the part with linear "
          "elements, or choose a law that holds or loads the faces.",
      base::ExitCode::input);
}

/// `parts`: of an interface that is given by parts, else nothing.
std::vector<mesh::InterfaceSurface> surfacesOf(const Parameters& list, const mesh::PartPair& parts, double creaseAngle,
                                               const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
                                               const mesh::InterfaceFinder& finder,
                                               const mesh::InterfaceFinder::Joiner& join) {
  const std::string& name = list.name();
  if (list.has("Side Set")) return finder.onSideSet(name, list.text("Side Set"), creaseAngle);
  if (list.has("Node Set")) {
    return finder.onNodeSet(name, list.text("Node Set"), list.has("Part") ? list.text("Part") : "", creaseAngle);
  }
  const bool isJoined = isJoiningAskedFor(list);
  if (list.has("Part 1")) {
    return isJoined ? joinedSurfacesOf(list, parts, finder, join)
                    : finder.betweenParts(name, parts.first, parts.second, creaseAngle, join);
  }
  const auto parts1 = partsOf(list.text("Side 1"), mesh, pieces);
  if (parts1.size() == 1 && parts1 == partsOf(list.text("Side 2"), mesh, pieces)) {
    throw base::Error("both sides belong to the part \"" + *parts1.begin() + "\".\n  An interface joins two parts.",
                      base::ExitCode::input);
  }
  std::optional<base::Vector3> projection;
  if (list.has("Projection Direction")) {
    const auto& given = list.numbers("Projection Direction");
    std::copy(given.begin(), given.end(), projection.emplace(base::Vector3{}).begin());
  }
  if (isJoined) return joinedSurfacesOf(list, parts, finder, join);
  return finder.betweenSideSets(name, list.text("Side 1"), list.text("Side 2"), projection, creaseAngle, join);
}

/// The pieces of a part share nodes, of which some may be tied already: only what keeps them together acts there.
void checkSection(const laws::InterfaceLaw& law, int steps) {
  if (law.bonds() || (actsOnNodes(law, steps) && !law.prescribesTraction())) return;
  throw base::Error("\"" + std::string(law.name()) +
                        "\" cannot act on a plane through one part, where both sides stay together.\n  Choose "
                        "Pretension, Preload Jump or Perfect, or divide the part into two blocks there.",
                    base::ExitCode::input);
}

/// The surfaces of a law between two faces that are apart.
std::pair<std::vector<mesh::InterfaceSurface>, std::vector<mesh::InterfaceSurface>> facesApart(
    const Parameters& list, const laws::InterfaceLaw& law, const mesh::Mesh& mesh, int steps,
    const mesh::InterfaceFinder& finder, const Grounding& ground) {
  const auto on = [&](const std::string& name, const char* side) {
    finder.demandSurface(base::quoted(list.name()), list.text(side));
    auto surfaces = finder.onSideSet(name, list.text(side));
    if (countUnsuitedFaces(law, mesh, steps, surfaces) == 0) return surfaces;
    return ground(name, base::quoted(list.name()), list.text(side));
  };
  return {on(list.name(), "Side 1"), on(nameOfOtherFace(list.name()), "Side 2")};
}

/// The surfaces between the pieces of parts; those between the sides of a plane belong to its interface.
std::vector<mesh::InterfaceSurface> cutsOf(const Bodies& bodies, const mesh::InterfaceFinder& finder) {
  std::vector<mesh::InterfaceSurface> cuts = finder.cuts();
  for (mesh::InterfaceSurface& cut : cuts) {
    if (bodies.pieces[cut.piece1].side != bodies.pieces[cut.piece2].side) cut.name = bodies.parts[cut.piece1].section;
  }
  return cuts;
}

}  // namespace

Surfaces findSurfaces(const Scene& scene, const mesh::Mesh& mesh, const Model& model, const Bodies& bodies,
                      const mesh::InterfaceFinder& finder, input::ErrorList& errors) {
  const std::vector<mesh::Piece>& pieces = bodies.pieces;
  Surfaces surfaces;
  const auto append = [&](std::vector<mesh::InterfaceSurface> found) {
    std::move(found.begin(), found.end(), std::back_inserter(surfaces.all));
  };
  std::optional<mortar::HeldDirections> held;  // once it is asked for
  const int before = errors.count();
  PartPairs partPairs(scene.input, mesh, pieces);
  for (const char* kind : {"Interfaces", "Boundaries"}) {
    for (const Parameters& list : scene.input.lists(kind)) {
      errors.collect(list.where(), [&] {
        const laws::InterfaceLaw& law = *scene.laws.at(list.name());
        if (std::string(kind) == "Interfaces" && list.has("Part")) {
          checkSection(law, static_cast<int>(scene.times.size()));
          return;  // it is found with the cuts
        }
        const bool isSplit = law.creases() != laws::Creases::ignore;
        const double creaseAngle = isSplit ? list.number("Crease Angle") : mesh::InterfaceFinder::oneNormal;
        const auto ground = [&](const std::string& name, const std::string& where, const std::string& sideSet) {
          return mortar::groundSurfaces(name, mesh, finder.facesOf(where, sideSet), creaseAngle, depthOf(model), pieces,
                                        finder.pieces());
        };
        const int steps = static_cast<int>(scene.times.size());
        if (const auto* ofFace = dynamic_cast<const laws::FaceLaw*>(&law); ofFace != nullptr && ofFace->onOtherFace()) {
          auto [first, second] = facesApart(list, law, mesh, steps, finder, ground);
          checkFace(law, model, mesh.dimension, first);
          checkFace(law, model, mesh.dimension, second);
          append(std::move(first));
          append(std::move(second));
          return;
        }
        const auto join = [&](const std::string& name1, const std::vector<mesh::Face>& side1, const std::string& name2,
                              const std::vector<mesh::Face>& side2) {
          if (!held) held = heldByBoundaries(scene, elasticity::componentsOf(model.kinematics), pieces, finder);
          const MeshJoiner joiner(list, law, depthOf(model), *held, mesh, bodies, finder);
          return joiner.join(name1, side1, name2, side2, surfaces.joined, surfaces.crossed);
        };
        const auto pairs = list.has("Part 1") ? partPairs.of(list) : std::vector<mesh::PartPair>(1);
        std::vector<mesh::InterfaceSurface> found;
        for (const mesh::PartPair& pair : pairs) {
          auto more = surfacesOf(list, pair, creaseAngle, mesh, pieces, finder, join);
          suitQuadraticFaces(list, pair, law, mesh, steps, finder, join, ground, more);
          std::move(more.begin(), more.end(), std::back_inserter(found));
        }
        if (!surfaces.crossed.empty()) return;  // all are found again
        for (const char* entry : {"Side Set", "Side 1", "Side 2"}) {
          if (list.has(entry)) finder.demandSurface("\"" + list.name() + "\"", list.text(entry));
        }
        if (elasticity::isAxisymmetric(model.kinematics) && std::string(kind) == "Boundaries")
          demandNothingAlongAxis(list, law, steps, mesh, pieces, finder, found);
        checkNormals(law, found);
        checkAxes(law, model, mesh, steps, pieces, found);
        checkFace(law, model, mesh.dimension, found);
        demandOnePart(law, mesh, pieces, found);
        append(std::move(found));
      });
    }
  }
  if (!surfaces.crossed.empty()) {
    surfaces.all.clear();
    return surfaces;
  }
  if (errors.count() > before) return surfaces;  // else parts would be reported that a faulty interface should touch
  for (const Parameters& part : scene.input.lists("Parts")) {
    const bool isTouched = std::any_of(surfaces.all.begin(), surfaces.all.end(), [&](const auto& surface) {
      const auto is = [&](int piece) { return piece >= 0 && pieces[piece].part == part.name(); };
      return is(surface.piece1) || is(surface.piece2);
    });
    if (!isTouched) {
      errors.add(part.where(), "no interface and no boundary touches this part, so that nothing holds it.",
                 "Add an interface to another part, or a boundary.");
    }
  }
  append(cutsOf(bodies, finder));
  return surfaces;
}

}  // namespace harmos::scene
