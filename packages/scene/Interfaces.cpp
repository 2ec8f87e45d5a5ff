#include <harmos/scene/Interfaces.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <harmos/base/Names.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/laws/FieldLaw.hpp>
#include <harmos/laws/TurnedLaw.hpp>
#include <harmos/mesh/InterfaceFrame.hpp>
#include <harmos/scene/FaceNames.hpp>
#include <harmos/scene/TurnedPlaces.hpp>
#include <harmos/scene/detail/CancelledNormal.hpp>
#include <harmos/scene/detail/PairCarriers.hpp>

namespace harmos::scene {

namespace {

/// Binds laws of whole faces to those that all interfaces of their name make together.
void bindToFaces(int dimension, std::vector<assembly::Interface>& interfaces) {
  std::map<std::string, std::vector<std::pair<base::Vector3, double>>> points;  // with their areas
  for (const assembly::Interface& interface : interfaces) {
    if (dynamic_cast<const laws::FaceLaw*>(interface.law.get()) == nullptr) continue;
    for (int p = 0; p < interface.pairs(); ++p) {
      points[interface.name].emplace_back(interface.position[p], interface.area[p]);
    }
  }
  std::map<std::string, std::shared_ptr<const laws::InterfaceLaw>> bound;
  for (assembly::Interface& interface : interfaces) {
    const auto* law = dynamic_cast<const laws::FaceLaw*>(interface.law.get());
    if (law == nullptr) continue;
    auto& ofName = bound[interface.name];
    const auto face = ofName ? std::nullopt : laws::FaceMotions::of(points[interface.name], dimension);
    if (face) ofName = law->on(std::make_shared<const laws::FaceMotions>(*face));
    if (ofName) interface.law = ofName;
  }
}

/// Numbers the faces of laws over whole faces: an interface between two parts is one, whatever pieces they are cut
/// into, and so are a boundary and the two faces of a law that joins such.
void numberFaces(const std::vector<mesh::Piece>& pieces, std::vector<assembly::Interface>& interfaces) {
  const auto partOf = [&](int body) { return body < 0 ? std::string() : pieces[body].part; };
  std::map<std::array<std::string, 3>, int> faces;
  for (assembly::Interface& interface : interfaces) {
    if (!laws::isCoupled(*interface.law)) continue;
    std::array<std::string, 3> key{nameOfList(interface.name), "", ""};
    if (interface.sides() == 2) key = {interface.name, partOf(interface.body1), partOf(interface.body2)};
    interface.face = faces.emplace(key, static_cast<int>(faces.size())).first->second;
  }
}

/// Makes the laws of all places where numbers vary over the surface, so that their errors come before the solution.
void prepareFields(const std::vector<assembly::Interface>& interfaces,
                   const std::shared_ptr<const laws::SpatialFields>& fields) {
  input::ErrorList errors;
  for (const assembly::Interface& interface : interfaces) {
    const auto* law = dynamic_cast<const laws::FieldFollower*>(interface.law.get());
    if (law == nullptr) continue;
    errors.collect(base::quoted(interface.name), [&] {
      law->bind(fields);
      law->prepare(interface.position);
    });
  }
  errors.throwIfAny();
}

/// Makes area times n the integral of N n over the faces. Where n would point inwards the area is negative, as at the
/// corners of quadratic quadrilaterals; where the integral is 0, as at those of triangles, the area is.
void alignWithNormal(const base::Vector3& flux, int dimension, base::Frame& frame, double& area) {
  const double size = norm(flux);
  const double sign = dot(flux, frame[0]) < 0.0 ? -1.0 : 1.0;
  if (size > cancelledNormal * std::abs(area)) frame = mesh::frameFromNormal(sign * flux, dimension);
  area = sign * size;
}

}  // namespace

Interfaces makeInterfaces(const Scene& scene, int dimension, const std::vector<mesh::Piece>& pieces,
                          std::vector<mesh::InterfaceSurface>& surfaces, bool isConsistent,
                          const std::shared_ptr<const laws::SpatialFields>& fields) {
  const auto carriers = carriersOf(scene, pieces, dimension, isConsistent, surfaces);
  Interfaces made;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const mesh::InterfaceSurface& surface = surfaces[s];
    made.places.emplace_back(static_cast<std::size_t>(surface.pairs()));
    assembly::Interface interface;
    const auto law = scene.laws.find(surface.name);
    interface.law = law == scene.laws.end() ? scene.cutLaw : law->second;
    interface.name = surface.name;
    interface.body1 = surface.piece1;
    interface.body2 = surface.piece2;
    interface.isCut = surface.piece2 >= 0 && pieces[surface.piece1].part == pieces[surface.piece2].part &&
                      pieces[surface.piece1].side == pieces[surface.piece2].side;
    // Such a traction acts along the normals of the faces, which a mean normal times an area would exaggerate.
    const auto* turned = laws::roleOf<laws::TurnedLaw>(*interface.law);
    const bool isNodal = isOfNodes(scene, surface.name);
    const bool isAlongNormals = interface.law->prescribesTraction() && interface.law->frame() == laws::Frame::interface;
    for (int p = 0; p < surface.pairs(); ++p) {
      if (carriers[s][p].surface != static_cast<int>(s) || carriers[s][p].pair != p) continue;
      made.places[s][p] = {static_cast<int>(made.interfaces.size()), interface.pairs()};
      interface.trace1.appendFrom(surface.trace1, p);
      if (surface.piece2 >= 0) interface.trace2.appendFrom(surface.trace2, p);
      interface.position.push_back(surface.position[p]);
      interface.frame.push_back(turned == nullptr ? surface.frame[p] : turned->axesAt(surface.position[p]));
      interface.area.push_back(interface.law->prescribesTraction() && !isNodal ? surface.share[p] : surface.area[p]);
      if (isAlongNormals) alignWithNormal(surface.flux[p], dimension, interface.frame.back(), interface.area.back());
      interface.gap.push_back(surface.gap[p]);
    }
    if (interface.pairs() == 0) continue;
    // What is linear over the face keeps its moments with lumped areas.
    const bool isOfFace =
        laws::isCoupled(*interface.law) || dynamic_cast<const laws::FaceLaw*>(interface.law.get()) != nullptr;
    if (isConsistent && !isAlongNormals && !isOfFace && !isNodal) {
      for (const mesh::MassEntry& entry : surface.mass) {
        interface.mass.push_back({entry.row, entry.column, entry.value});
      }
    }
    made.interfaces.push_back(std::move(interface));
  }
  bindToFaces(dimension, made.interfaces);
  numberFaces(pieces, made.interfaces);
  prepareFields(made.interfaces, fields);
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    for (std::size_t p = 0; p < carriers[s].size(); ++p) {
      const mesh::PairCarrier& carrier = carriers[s][p];
      if (carrier.surface < 0) continue;
      made.places[s][p] = made.places[carrier.surface][carrier.pair];
    }
  }
  return made;
}

}  // namespace harmos::scene
