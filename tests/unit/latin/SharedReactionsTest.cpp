// What faces and boundaries that meet at nodes share between them is not determined, and what they do not share is.
#include <gtest/gtest.h>

#include <harmos/latin/detail/SharedReactions.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"
#include "Faces.hpp"

namespace harmos::latin {
namespace {

using Law = std::shared_ptr<const laws::InterfaceLaw>;
using Open = SharedReactions::Open;

Law remote(const std::string& kind, const std::vector<std::string>& held) {
  input::Parameters law("law");
  law.set("Type", std::string("Remote Displacement")).set("Kind", kind);
  for (const std::string& name : held) law.set(name, 0.0);
  return laws::builtInLaws().create(law);
}

Law bed() {
  return laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 0.0}});
}

/// Whether the forces along x, y and z of an interface are open: "-": no, "n": at nodes, "f": at faces.
std::string openForces(BoxAssembly boxes, int interface) {
  const assembly::Assembly& assembly = boxes.assembly();
  const assembly::SearchDirection searchDirection(assembly, 1.0, *self());
  const EliminatedBoundaries eliminated(assembly, searchDirection, Elimination::rigid,
                                        resistedMotions(assembly, *self()));
  const SharedReactions reactions(assembly, searchDirection, eliminated);
  std::string text;
  for (std::size_t c = 0; c < 3; ++c) {
    const Open open = reactions.leaveOpen([&](int i, int pair) {
      base::Vector3 weight{};
      if (i == interface) weight[c] = assembly.interfaces[i].area[pair];
      return weight;
    });
    text += open == Open::no ? '-' : open == Open::atNodes ? 'n' : 'f';
  }
  return text;
}

/// A cube on a bed, with as many elements along z, and one face that is held as a whole; its force.
std::string onABed(const std::string& kind, const std::vector<std::string>& held, int elements = 2,
                   const std::string& face = "cube_xmin") {
  BoxAssembly cube({{"cube", {0, 0, 0}, {1, 1, 1}, {2, 2, elements}}});
  cube.hold("bed", "cube_zmin", bed());
  holdFace(cube, {face}, remote(kind, held));
  return openForces(cube, 1);
}

const std::vector<std::string> all = {"X", "Y", "Z", "Rotation X", "Rotation Y", "Rotation Z"};

TEST(SharedReactions, OfBoundariesAreOpenWhereBothHoldANode) {
  BoxAssembly cube({{"cube", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}});
  cube.hold("bed", "cube_zmin", bed());
  cube.hold("side", "cube_xmin", laws::makeLaw("Prescribed Displacement", {{"Y", 0.0}}));
  cube.hold("top", "cube_zmax", laws::makeLaw("Prescribed Displacement", {{"X", 0.0}}));
  EXPECT_EQ(openForces(cube, 0), "-n-");
  EXPECT_EQ(openForces(cube, 1), "-n-");
  EXPECT_EQ(openForces(cube, 2), "---");
}

TEST(SharedReactions, OfARigidFaceAreOpenWhereItHoldsTheirResultant) {
  EXPECT_EQ(onABed("Rigid", all), "fff");
  EXPECT_EQ(onABed("Rigid", all, 2, "cube_zmax"), "---");
  // Forces along x at the edge turn the face about y; the turn of others in its plane forces along it can take back.
  EXPECT_EQ(onABed("Rigid", {"X"}), "---");
  EXPECT_EQ(onABed("Rigid", {"X", "Rotation Y"}), "f--");
  EXPECT_EQ(onABed("Rigid", {"Y"}), "-f-");
  EXPECT_EQ(onABed("Rigid", {"Z"}), "--f");
  EXPECT_EQ(onABed("Rigid", {"Rotation X", "Rotation Y", "Rotation Z"}), "---");
}

// Its tractions go linearly across it, so that they act on other nodes than those of an edge, but of one element.
TEST(SharedReactions, OfAFaceThatMayDeformAreOpenWhereAllThatTheyActOnIsHeld) {
  EXPECT_EQ(onABed("Distributing", all), "---");
  EXPECT_EQ(onABed("Distributing", all, 1), "f--");
  EXPECT_EQ(onABed("Distributing", {"X", "Y", "Z"}, 1), "---");
  EXPECT_EQ(onABed("Distributing", {"X", "Rotation Y"}, 2, "cube_zmin"), "f--");
}

// What joins two parts passes on what faces on both of them bear.
TEST(SharedReactions, OfFacesArePassedOnByJoints) {
  const auto openAt = [](const Law& joint, const std::string& right, const std::vector<std::string>& held) {
    BoxAssembly cubes({{"left", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {"right", {1, 0, 0}, {2, 1, 1}, {2, 2, 2}}});
    cubes.join("joint", "left_xmax", "right_xmin", joint);
    holdFace(cubes, {"left_zmin"}, remote("Rigid", all));
    holdFace(cubes, {right}, remote("Rigid", held));
    return openForces(cubes, 2);
  };
  const Law perfect = laws::makeLaw("Perfect");
  EXPECT_EQ(openAt(perfect, "right_zmin", all), "fff");
  EXPECT_EQ(openAt(perfect, "right_zmin", {"Y"}), "-f-");
  EXPECT_EQ(openAt(perfect, "right_zmax", all), "---");
  EXPECT_EQ(openAt(laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 1.0}, {"Tangential Stiffness", 1.0}}),
                   "right_zmin", all),
            "---");
}

}  // namespace
}  // namespace harmos::latin
