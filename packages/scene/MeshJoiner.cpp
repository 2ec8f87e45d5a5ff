#include <harmos/scene/detail/MeshJoiner.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/mortar/JoinSurfaces.hpp>
#include <harmos/mortar/PieceSurfaces.hpp>
#include <harmos/scene/detail/JoinInput.hpp>

namespace harmos::scene {
namespace {

/// Whether a law may give tractions along the surface; also when it does not say so.
bool carriesShear(const laws::InterfaceLaw& law) {
  const auto admissible = law.admissibleTractions(0);
  return !admissible || admissible->friction > 0.0 || admissible->upper[1] > 0.0 || admissible->upper[2] > 0.0;
}

}  // namespace

MeshJoiner::MeshJoiner(const input::Parameters& list, const laws::InterfaceLaw& law, const mesh::Depth& depth,
                       const mortar::HeldDirections& held, const mesh::Mesh& mesh, const Bodies& bodies,
                       const mesh::InterfaceFinder& finder)
    : name_(list.name()),
      isOfSideSets_(list.has("Side 1")),
      hasGaps_(!law.bonds() && !law.isAffine()),
      options_(joinOptions(list, law, depth)),
      mesh_(mesh),
      bodies_(bodies),
      finder_(finder) {
  if (carriesShear(law)) options_.held = held;
}

std::string MeshJoiner::partOf(const mesh::Face& face) const {
  return finder_.pieces().part(finder_.pieces().of(face.element));
}

double MeshJoiner::stiffnessOf(const std::vector<mesh::Face>& side) const {
  if (side.empty()) return 0.0;
  const auto c = bodies_.materials[finder_.pieces().of(side[0].element)]->elasticity();
  return (c[0][0] + c[1][1] + c[2][2]) / 3.0;
}

void MeshJoiner::demandTwoParts(const std::vector<mesh::Face>& side1, const std::vector<mesh::Face>& side2) const {
  std::set<std::string> parts;
  for (const mesh::Face& face : side1) parts.insert(partOf(face));
  for (const mesh::Face& face : side2) {
    if (parts.count(partOf(face)) == 0) continue;
    throw base::Error("Interface \"" + name_ + "\": both sides belong to part \"" + partOf(face) +
                          "\"; an interface joins two parts. Divide the part into two blocks there.",
                      base::ExitCode::input);
  }
}

bool MeshJoiner::keepTogether(const std::vector<mesh::Face>& side, const std::string& remedy,
                              KeptTogether& crossed) const {
  std::map<std::string, std::set<int>> nodes;
  for (const mesh::Face& face : side) nodes[partOf(face)].insert(face.nodes.begin(), face.nodes.end());
  bool isNew = false;
  for (const auto& [part, ofPart] : nodes) {
    const std::vector<int> list(ofPart.begin(), ofPart.end());
    const auto known = bodies_.together.find(part);
    const auto isSame = [&list = list](const mesh::Together& other) { return other.nodes == list; };
    if (known != bodies_.together.end() && std::any_of(known->second.begin(), known->second.end(), isSame)) continue;
    crossed[part].push_back({list, remedy});
    isNew = true;
  }
  return isNew;
}

std::string MeshJoiner::pointsMoved(int side, const std::vector<mesh::Face>& other) const {
  std::set<std::string> ofOther;
  for (const mesh::Face& face : other) ofOther.insert(partOf(face));
  std::set<std::string> cut;
  for (const mesh::Piece& piece : bodies_.pieces) {
    if (piece.name != piece.part && piece.side == 0 && ofOther.count(piece.part) > 0) cut.insert(piece.part);
  }
  return "give interface " + base::quoted(name_) + " Points On = Side " + std::to_string(side + 1) +
         (cut.empty() ? ""
                      : (cut.size() == 1 ? " and part " : " and parts ") + base::joinNames({cut.begin(), cut.end()}) +
                            " Pieces = 1");
}

std::vector<mesh::InterfaceSurface> MeshJoiner::join(const std::string& name1, const std::vector<mesh::Face>& side1,
                                                     const std::string& name2, const std::vector<mesh::Face>& side2,
                                                     std::vector<JoinedMeshes>& reports, KeptTogether& crossed) const {
  demandTwoParts(side1, side2);
  const mortar::Side one{name1, side1, stiffnessOf(side1)}, two{name2, side2, stiffnessOf(side2)};
  const auto joined = mortar::joinSurfaces("Interface \"" + name_ + "\"", mesh_, one, two, options_);
  const mortar::PieceSurfaces divided =
      mortar::divideByPieces(name_, joined, one, two, bodies_.pieces, finder_.pieces());
  if (divided.crossed[0] + divided.crossed[1] == 0) {
    reports.push_back(
        {name_, joined.pointsOn, static_cast<int>(joined.area.size()), joined.report, isOfSideSets_, hasGaps_});
    return divided.surfaces;
  }
  // The points stay where they are: what an interface is shall not depend on cuts.
  const auto isNew = [&](int side, const std::vector<mesh::Face>& ofIt, const std::vector<mesh::Face>& other) {
    if (divided.crossed[side] == 0) return false;
    return keepTogether(ofIt, joined.pointsOn == side ? "" : pointsMoved(side, other), crossed);
  };
  const bool isNew1 = isNew(0, side1, side2), isNew2 = isNew(1, side2, side1);
  if (isNew1 || isNew2) return {};
  const int side = divided.crossed[0] > 0 ? 0 : 1;
  const bool isWithPoints = joined.pointsOn == side;
  const base::Vector3& place = divided.firstCrossed;
  std::ostringstream message;
  message << "Interface \"" << name_ << "\": its meshes do not match, and cuts of " << (side == 0 ? name1 : name2)
          << " into pieces cross what " << divided.crossed[side] << (divided.crossed[side] == 1 ? " point" : " points")
          << (isWithPoints ? " of it see" : " of the other side see of it") << ", the first at (" << place[0] << ", "
          << place[1] << ", " << place[2] << "). ";
  if (isWithPoints) {
    message << "Points see several nodes of their own side where its faces are quadratic or covered in part, or held "
               "beside them. Use ";
  } else {
    message << "Cut only one of both parts and give Points On = Side " << side + 1 << ", or use ";
  }
  message << "Pieces = 1 for part \"" << partOf((side == 0 ? side1 : side2)[0]) << "\".";
  throw base::Error(message.str(), base::ExitCode::input);
}

}  // namespace harmos::scene
