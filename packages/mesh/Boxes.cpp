#include <harmos/mesh/Boxes.hpp>

#include <cmath>
#include <set>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/StructuredMesh.hpp>

namespace harmos::mesh {
namespace {

constexpr const char* corners[] = {"Lower Corner", "Upper Corner"};

[[noreturn]] void refuse(const std::string& box, const std::string& what) {
  throw base::Error("Boxes, box \"" + box + "\": " + what, base::ExitCode::input);
}

Box readBox(const base::Parameters& parameters) {
  Box box;
  box.name = parameters.name();
  const auto& lower = parameters.numbers(corners[0]);
  const auto& upper = parameters.numbers(corners[1]);
  const auto& cells = parameters.numbers("Cells");
  const std::size_t dimension = lower.size();
  if (dimension < 2 || dimension > 3 || upper.size() != dimension || cells.size() != dimension) {
    refuse(box.name, "Lower Corner, Upper Corner and Cells have " + std::to_string(dimension) + ", " +
                         std::to_string(upper.size()) + " and " + std::to_string(cells.size()) +
                         " numbers; give 2 of each in the plane or 3 in space.");
  }
  for (std::size_t d = 0; d < dimension; ++d) {
    box.lower[d] = lower[d];
    box.upper[d] = upper[d];
    if (cells[d] != std::floor(cells[d]) || cells[d] > 1e6) refuse(box.name, "Cells must be whole numbers up to 1e6.");
    box.cells[d] = static_cast<int>(cells[d]);
  }
  const int space = static_cast<int>(dimension);
  box.element = dimension == 2 ? ElementType::quad4 : ElementType::hex8;
  if (parameters.has("Element")) {
    const std::string& name = parameters.text("Element");
    const auto type = elementTypeFromExodus(name, space, std::stoi(name.substr(name.size() - 1)));
    if (!type) refuse(box.name, "Element = " + name + " does not exist in " + std::to_string(space) + " dimensions.");
    box.element = *type;
  }
  return box;
}

}  // namespace

base::ParameterSpec describeBoxes() {
  base::ParameterSpec spec("Boxes");
  spec.summary(
      "Any number of boxes of equal cells. Each is a block of its own name with side sets <name>_xmin, "
      "<name>_xmax and so on; boxes share no nodes.");
  base::ParameterSpec& box = spec.namedLists("Boxes", true);
  box.numbers(corners[0]).unit("length").doc("Lowest coordinates, 2 numbers in the plane or 3 in space.");
  box.numbers(corners[1]).unit("length").doc("Highest coordinates.");
  box.numbers("Cells").doc("Number of cells in each direction.");
  box.text("Element")
      .optional()
      .oneOf({"Hex8", "Wedge6", "Tet4", "Pyramid5", "Quad4", "Tri3"})
      .doc("Element that the cells are divided into; Hex8 in space and Quad4 in the plane when not given.");
  return spec;
}

Mesh boxes(const std::vector<Box>& list) {
  if (list.empty()) throw base::Error("Boxes: give at least one box.", base::ExitCode::input);
  const int dimension = dimensionOf(list.front().element);
  StructuredMesh mesh(dimension);
  std::set<std::string> names;
  for (const Box& box : list) {
    if (!names.insert(box.name).second) refuse(box.name, "there are two boxes of this name; rename one.");
    if (dimensionOf(box.element) != dimension) {
      refuse(box.name, "has elements " + std::string(exodusName(box.element)) + ", box \"" + list.front().name +
                           "\" has " + exodusName(list.front().element) +
                           "; all boxes must be either in the plane or in space.");
    }
    double size = 0.0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
      if (!(box.lower[d] < box.upper[d]))
        refuse(box.name, "Lower Corner must lie below Upper Corner in every direction.");
      if (box.cells[d] < 1) refuse(box.name, "Cells must be at least 1 in every direction.");
      size = std::max(size, box.upper[d] - box.lower[d]);
    }
    mesh.addBlock(box.name, box.element);
    mesh.addGrid(box.cells, boxMap(box.lower, box.upper));
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
      const auto at = [d, tolerance = 1e-9 * size](double x) {
        return [=](const Point& p) { return std::abs(p[d] - x) < tolerance; };
      };
      const std::string side = box.name + "_" + "xyz"[d];
      mesh.addSideSet(side + "min", box.name, at(box.lower[d]));
      mesh.addSideSet(side + "max", box.name, at(box.upper[d]));
    }
  }
  return mesh.take();
}

Mesh boxes(const base::Parameters& parameters) {
  std::vector<Box> list;
  for (const base::Parameters& box : parameters.lists("Boxes")) list.push_back(readBox(box));
  return boxes(list);
}

}  // namespace harmos::mesh
