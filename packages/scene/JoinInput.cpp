#include <harmos/scene/detail/JoinInput.hpp>

namespace harmos::scene {
namespace {

const char* const sideNames[] = {"Side 1", "Side 2"};

// Laws that do not ask for the gap would bond what is apart, and parts are to touch: only facets of one curved surface
// are apart then.
constexpr double touching = 0.1;  // over the longest edge

}  // namespace

void describeJoining(input::ParameterSpec& spec) {
  spec.text("Points On")
      .defaultValue("Automatic")
      .oneOf({"Automatic", sideNames[0], sideNames[1]})
      .doc(
          "Where meshes do not match: the side whose corner nodes carry the tractions. Automatic: one that covers less "
          "than nine tenths of the other's faces, else a part more than three times softer, else the coarser mesh, "
          "else "
          "the softer part, else the smaller surface. Naming one joins matching meshes in this way, too.");
  spec.text("Gap")
      .defaultValue("Geometric")
      .oneOf({"Geometric", "Closed"})
      .doc("Where meshes do not match: gaps and overlaps between facets count, or are closed.");
  spec.number("Closed Within")
      .unit("length")
      .optional()
      .above(0.0)
      .doc("With Gap = Closed: only gaps and overlaps up to this are closed.");
  spec.number("Search Distance")
      .unit("length")
      .optional()
      .above(0.0)
      .doc(
          "Where meshes do not match: how far apart faces may be along their normals; absent: the length of their "
          "longest edge, and a tenth of it between two parts and for laws that do not ask for gaps. Between two parts "
          "all faces within it are joined, those that do not touch as well.");
}

bool isJoiningAskedFor(const input::Parameters& list) {
  return list.text("Points On") != "Automatic" || (list.has("Part 1") && list.has("Search Distance"));
}

mortar::JoinOptions joinOptions(const input::Parameters& list, const laws::InterfaceLaw& law,
                                const mesh::Depth& depth) {
  mortar::JoinOptions options;
  if (law.bonds() || law.isAffine() || list.has("Part 1")) options.reach.relative = touching;
  for (int side = 0; side < 2; ++side) {
    if (list.text("Points On") == sideNames[side]) options.pointsOn = side;
  }
  if (list.text("Gap") == "Closed") options.gap = mortar::GapTreatment::closed;
  if (list.has("Closed Within")) {
    options.gap = mortar::GapTreatment::closedWithin;
    options.within = list.number("Closed Within");
  }
  if (list.has("Search Distance")) options.reach.distance = list.number("Search Distance");
  // A stress has another traction on either side of a crease, whatever the law makes of normals.
  options.creaseAngle = list.number("Crease Angle");
  options.hasPointsAtCreases = law.creases() != laws::Creases::ignore;
  options.depth = depth;
  return options;
}

}  // namespace harmos::scene
