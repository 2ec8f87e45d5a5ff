#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

#include <unistd.h>

#include <exodusII.h>
#include <netcdf.h>

#include <harmos/base/Error.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/files/ExodusMesh.hpp>
#include <harmos/mesh/BoltedJoint.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/mesh/PointSearch.hpp>

namespace harmos::files {
namespace {

std::vector<std::int64_t> fromOne(const std::vector<int>& numbers) {
  std::vector<std::int64_t> result;
  for (const int number : numbers) result.push_back(number + 1);
  return result;
}

/// Writes meshes in all the ways that other programs do.
class ExodusMesh : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directory(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// With a `type` blocks say that their elements are of it, all blocks or the first one only.
  std::string write(const mesh::Mesh& mesh, int mode, const std::string& type = "", bool isTypeOfAll = true) {
    std::string path = (folder_ / "mesh.e").string();
    int computeWordSize = 8;
    int fileWordSize = 8;
    const int id = ex_create(path.c_str(), EX_CLOBBER | mode, &computeWordSize, &fileWordSize);
    EXPECT_GE(id, 0);
    ex_set_int64_status(id, ex_int64_status(id) | EX_ALL_INT64_API);
    ex_set_max_name_length(id, 80);
    const mesh::Elements elements(mesh);
    ex_put_init(id, "test", mesh.dimension, static_cast<std::int64_t>(mesh.nodes.size()), elements.count(),
                static_cast<std::int64_t>(mesh.blocks.size()), static_cast<std::int64_t>(mesh.nodeSets.size()),
                static_cast<std::int64_t>(mesh.sideSets.size()));
    std::vector<double> x[3];
    for (std::size_t d = 0; d < 3; ++d) {
      for (const base::Vector3& node : mesh.nodes) x[d].push_back(node[d]);
    }
    ex_put_coord(id, x[0].data(), x[1].data(), x[2].data());
    if (!mesh.numbering.node.empty()) ex_put_id_map(id, EX_NODE_MAP, mesh.numbering.node.data());
    if (!mesh.numbering.element.empty()) ex_put_id_map(id, EX_ELEM_MAP, mesh.numbering.element.data());
    for (const mesh::ElementBlock& block : mesh.blocks) {
      const bool isOther = !type.empty() && (isTypeOfAll || &block == mesh.blocks.data());
      ex_put_block(id, EX_ELEM_BLOCK, block.id, isOther ? type.c_str() : mesh::exodusName(block.type), block.elements(),
                   mesh::nodesPerElement(block.type), 0, 0, 0);
      ex_put_conn(id, EX_ELEM_BLOCK, block.id, fromOne(block.connectivity).data(), nullptr, nullptr);
      if (!block.name.empty()) ex_put_name(id, EX_ELEM_BLOCK, block.id, block.name.c_str());
    }
    for (const mesh::SideSet& set : mesh.sideSets) {
      ex_put_set_param(id, EX_SIDE_SET, set.id, static_cast<std::int64_t>(set.element.size()), 0);
      ex_put_set(id, EX_SIDE_SET, set.id, fromOne(set.element).data(), fromOne(set.side).data());
      if (!set.name.empty()) ex_put_name(id, EX_SIDE_SET, set.id, set.name.c_str());
    }
    for (const mesh::NodeSet& set : mesh.nodeSets) {
      ex_put_set_param(id, EX_NODE_SET, set.id, static_cast<std::int64_t>(set.node.size()), 0);
      ex_put_set(id, EX_NODE_SET, set.id, fromOne(set.node).data(), nullptr);
      if (!set.name.empty()) ex_put_name(id, EX_NODE_SET, set.id, set.name.c_str());
    }
    ex_close(id);
    return path;
  }

  std::string writeText(const std::string& content) {
    std::string path = (folder_ / "text.e").string();
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

  static std::string messageOf(const std::string& path) {
    try {
      readExodus(path);
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ExitCode::input);
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
      return error.what();
    }
    return "no error";
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("harmos_test_mesh_" + std::to_string(::getpid()));
};

void expectContains(const std::string& message, const std::string& fragment) {
  EXPECT_NE(message.find(fragment), std::string::npos) << message;
}

mesh::Mesh sample(mesh::ElementType type) {
  mesh::Mesh mesh = mesh::boxes(
      {{"left", {}, {1.0, 2.0, 3.0}, {2, 1, 2}, type}, {"right", {1.0, 0.0, 0.0}, {2.0, 2.0, 3.0}, {1, 1, 1}, type}});
  mesh.nodeSets = {{"held", 7, {0, 2, 4}}};
  return mesh;
}

TEST_F(ExodusMesh, ReadsEveryFormatAndElement) {
  for (const int mode : {EX_NORMAL_MODEL, EX_LARGE_MODEL, EX_NETCDF4, EX_NETCDF4 | EX_ALL_INT64_DB}) {
    for (const mesh::ElementType type :
         {mesh::ElementType::hex8, mesh::ElementType::tet4, mesh::ElementType::wedge6, mesh::ElementType::pyramid5,
          mesh::ElementType::quad4, mesh::ElementType::tri3}) {
      const mesh::Mesh mesh = sample(type);
      const mesh::Mesh read = readExodus(write(mesh, mode));
      EXPECT_EQ(read.dimension, mesh.dimension);
      EXPECT_EQ(read.nodes, mesh.nodes);
      ASSERT_EQ(read.blocks.size(), 2u);
      for (std::size_t b = 0; b < 2; ++b) {
        EXPECT_EQ(read.blocks[b].name, mesh.blocks[b].name);
        EXPECT_EQ(read.blocks[b].type, type);
        EXPECT_EQ(read.blocks[b].connectivity, mesh.blocks[b].connectivity);
      }
      ASSERT_EQ(read.sideSets.size(), mesh.sideSets.size());
      for (std::size_t s = 0; s < mesh.sideSets.size(); ++s) {
        EXPECT_EQ(read.sideSets[s].name, mesh.sideSets[s].name);
        EXPECT_EQ(read.sideSets[s].element, mesh.sideSets[s].element);
        EXPECT_EQ(read.sideSets[s].side, mesh.sideSets[s].side);
      }
      EXPECT_EQ(read.nodeSets.at(0).node, mesh.nodeSets[0].node);
      EXPECT_EQ(read.nodeSets.at(0).id, 7);
    }
  }
}

/// A square, as programs write it that use netCDF alone.
std::string writeSquareByNetcdf(const std::string& path) {
  int file = -1, nodes = -1, elements = -1, corners = -1, unused = -1;
  EXPECT_EQ(nc_create(path.c_str(), NC_CLOBBER | NC_64BIT_OFFSET, &file), NC_NOERR);
  nc_def_dim(file, "num_nodes", 4, &nodes);
  nc_def_dim(file, "num_el_in_blk1", 1, &elements);
  nc_def_dim(file, "num_nod_per_el1", 4, &corners);
  int count = -1, blocks = -1, x = -1, y = -1, connectivity = -1, ids = -1;
  nc_def_dim(file, "num_dim", 2, &unused);
  nc_def_dim(file, "num_elem", 1, &count);
  nc_def_dim(file, "num_el_blk", 1, &blocks);
  nc_def_var(file, "coordx", NC_DOUBLE, 1, &nodes, &x);
  nc_def_var(file, "coordy", NC_DOUBLE, 1, &nodes, &y);
  nc_def_var(file, "eb_prop1", NC_INT, 1, &blocks, &ids);
  nc_put_att_text(file, ids, "name", 2, "ID");
  const int shape[] = {elements, corners};
  nc_def_var(file, "connect1", NC_INT, 2, shape, &connectivity);
  nc_put_att_text(file, connectivity, "elem_type", 5, "QUAD4");
  const float version = 5.1F;
  const int wordSize = 8, isLarge = 1;
  nc_put_att_float(file, NC_GLOBAL, "api_version", NC_FLOAT, 1, &version);
  nc_put_att_float(file, NC_GLOBAL, "version", NC_FLOAT, 1, &version);
  nc_put_att_int(file, NC_GLOBAL, "floating_point_word_size", NC_INT, 1, &wordSize);
  nc_put_att_int(file, NC_GLOBAL, "file_size", NC_INT, 1, &isLarge);
  nc_put_att_text(file, NC_GLOBAL, "title", 6, "square");
  nc_enddef(file);
  const double places[] = {0.0, 2.0, 2.0, 0.0, 0.0, 0.0, 3.0, 3.0};
  const int numbers[] = {1, 2, 3, 4}, id = 1;
  nc_put_var_double(file, x, places);
  nc_put_var_double(file, y, places + 4);
  nc_put_var_int(file, ids, &id);
  nc_put_var_int(file, connectivity, numbers);
  EXPECT_EQ(nc_close(file), NC_NOERR);
  return path;
}

TEST_F(ExodusMesh, ReadsCoordinatesThatAreTheFirstVariable) {
  const mesh::Mesh mesh = readExodus(writeSquareByNetcdf((folder_ / "square.e").string()));
  ASSERT_EQ(mesh.nodes.size(), 4u);
  EXPECT_EQ(mesh.nodes[2], (base::Vector3{2.0, 3.0, 0.0}));
  EXPECT_EQ(mesh.nodes[1], (base::Vector3{2.0, 0.0, 0.0}));
}

TEST_F(ExodusMesh, NamesTheUnnamedAndKeepsLongNames) {
  mesh::Mesh mesh = sample(mesh::ElementType::hex8);
  const std::string longName(60, 'n');
  mesh.blocks[0].name = longName;
  mesh.blocks[1].name = "";
  mesh.blocks[1].id = 10;
  mesh.sideSets[0].name = "";
  mesh.sideSets[1].name = "  right face \t";
  mesh.nodeSets[0].name = "";
  const mesh::Mesh read = readExodus(write(mesh, EX_LARGE_MODEL));
  EXPECT_EQ(read.blocks[0].name, longName);
  EXPECT_EQ(read.blocks[1].name, "block_10");
  EXPECT_EQ(read.sideSets[0].name, "sideset_1");
  EXPECT_EQ(read.sideSets[1].name, "right face");
  EXPECT_EQ(read.nodeSets[0].name, "nodeset_7");
}

TEST_F(ExodusMesh, RefusesWhatIsNotSupported) {
  expectContains(messageOf(write(sample(mesh::ElementType::hex8), EX_LARGE_MODEL, "HEX27")),
                 "\"left\" HEX27 (8 nodes)");
  mesh::Mesh shell = mesh::boxes({{"skin", {}, {1.0, 1.0, 0.0}, {1, 1, 0}, mesh::ElementType::quad4}});
  shell.dimension = 3;
  expectContains(messageOf(write(shell, EX_LARGE_MODEL, "SHELL4")), "\"skin\" SHELL4 (4 nodes)");
  mesh::Mesh twins = sample(mesh::ElementType::hex8);
  twins.blocks[1].name = "left";
  expectContains(messageOf(write(twins, EX_LARGE_MODEL)), "two element blocks are named \"left\"");
}

// The first two sides of a shell are its faces.
TEST_F(ExodusMesh, CountsTheEdgesOfShellsFromThree) {
  mesh::Mesh shell = mesh::boxes({{"skin", {}, {1.0, 1.0, 0.0}, {1, 1, 0}, mesh::ElementType::quad4}});
  shell.dimension = 2;
  ASSERT_FALSE(shell.sideSets.empty());
  mesh::Mesh written = shell;
  for (mesh::SideSet& set : written.sideSets) {
    for (int& side : set.side) side += 2;
  }
  const mesh::Mesh read = readExodus(write(written, EX_LARGE_MODEL, "shell4"));
  EXPECT_EQ(read.blocks[0].type, mesh::ElementType::quad4);
  for (std::size_t s = 0; s < shell.sideSets.size(); ++s) EXPECT_EQ(read.sideSets[s].side, shell.sideSets[s].side);
  expectContains(messageOf(write(shell, EX_LARGE_MODEL, "SHELL4")),
                 "which is its face; in the plane there are edges only, sides 3 to 6");
  for (mesh::SideSet& set : written.sideSets) {
    for (int& side : set.side) side += 4;
  }
  expectContains(messageOf(write(written, EX_LARGE_MODEL, "SHELL")), "there are 6; it is damaged or truncated");
}

TEST_F(ExodusMesh, LeavesOutWhatNobodyUses) {
  const mesh::Mesh mesh = sample(mesh::ElementType::hex8);
  const std::string path = write(mesh, EX_LARGE_MODEL, "HEX27", false);
  expectContains(messageOf(path), "\"left\" HEX27 (8 nodes)");
  const mesh::Mesh read = readExodus(path, {"left"});
  EXPECT_EQ(read.unreadBlocks, std::vector<std::string>{"left"});
  ASSERT_EQ(read.blocks.size(), 1u);
  EXPECT_EQ(read.blocks[0].connectivity, mesh.blocks[1].connectivity);
  for (std::size_t s = 0; s < mesh.sideSets.size(); ++s) {
    const bool isLeft = mesh.sideSets[s].name.rfind("left", 0) == 0;
    EXPECT_EQ(read.sideSets[s].element, isLeft ? std::vector<int>{} : std::vector<int>{0});
  }
  EXPECT_TRUE(readExodus(write(mesh, EX_LARGE_MODEL), {"left"}).unreadBlocks.empty()) << "what can be read is read";
}

TEST_F(ExodusMesh, KnowsTheNumbersOfItsFile) {
  mesh::Mesh mesh = sample(mesh::ElementType::hex8);  // of 4 elements and 1
  EXPECT_EQ(elementName(readExodus(write(mesh, EX_LARGE_MODEL)), 4), "element 5 of \"mesh.e\" (block \"right\")");
  EXPECT_EQ(elementName(mesh, 4), "element 5 of the mesh (block \"right\")");
  mesh.numbering.element = {17, 4, 1017, 9, std::int64_t{1} << 40U};
  mesh.numbering.node.resize(mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) mesh.numbering.node[i] = static_cast<std::int64_t>(100 - i);
  const mesh::Mesh read = readExodus(write(mesh, EX_NETCDF4 | EX_ALL_INT64_DB));
  EXPECT_EQ(read.numbering.element, mesh.numbering.element);
  EXPECT_EQ(read.numbering.node, mesh.numbering.node);
  EXPECT_EQ(elementName(read, 2), "element 1017 of \"mesh.e\" (block \"left\")");
  EXPECT_EQ(nodeName(read, 1), "node 99 of \"mesh.e\" at (0.5, 0, 0)");

  mesh.numbering.element.back() = 88;
  EXPECT_EQ(readExodus(write(mesh, EX_LARGE_MODEL, "HEX27", false), {"left"}).numbering.element,
            std::vector<std::int64_t>{88})
      << "of what is read";
  mesh.numbering.element = {};
  EXPECT_EQ(readExodus(write(mesh, EX_LARGE_MODEL, "HEX27", false), {"left"}).numbering.element,
            std::vector<std::int64_t>{5})
      << "its position in the file";
  for (const std::int64_t useless : {0, 4}) {
    mesh.numbering.element = {17, 4, useless, 9, 3};
    EXPECT_TRUE(readExodus(write(mesh, EX_LARGE_MODEL)).numbering.element.empty()) << useless;
  }
}

TEST_F(ExodusMesh, RefusesWhatIsNoMesh) {
  expectContains(messageOf((folder_ / "nothing.e").string()), "there is no such file");
  expectContains(messageOf(folder_.string()), "it is not a file");
  expectContains(messageOf(writeText("")), "it is empty");
  expectContains(messageOf(writeText("solid cube")), "it is no Exodus file");
}

TEST_F(ExodusMesh, RecognisesTruncatedFiles) {
  for (const int mode : {EX_NORMAL_MODEL, EX_LARGE_MODEL, EX_NETCDF4}) {
    std::ifstream file(write(sample(mesh::ElementType::hex8), mode), std::ios::binary);
    std::ostringstream whole;
    whole << file.rdbuf();
    const std::string content = whole.str();
    for (const double part : {0.01, 0.3, 0.6, 0.9, 0.99}) {
      const auto bytes = static_cast<std::size_t>(part * static_cast<double>(content.size()));
      expectContains(messageOf(writeText(content.substr(0, bytes))), "it is truncated");
    }
  }
}

TEST_F(ExodusMesh, RefusesNumbersOutOfRange) {
  mesh::Mesh mesh = sample(mesh::ElementType::hex8);
  mesh.blocks[0].connectivity[3] = 1000;
  expectContains(messageOf(write(mesh, EX_LARGE_MODEL)), "element block \"left\" refers to node 1001");
  mesh = sample(mesh::ElementType::tet4);
  mesh.sideSets[0].side[0] = 4;
  expectContains(messageOf(write(mesh, EX_LARGE_MODEL)), "side set \"left_xmin\" refers to side 5 of TET4 element " +
                                                             std::to_string(mesh.sideSets[0].element[0] + 1) +
                                                             " of \"mesh.e\" (block \"left\"), there are 4");
  mesh = sample(mesh::ElementType::hex8);
  mesh.numbering.node.resize(mesh.nodes.size());
  std::iota(mesh.numbering.node.rbegin(), mesh.numbering.node.rend(), 71);
  mesh.nodes.back()[1] = std::nan("");
  expectContains(messageOf(write(mesh, EX_LARGE_MODEL)), "node 71 of \"mesh.e\" has a coordinate that is not a number");
  mesh.nodes.back()[1] = -2e100;
  expectContains(messageOf(write(mesh, EX_LARGE_MODEL)), "node 71 of \"mesh.e\" has a coordinate beyond 1e100");
}

/// Files that are not part of the project: HARMOS_SHARED is the folder that holds them.
std::string sharedFile(const std::string& name) {
  const char* folder = std::getenv("HARMOS_SHARED");
  return folder == nullptr ? "" : (std::filesystem::path(folder) / name).string();
}

TEST(SharedMesh, BoltedJointIsTheReferenceMesh) {
  const std::string path = sharedFile("scenes/bolted-joint.e");
  if (path.empty()) GTEST_SKIP() << "HARMOS_SHARED is not set";
  const mesh::Mesh expected = readExodus(path);
  const mesh::Mesh mesh = mesh::boltedJoint();
  const mesh::Elements elements(mesh);
  const mesh::Elements expectedElements(expected);
  ASSERT_EQ(mesh.blocks.size(), expected.blocks.size());
  std::vector<int> number(expected.nodes.size());  // of the reference node's image
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    EXPECT_EQ(mesh.blocks[b].name, expected.blocks[b].name);
    const mesh::Piece part = mesh::makePiece(mesh, "ours", {mesh.blocks[b].name});
    const mesh::Piece reference = mesh::makePiece(expected, "theirs", {mesh.blocks[b].name});
    ASSERT_EQ(part.nodes.size(), reference.nodes.size());
    std::vector<base::Vector3> points;
    for (const int node : part.nodes) points.push_back(mesh.nodes[node]);
    const mesh::PointSearch search(points);
    for (const int node : reference.nodes) {
      const auto nearest = search.nearest(expected.nodes[node]);
      ASSERT_LT(nearest.distance, 1e-12);
      number[node] = part.nodes[nearest.index];
    }
    const auto keys = [&](const mesh::Elements& from, const mesh::Piece& of, bool isReference) {
      std::vector<std::vector<int>> result;
      for (const int element : of.elements) {
        result.emplace_back(from.nodes(element), from.nodes(element) + 8);
        for (int& node : result.back()) node = isReference ? number[node] : node;
        std::sort(result.back().begin(), result.back().end());
      }
      std::sort(result.begin(), result.end());
      return result;
    };
    EXPECT_EQ(keys(elements, part, false), keys(expectedElements, reference, true));
  }
  ASSERT_EQ(mesh.sideSets.size(), expected.sideSets.size());
  for (std::size_t s = 0; s < mesh.sideSets.size(); ++s) {
    EXPECT_EQ(mesh.sideSets[s].name, expected.sideSets[s].name);
    const auto keys = [&](const mesh::Elements& from, const mesh::SideSet& set, bool isReference) {
      std::vector<std::vector<int>> result;
      for (std::size_t i = 0; i < set.element.size(); ++i) {
        result.push_back(from.side(set.element[i], set.side[i]));
        for (int& node : result.back()) node = isReference ? number[node] : node;
        std::sort(result.back().begin(), result.back().end());
      }
      std::sort(result.begin(), result.end());
      return result;
    };
    EXPECT_EQ(keys(elements, mesh.sideSets[s], false), keys(expectedElements, expected.sideSets[s], true));
  }
}

TEST(SharedMesh, TurbineIsJoinedByWholeFaces) {
  const std::string path = sharedFile("meshes/lcm_turbine_tet4_3named.e");
  if (path.empty()) GTEST_SKIP() << "HARMOS_SHARED is not set";
  const mesh::Mesh mesh = readExodus(path);
  std::vector<mesh::Piece> parts;
  for (const mesh::ElementBlock& block : mesh.blocks) parts.push_back(mesh::makePiece(mesh, block.name, {block.name}));
  const mesh::InterfaceFinder finder(mesh, parts);
  for (const char* wheel : {"compressor", "turbine"}) {
    const auto joint = finder.betweenParts("joint", wheel, "middle");
    ASSERT_EQ(joint.size(), 1u);
    EXPECT_EQ(joint[0].pairs(), 19);
    EXPECT_EQ(joint[0].face.size(), 24u);
  }
  for (const auto& [set, nodes] : {std::pair("fixed", 184), std::pair("moving", 347)}) {
    const auto boundary = finder.onNodeSet(set, set);
    ASSERT_EQ(boundary.size(), 1u);
    EXPECT_EQ(boundary[0].pairs(), nodes);
    EXPECT_FALSE(boundary[0].face.empty());
  }
}

}  // namespace
}  // namespace harmos::files
