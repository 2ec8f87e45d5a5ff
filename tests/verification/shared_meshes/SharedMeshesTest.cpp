#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include <harmos/files/ExodusMesh.hpp>

#include "SolvedScene.hpp"

// Meshes of other projects, in the folder "meshes" of the environment variable HARMOS_SHARED; skipped without it.

namespace harmos::verification {
namespace {

struct File {
  const char* name;
  const char* file;
  const char* kind;  // of the sets
  const char* fixed;
  const char* moved;
};

std::string pathOf(const File& file) {
  const char* folder = std::getenv("HARMOS_SHARED");
  const auto path = std::filesystem::path(folder == nullptr ? "" : folder) / "meshes" / file.file;
  return folder != nullptr && std::filesystem::exists(path) ? path.string() : "";
}

std::string displacement(const std::string& name, const File& file, const char* set, const base::Vector3& u) {
  return xmlList(
      name, xmlText(file.kind, set) + xmlList("Law", xmlText("Type", "Prescribed Displacement") + xmlNumber("X", u[0]) +
                                                         xmlNumber("Y", u[1]) + xmlNumber("Z", u[2])));
}

SceneInput sceneOf(const File& file) {
  SceneInput scene = SceneInput::fromFile("shared_meshes/parts.xml");
  scene.add("Mesh", xmlText("File", pathOf(file)));
  scene.add("Boundaries", displacement("fixed", file, file.fixed, {0.0, 0.0, 0.0}));
  scene.add("Boundaries", displacement("moved", file, file.moved, {0.01, -0.02, 0.03}));
  return scene.add("Responses", forceResponse("x", "moved", {1.0, 0.0, 0.0}) +
                                    forceResponse("y", "moved", {0.0, 1.0, 0.0}) +
                                    forceResponse("z", "moved", {0.0, 0.0, 1.0}));
}

/// Every block a part of its own; perfect interfaces between all that share nodes.
SceneInput divided(const File& file) {
  const mesh::Mesh mesh = files::readExodus(pathOf(file));
  SceneInput scene = sceneOf(file);
  std::vector<std::set<int>> nodes;
  for (const auto& block : mesh.blocks) {
    scene.add("Parts", xmlList(block.name, xmlText("Material", "steel")));
    nodes.emplace_back(block.connectivity.begin(), block.connectivity.end());
  }
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    for (std::size_t b = a + 1; b < nodes.size(); ++b) {
      const bool share = std::any_of(nodes[a].begin(), nodes[a].end(), [&](int n) { return nodes[b].count(n) > 0; });
      if (!share) continue;
      scene.add("Interfaces", xmlList("joint_" + std::to_string(a) + "_" + std::to_string(b),
                                      xmlText("Part 1", mesh.blocks[a].name) + xmlText("Part 2", mesh.blocks[b].name) +
                                          xmlList("Law", xmlText("Type", "Perfect"))));
    }
  }
  return scene;
}

SceneInput whole(const File& file) {
  const mesh::Mesh mesh = files::readExodus(pathOf(file));
  std::string names;
  for (const auto& block : mesh.blocks) names += (names.empty() ? "" : ", ") + block.name;
  return sceneOf(file).add("Parts", xmlList("body", "<Parameter name=\"Blocks\" type=\"Array(string)\" value=\"{" +
                                                        names + "}\"/>" + xmlText("Material", "steel")));
}

class SharedMesh : public ::testing::TestWithParam<File> {};

TEST_P(SharedMesh, PartsEqualTheUncutBody) {
  const File& file = GetParam();
  if (pathOf(file).empty()) GTEST_SKIP() << "no " << file.file << " in $HARMOS_SHARED/meshes";
  const SolvedScene one(whole(file));
  ASSERT_TRUE(one.isCertified()) << one.result.reason;
  const SolvedScene several(divided(file));
  ASSERT_TRUE(several.isCertified()) << several.result.reason;
  // The accuracy of both, 1e-6, is a mean over interfaces; single nodes may be worse.
  EXPECT_LE(displacementDifference(several, one), 1e-5);
  const double force = std::hypot(one.value("x"), one.value("y"), one.value("z"));
  EXPECT_GT(force, 0.0);
  for (const char* name : {"x", "y", "z"}) EXPECT_NEAR(several.value(name), one.value(name), 4e-6 * force) << name;
}

const std::array<File, 4> files = {
    {{"Turbine", "lcm_turbine_tet4_3named.e", "Node Set", "fixed", "moving"},
     {"Wedges", "libmesh_wedge6_10blocks_longnames.e", "Side Set", "left", "right"},
     {"Pyramids", "libmesh_pyramid5_10blocks_longnames.e", "Side Set", "bottom", "top"},
     {"TwoBlocks", "seacas_two_block_hex8_12ss.g", "Side Set", "surface_1", "surface_12"}}};

INSTANTIATE_TEST_SUITE_P(Files, SharedMesh, ::testing::ValuesIn(files),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace harmos::verification
