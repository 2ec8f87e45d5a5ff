#include <harmos/elasticity/detail/ElementFault.hpp>

#include <algorithm>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/elasticity/detail/ElementIntegrals.hpp>
#include <harmos/mesh/Elements.hpp>

namespace harmos::elasticity {
namespace {

/// Where the nodes of an element would be were its edges straight: the linear element's image of their places.
std::vector<base::Vector3> straightened(const std::vector<base::Vector3>& nodes, mesh::ElementType type) {
  const mesh::ShapeFunctions linear = mesh::shapeFunctions(mesh::linearType(type), mesh::nodePlaces(type));
  std::vector<base::Vector3> result(nodes.size());
  for (int at = 0; at < linear.points; ++at) {
    for (int a = 0; a < linear.nodes; ++a) result[at] = result[at] + linear.value[at * linear.nodes + a] * nodes[a];
  }
  return result;
}

bool canBeIntegrated(const std::vector<base::Vector3>& nodes, mesh::ElementType type) {
  std::vector<const base::Vector3*> places;
  for (const base::Vector3& node : nodes) places.push_back(&node);
  ElementIntegrals integrals;
  return integrate(ElementBasis(type, Formulation::fullIntegration, Kinematics::threeDimensional), places.data(), false,
                   integrals);
}

/// Which node in a middle is farthest out of place, and by how much; empty when the corners are wrong already.
std::string misplacedNode(const mesh::Mesh& mesh, const int* numbers, mesh::ElementType type) {
  const std::vector<base::Vector3> nodes = mesh::pointsOf(mesh, {numbers, numbers + mesh::nodesPerElement(type)});
  const std::vector<base::Vector3> straight = straightened(nodes, type);
  if (!canBeIntegrated(straight, type)) return "";
  double longest = 0.0;
  for (const std::vector<int>& edge : mesh::edgesOf(type)) {
    longest = std::max(longest, base::distance(nodes[edge[0]], nodes[edge[1]]));
  }
  std::size_t worst = 0;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    if (base::distance(nodes[a], straight[a]) > base::distance(nodes[worst], straight[worst])) worst = a;
  }
  double length = longest;
  const char* where = "middle between its corners";
  const char* which = "the longest edge";
  for (const std::vector<int>& edge : mesh::edgesOf(type)) {
    if (edge.back() != static_cast<int>(worst)) continue;
    length = base::distance(nodes[edge[0]], nodes[edge[1]]);
    where = "middle of its edge";
    which = "the edge";
  }
  const double away = base::distance(nodes[worst], straight[worst]);
  std::ostringstream text;
  text << mesh::nodeName(mesh, numbers[worst]) << " is " << away << " away from the " << where << ", " << away / length
       << " of the length of " << which;
  return text.str();
}

}  // namespace

void ElementFaults::add(const ElementGroup& group, int number) {
  if (count_++ > 0) return;
  const mesh::ElementType type = group.block->type;
  const int perElement = mesh::nodesPerElement(type);
  const int* numbers = group.block->connectivity.data() + std::ptrdiff_t{group.inBlock[number]} * perElement;
  const std::string misplaced = mesh::isQuadratic(type) ? misplacedNode(mesh_, numbers, type) : "";
  first_ = "Jacobian not positive in " + nameOf(mesh_, piece_, group, number) + ": the element is ";
  first_ += misplaced.empty() ? "turned inside out, folded, or has no volume. Check the order of its nodes and their "
                                "coordinates."
                              : "folded: " + misplaced + ". Move that node towards the middle.";
}

void ElementFaults::throwIfAny() const {
  if (count_ == 0) return;
  throw base::Error(first_ + (count_ == 1 ? ""
                                          : " The same is wrong with " + std::to_string(count_ - 1) +
                                                (count_ == 2 ? " more element" : " more elements") + " of the part."),
                    base::ExitCode::input);
}

}  // namespace harmos::elasticity
