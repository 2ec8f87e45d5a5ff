#include <harmos/scene/detail/PairCarriers.hpp>

#include <map>
#include <sstream>
#include <tuple>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/laws/FieldLaw.hpp>
#include <harmos/laws/NodalLaw.hpp>

namespace harmos::scene {
namespace {

using Carriers = std::vector<std::vector<mesh::PairCarrier>>;

Carriers everyPairItself(const Scene& scene, const std::vector<mesh::Piece>& pieces,
                         const std::vector<mesh::InterfaceSurface>& surfaces) {
  Carriers carriers;
  std::map<std::tuple<std::string, std::string, int>, mesh::PairCarrier> first;  // by interface, part and mesh node
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const mesh::InterfaceSurface& surface = surfaces[s];
    const bool isOnce = isOfNodes(scene, surface.name);
    auto& pairs = carriers.emplace_back();
    for (int p = 0; p < surface.pairs(); ++p) {
      mesh::PairCarrier carrier = isCopy(surface, p) ? mesh::PairCarrier{} : mesh::PairCarrier{static_cast<int>(s), p};
      if (isOnce) {
        const mesh::Piece& piece = pieces[surface.piece1];
        const std::tuple node(surface.name, piece.part, piece.nodes[surface.trace1.node(p)]);
        carrier = first.emplace(node, carrier).first->second;
      }
      pairs.push_back(carrier);
    }
  }
  return carriers;
}

}  // namespace

bool isCopy(const mesh::InterfaceSurface& surface, int p) {
  return surface.area[p] == 0.0;
}

bool isOfNodes(const Scene& scene, const std::string& interface) {
  const auto law = scene.laws.find(interface);
  return law != scene.laws.end() && laws::roleOf<laws::NodalLaw>(*law->second) != nullptr;
}

void demandOnePart(const laws::InterfaceLaw& law, const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
                   const std::vector<mesh::InterfaceSurface>& surfaces) {
  if (laws::roleOf<laws::NodalLaw>(law) == nullptr) return;
  std::map<int, std::string> partOf;
  for (const mesh::InterfaceSurface& surface : surfaces) {
    const mesh::Piece& piece = pieces[surface.piece1];
    for (int p = 0; p < surface.pairs(); ++p) {
      const int node = piece.nodes[surface.trace1.node(p)];
      const std::string& part = partOf.emplace(node, piece.part).first->second;
      if (part == piece.part) continue;
      std::ostringstream place;
      place << "(" << mesh.nodes[node][0] << ", " << mesh.nodes[node][1] << ", " << mesh.nodes[node][2] << ")";
      throw base::Error("the node at " + place.str() + " belongs to the parts " + base::quoted(part) + " and " +
                            base::quoted(piece.part) + ", and each would take the force.\n  Name one of them as Part.",
                        base::ExitCode::input);
    }
  }
}

std::vector<std::vector<mesh::PairCarrier>> carriersOf(const Scene& scene, const std::vector<mesh::Piece>& pieces,
                                                       int dimension, bool isConsistent,
                                                       std::vector<mesh::InterfaceSurface>& surfaces) {
  return isConsistent ? everyPairItself(scene, pieces, surfaces)
                      : mesh::mergeRedundantPairs(pieces, dimension, surfaces);
}

}  // namespace harmos::scene
