#include <harmos/mesh/Numbering.hpp>

#include <algorithm>

#include <harmos/base/Names.hpp>

namespace harmos::mesh {

namespace {

std::string of(const std::string& file) {
  return " of " + (file.empty() ? "the mesh" : base::quoted(file));
}

}  // namespace

std::int64_t Numbering::ofElement(int position) const {
  return element.empty() ? position + 1 : element[position];
}

std::optional<std::int64_t> Numbering::ofNode(int position) const {
  if (node.empty()) return position + 1;
  if (static_cast<std::size_t>(position) >= node.size()) return std::nullopt;
  return node[position];
}

std::string Numbering::nameOfElement(int position) const {
  return (isSplit ? "a child of element " : "element ") + std::to_string(ofElement(position)) + of(file);
}

std::string Numbering::nameOfNode(int position) const {
  const auto number = ofNode(position);
  return number ? "node " + std::to_string(*number) + of(file) : "a node made by Mesh/Refine or Mesh/Order";
}

std::vector<std::int64_t> unlessPositions(std::vector<std::int64_t> numbers) {
  std::int64_t position = 0;
  if (std::all_of(numbers.begin(), numbers.end(), [&](std::int64_t number) { return number == ++position; })) return {};
  return numbers;
}

bool areDistinct(std::vector<std::int64_t> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return (numbers.empty() || numbers.front() > 0) &&
         std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end();
}

}  // namespace harmos::mesh
