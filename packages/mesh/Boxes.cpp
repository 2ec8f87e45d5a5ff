#include <harmos/mesh/Boxes.hpp>

#include <cmath>
#include <limits>
#include <set>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/mesh/detail/StructuredMesh.hpp>

namespace harmos::mesh {
namespace {

constexpr const char* corners[] = {"Lower Corner", "Upper Corner"};

constexpr double mostNodes = std::numeric_limits<int>::max();

/// What is wrong with a box in a mesh of this many dimensions; empty when nothing is.
std::string faultOf(const Box& box, int dimension) {
  if (dimensionOf(box.element) != dimension) {
    return std::string("its elements ") + exodusName(box.element) + " do not fit the first box, which has " +
           std::to_string(dimension) + " dimensions; all boxes must be either in the plane or in space.";
  }
  double nodes = 1.0;
  for (int d = 0; d < dimension; ++d) {
    if (!(box.lower[d] < box.upper[d])) return "Lower Corner must lie below Upper Corner in every direction.";
    if (box.cells[d] < 1) return "Cells must be at least 1 in every direction.";
    nodes *= box.cells[d] + 1.0;
  }
  if (nodes > mostNodes) return "it has " + base::toText(nodes) + " nodes, but a mesh has at most 2147483647.";
  return "";
}

/// Throws base::Error(input) when numbers are missing, or Element does not exist in so many dimensions.
Box readBox(const input::Parameters& parameters) {
  const auto refuse = [](const std::string& what) { throw base::Error(what, base::ExitCode::input); };
  Box box;
  box.name = parameters.name();
  const auto& lower = parameters.numbers(corners[0]);
  const auto& upper = parameters.numbers(corners[1]);
  const auto& cells = parameters.numbers("Cells");
  const std::size_t dimension = lower.size();
  if (dimension < 2 || dimension > 3 || upper.size() != dimension || cells.size() != dimension) {
    refuse("Lower Corner, Upper Corner and Cells have " + std::to_string(dimension) + ", " +
           std::to_string(upper.size()) + " and " + std::to_string(cells.size()) +
           " numbers; give 2 of each in the plane or 3 in space.");
  }
  for (std::size_t d = 0; d < dimension; ++d) {
    box.lower[d] = lower[d];
    box.upper[d] = upper[d];
    if (cells[d] != std::floor(cells[d]) || std::abs(cells[d]) > 1e6) refuse("Cells must be whole numbers up to 1e6.");
    box.cells[d] = static_cast<int>(cells[d]);
  }
  const int space = static_cast<int>(dimension);
  box.element = dimension == 2 ? ElementType::quad4 : ElementType::hex8;
  if (parameters.has("Element")) {
    const std::string& name = parameters.text("Element");
    const auto type = elementTypeFromExodus(name, space, std::stoi(name.substr(name.find_first_of("0123456789"))));
    if (!type) refuse("Element = " + name + " does not exist in " + std::to_string(space) + " dimensions.");
    box.element = *type;
  }
  return box;
}

/// Throws base::Error(input) as boxes().
StructuredMesh plan(const std::vector<Box>& list) {
  if (list.empty()) throw base::Error("Boxes: give at least one box.", base::ExitCode::input);
  const int dimension = dimensionOf(list.front().element);
  StructuredMesh mesh(dimension);
  std::set<std::string> names;
  for (const Box& box : list) {
    const std::string fault =
        names.insert(box.name).second ? faultOf(box, dimension) : "there are two boxes of this name; rename one.";
    if (!fault.empty()) throw base::Error("Boxes, box \"" + box.name + "\": " + fault, base::ExitCode::input);
    double size = 0.0;
    for (int d = 0; d < dimension; ++d) {
      size = std::max(size, box.upper[d] - box.lower[d]);
    }
    mesh.addBlock(box.name, box.element);
    mesh.addGrid(box.cells, boxMap(box.lower, box.upper));
    for (int d = 0; d < dimension; ++d) {
      const auto at = [d, tolerance = 1e-9 * size](double x) {
        return [=](const base::Vector3& p) { return std::abs(p[d] - x) < tolerance; };
      };
      const std::string side = box.name + "_" + "xyz"[d];
      mesh.addSideSet(side + "min", box.name, at(box.lower[d]));
      mesh.addSideSet(side + "max", box.name, at(box.upper[d]));
    }
  }
  return mesh;
}

/// Throws base::Error(input) with all that is wrong.
std::vector<Box> boxesOf(const input::Parameters& parameters) {
  input::ErrorList errors;
  std::vector<Box> list = readBoxes(parameters, errors);
  errors.throwIfAny();
  return list;
}

}  // namespace

input::ParameterSpec describeBoxes() {
  input::ParameterSpec spec("Boxes");
  spec.summary(
      "Any number of boxes of equal cells. Each is a block of its own name with side sets NAME_xmin, "
      "NAME_xmax and so on; boxes share no nodes.");
  input::ParameterSpec& box = spec.namedLists("Boxes", true);
  box.numbers(corners[0]).unit("length").doc("Lowest coordinates, 2 numbers in the plane or 3 in space.");
  box.numbers(corners[1]).unit("length").doc("Highest coordinates.");
  box.numbers("Cells").doc("Number of cells in each direction.");
  box.text("Element")
      .optional()
      .oneOf({"Hex8", "Wedge6", "Tet4", "Pyramid5", "Quad4", "Tri3", "Hex20", "Hex27", "Wedge15", "Tet10", "Quad8",
              "Quad9", "Tri6"})
      .doc("Element that the cells are divided into; Hex8 in space and Quad4 in the plane when not given.");
  return spec;
}

Mesh boxes(const std::vector<Box>& list) {
  return plan(list).take();
}

std::vector<Box> readBoxes(const input::Parameters& parameters, input::ErrorList& errors) {
  std::vector<Box> list;
  for (const input::Parameters& box : parameters.lists("Boxes")) {
    errors.collect(box.where(), [&] {
      list.push_back(readBox(box));
      const std::string fault = faultOf(list.back(), dimensionOf(list.front().element));
      if (!fault.empty()) throw base::Error(fault, base::ExitCode::input);
    });
  }
  return list;
}

Mesh boxes(const input::Parameters& parameters) {
  return boxes(boxesOf(parameters));
}

std::vector<BlockSize> boxesSizes(const input::Parameters& parameters) {
  return plan(boxesOf(parameters)).sizes();
}

}  // namespace harmos::mesh
