#include "TwoBoxes.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include <harmos/files/ExodusWriter.hpp>

using namespace harmos::files;

namespace {

int hexahedron(const ResultMesh::Block& block, int element, int corner) {
  return block.connectivity[8 * static_cast<std::size_t>(element) + static_cast<std::size_t>(corner)];
}

void addBox(ResultMesh& mesh, const std::string& name, double bottom, bool shuffled) {
  const int first = static_cast<int>(mesh.nodes.size());
  const auto number = [&](int i, int j, int k) {
    const int position = (k * 3 + j) * 3 + i;
    return first + (shuffled ? 17 - position : position);
  };
  mesh.nodes.resize(mesh.nodes.size() + 18);
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) mesh.nodes[number(i, j, k)] = {0.5 * i, 0.5 * j, bottom + k};
  ResultMesh::Block block{name, "HEX8", 8, {}};
  std::vector<std::array<int, 8>> elements;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i)
      elements.push_back({number(i, j, 0), number(i + 1, j, 0), number(i + 1, j + 1, 0), number(i, j + 1, 0),
                          number(i, j, 1), number(i + 1, j, 1), number(i + 1, j + 1, 1), number(i, j + 1, 1)});
  if (shuffled) {
    std::reverse(elements.begin(), elements.end());
    for (auto& e : elements) e = {e[1], e[2], e[3], e[0], e[5], e[6], e[7], e[4]};
  }
  for (const auto& e : elements) block.connectivity.insert(block.connectivity.end(), e.begin(), e.end());
  mesh.blocks.push_back(block);
}

/// The tests' own directory, removed when the program ends.
struct TemporaryDirectory {
  TemporaryDirectory() : path(std::filesystem::path(::testing::TempDir()) / ("harmos_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path);
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::filesystem::path path;
};

}  // namespace

ResultMesh twoBoxes(bool shuffled) {
  ResultMesh mesh;
  if (shuffled) {
    addBox(mesh, "upper", 1.0, true);
    addBox(mesh, "lower", 0.0, true);
  } else {
    addBox(mesh, "lower", 0.0, false);
    addBox(mesh, "upper", 1.0, false);
  }
  const int lower = shuffled ? 4 : 0, upper = shuffled ? 0 : 4;
  harmos::mesh::SideSet side1{"contact_1", 0, {}, {}}, side2{"contact_2", 0, {}, {}};
  for (int e = 0; e < 4; ++e) {
    side1.element.push_back(lower + e);
    side1.side.push_back(5);
    side2.element.push_back(upper + e);
    side2.side.push_back(4);
  }
  mesh.sideSets = {side1, side2};
  return mesh;
}

ResultVariables boxVariables() {
  return {{"disp_x", "disp_y", "disp_z"}, {"von_mises"}, {"u_load"}};
}

ResultStep boxStep(const ResultMesh& mesh, double time) {
  ResultStep step = zeroStep(mesh, boxVariables(), time);
  std::size_t element = 0;
  for (const auto& block : mesh.blocks) {
    const double jump = block.name == "upper" ? 10.0 : 0.0;  // tells coincident nodes of the two boxes apart
    for (int e = 0; e < block.elements(); ++e) {
      for (int k = 0; k < 8; ++k) {
        const auto node = static_cast<std::size_t>(hexahedron(block, e, k));
        const auto& x = mesh.nodes[node];
        step.nodal[0][node] = time * (jump + x[0] + 2.0 * x[1] + 4.0 * x[2]);
        step.nodal[2][node] = time * x[2];
        step.element[0][element] += time * (jump + x[0] + 3.0 * x[1]) / 8.0;
      }
      ++element;
    }
  }
  step.global[0] = 0.1 * time;
  return step;
}

std::string temporaryFile(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  static const TemporaryDirectory directory;
  return (directory.path / (std::string(test->test_suite_name()) + "_" + test->name() + "_" + name)).string();
}

void writeBoxes(const std::string& path, bool shuffled, void (*change)(ResultStep&, int)) {
  ExodusWriter writer(path, "two boxes", twoBoxes(shuffled), boxVariables());
  for (int i = 0; i < 3; ++i) {
    auto step = boxStep(writer.mesh(), i);
    if (change) change(step, i);
    writer.write(step);
  }
  writer.commit();
}
