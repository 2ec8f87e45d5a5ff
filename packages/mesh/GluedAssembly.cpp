#include <harmos/mesh/GluedAssembly.hpp>

#include <cmath>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/mesh/detail/StructuredMesh.hpp>

namespace harmos::mesh {
namespace {

struct Rectangle {
  const char* name;
  double x1, x2, y1, y2;
};

constexpr Rectangle parts[] = {
    {"base", 0.0, 21.0, 0.0, 95.0}, {"middle", 21.0, 34.0, 45.0, 145.0}, {"top", 34.0, 42.0, 95.0, 240.0}};
constexpr double roundOff = 1e-9;

StructuredMesh::Region box(double x1, double x2, double y1, double y2) {
  return [=](const base::Vector3& p) {
    return p[0] > x1 - roundOff && p[0] < x2 + roundOff && p[1] > y1 - roundOff && p[1] < y2 + roundOff;
  };
}

/// Throws base::Error(input) as gluedAssembly().
StructuredMesh plan(double cellSize) {
  const double perUnit = 1.0 / cellSize;
  if (!(cellSize > 0.0) || perUnit < 0.5 || std::abs(perUnit - std::round(perUnit)) > 1e-6 * perUnit) {
    std::ostringstream message;
    message << "Glued Assembly: Cell Size = " << cellSize
            << " does not fit: give 1 mm divided by a whole number, for example 1, 0.5 or 0.25.";
    throw base::Error(message.str(), base::ExitCode::input);
  }
  const auto cells = [perUnit](double from, double to) { return static_cast<int>(std::lround((to - from) * perUnit)); };
  StructuredMesh mesh(2);
  for (const Rectangle& part : parts) {
    mesh.addBlock(part.name, ElementType::quad4);
    mesh.addGrid({cells(part.x1, part.x2), cells(part.y1, part.y2), 0},
                 boxMap({part.x1, part.y1, 0.0}, {part.x2, part.y2, 0.0}));
  }
  mesh.addSideSet("clamped", "base", box(0.0, 21.0, 0.0, 0.0));
  mesh.addSideSet("glue_1_1", "base", box(21.0, 21.0, 45.0, 95.0));
  mesh.addSideSet("glue_1_2", "middle", box(21.0, 21.0, 45.0, 95.0));
  mesh.addSideSet("glue_2_1", "middle", box(34.0, 34.0, 95.0, 145.0));
  mesh.addSideSet("glue_2_2", "top", box(34.0, 34.0, 95.0, 145.0));
  mesh.addSideSet("loaded", "top", box(34.0, 42.0, 240.0, 240.0));
  mesh.addNodeSet("point_a", "top", box(38.0, 38.0, 240.0, 240.0));
  return mesh;
}

}  // namespace

input::ParameterSpec describeGluedAssembly() {
  input::ParameterSpec spec("Glued Assembly");
  spec.summary("Three plane parts joined by two glue lines; square quadrilaterals, lengths in mm.")
      .source("after the second example of Champaney, Blanze, Boucard (2004)");
  spec.number("Cell Size")
      .unit("length")
      .defaultValue(0.5)
      .atLeast(0.01)
      .atMost(1.0)
      .doc("Side of the cells, 1 mm divided by a whole number; 0.5 gives 17820 elements.");
  return spec;
}

Mesh gluedAssembly(double cellSize) {
  return plan(cellSize).take();
}

Mesh gluedAssembly(const input::Parameters& parameters) {
  return gluedAssembly(parameters.number("Cell Size"));
}

std::vector<BlockSize> gluedAssemblySizes(const input::Parameters& parameters) {
  return plan(parameters.number("Cell Size")).sizes();
}

}  // namespace harmos::mesh
