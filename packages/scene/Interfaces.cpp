#include <harmos/scene/Interfaces.hpp>

#include <algorithm>
#include <optional>
#include <set>

#include <harmos/base/Error.hpp>

namespace harmos::scene {

namespace {

using input::Parameters;

/// Names of the parts on which a side set lies; none if there is no such set.
std::set<std::string> partsOf(const std::string& sideSet, const mesh::Mesh& mesh,
                              const std::vector<mesh::Piece>& pieces) {
  std::set<std::string> names;
  for (const mesh::SideSet& set : mesh.sideSets) {
    if (set.name != sideSet) continue;
    for (const int element : set.element) {
      for (const mesh::Piece& piece : pieces) {
        if (std::binary_search(piece.elements.begin(), piece.elements.end(), element)) names.insert(piece.part);
      }
    }
  }
  return names;
}

std::vector<mesh::InterfaceSurface> surfacesOf(const Parameters& list, const mesh::Mesh& mesh,
                                               const std::vector<mesh::Piece>& pieces,
                                               const mesh::InterfaceFinder& finder) {
  const std::string& name = list.name();
  if (list.has("Side Set")) return finder.onSideSet(name, list.text("Side Set"));
  if (list.has("Node Set")) {
    return finder.onNodeSet(name, list.text("Node Set"), list.has("Part") ? list.text("Part") : "");
  }
  if (list.has("Part 1")) return finder.betweenParts(name, list.text("Part 1"), list.text("Part 2"));
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
  return finder.betweenSideSets(name, list.text("Side 1"), list.text("Side 2"), projection);
}

std::vector<std::vector<mesh::PairCarrier>> everyPairItself(const std::vector<mesh::InterfaceSurface>& surfaces) {
  std::vector<std::vector<mesh::PairCarrier>> carriers;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    auto& pairs = carriers.emplace_back();
    for (std::size_t p = 0; p < surfaces[s].node1.size(); ++p) {
      pairs.push_back({static_cast<int>(s), static_cast<int>(p)});
    }
  }
  return carriers;
}

}  // namespace

std::vector<mesh::InterfaceSurface> findSurfaces(const Scene& scene, const mesh::Mesh& mesh,
                                                 const std::vector<mesh::Piece>& pieces,
                                                 const mesh::InterfaceFinder& finder, input::ErrorList& errors) {
  std::vector<mesh::InterfaceSurface> surfaces;
  const auto append = [&](std::vector<mesh::InterfaceSurface> found) {
    std::move(found.begin(), found.end(), std::back_inserter(surfaces));
  };
  const int before = errors.count();
  for (const char* kind : {"Interfaces", "Boundaries"}) {
    for (const Parameters& list : scene.input.lists(kind)) {
      errors.collect(list.where(), [&] { append(surfacesOf(list, mesh, pieces, finder)); });
    }
  }
  if (errors.count() > before) return surfaces;  // else parts would be reported that a faulty interface should touch
  for (const Parameters& part : scene.input.lists("Parts")) {
    const bool isTouched = std::any_of(surfaces.begin(), surfaces.end(), [&](const mesh::InterfaceSurface& surface) {
      const auto is = [&](int piece) { return piece >= 0 && pieces[piece].part == part.name(); };
      return is(surface.piece1) || is(surface.piece2);
    });
    if (!isTouched) {
      errors.add(part.where(), "no interface and no boundary touches this part, so that nothing holds it.",
                 "Add an interface to another part, or a boundary.");
    }
  }
  append(finder.cuts());
  return surfaces;
}

Interfaces makeInterfaces(const Scene& scene, const std::vector<mesh::Piece>& pieces,
                          std::vector<mesh::InterfaceSurface>& surfaces, bool isConsistent) {
  const auto carriers = isConsistent ? everyPairItself(surfaces) : mesh::mergeRedundantPairs(pieces, surfaces);
  Interfaces made;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const mesh::InterfaceSurface& surface = surfaces[s];
    made.places.emplace_back(surface.node1.size());
    assembly::Interface interface;
    const auto law = scene.laws.find(surface.name);
    interface.law = law == scene.laws.end() ? scene.cutLaw : law->second;
    interface.name = surface.name;
    interface.body1 = surface.piece1;
    interface.body2 = surface.piece2;
    for (std::size_t p = 0; p < surface.node1.size(); ++p) {
      if (carriers[s][p].surface != static_cast<int>(s)) continue;
      made.places[s][p] = {static_cast<int>(made.interfaces.size()), interface.pairs()};
      interface.node1.push_back(surface.node1[p]);
      if (surface.piece2 >= 0) interface.node2.push_back(surface.node2[p]);
      interface.frame.push_back(surface.frame[p]);
      interface.area.push_back(surface.area[p]);
      interface.gap.push_back(surface.gap[p]);
    }
    if (interface.node1.empty()) continue;
    if (isConsistent) {
      for (const mesh::MassEntry& entry : surface.mass) {
        interface.mass.push_back({entry.row, entry.column, entry.value});
      }
    }
    made.interfaces.push_back(std::move(interface));
  }
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
