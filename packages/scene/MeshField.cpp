#include <harmos/scene/detail/MeshField.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/FaceMatching.hpp>
#include <harmos/scene/MeshSource.hpp>

namespace harmos::scene {

namespace {

using Found = std::vector<mortar::NearestFaces::Found>;

// Of the largest: two values that count as the same one, round-off and single precision of files left aside.
constexpr double sameValue = 1e-6;

[[noreturn]] void refuse(const std::string& where, const std::string& what, const std::string& repair) {
  throw base::Error(where + ": " + what + "\n  " + repair, base::ExitCode::input);
}

std::string textOf(const base::Vector3& v) {
  return "(" + base::toText(v[0]) + ", " + base::toText(v[1]) + ", " + base::toText(v[2]) + ")";
}

/// The elements of every part, of one that a plane divides on each side of it.
std::map<std::pair<std::string, int>, std::vector<int>> elementsOf(const std::vector<mesh::Piece>& pieces) {
  std::map<std::pair<std::string, int>, std::vector<int>> all;
  for (const mesh::Piece& piece : pieces) {
    std::vector<int>& elements = all[{piece.part, piece.side}];
    elements.insert(elements.end(), piece.elements.begin(), piece.elements.end());
  }
  return all;
}

}  // namespace

input::ParameterSpec MeshField::form() {
  input::ParameterSpec spec("Mesh Variable");
  spec.summary(
      "A variable that the Exodus file of the mesh has at its nodes or in its elements, such as a measured map or the "
      "result of another program. Where the nodes of an interface do not lie on nodes of the part, the shape functions "
      "of its faces are used; of elements it is the mean of those whose faces meet there.");
  spec.text("Variable").required().doc("Its name; of nodes, if they have one of this name, else of elements.");
  spec.text("Part").optional().doc(
      "Name of the part whose nodes or elements are meant on faces; absent: all, which must agree where they meet. "
      "Inside of parts their own are.");
  spec.integer("Time Step").optional().atLeast(1).doc("Of the file, counted from 1; absent: the last.");
  spec.flag("Follows Time")
      .defaultValue(false)
      .doc("Whether the load steps take it at their own time, linearly between the times of the file.");
  return spec;
}

MeshField::MeshField(const input::Parameters& list, const FieldContext& context) : where_(list.where()) {
  const mesh::Mesh& mesh = context.mesh;
  const input::Parameters& source = context.scene.list("Mesh");
  const auto file = meshFile(source, context.scenePath);
  if (!file) refuse(where_, "a generated mesh has no variables.", "Take formulas, or a mesh of an Exodus file.");
  if (source.has("Refine") || source.has("Order")) {
    refuse(where_, "the variable is known on the mesh of the file only.",
           "Remove Refine and Order from the list Mesh.");
  }
  const bool follows = list.flag("Follows Time");
  if (follows && list.has("Time Step")) {
    refuse(list.where("Time Step"), "the field follows the time.", "Remove one of them.");
  }
  std::optional<int> step;
  if (!follows) step = list.has("Time Step") ? list.integer("Time Step") : 0;
  try {
    variable_ = files::readMeshVariable(*file, list.text("Variable"), step);
  } catch (const base::Error& error) {
    throw base::Error(list.where("Variable") + ": " + error.what(), error.code());
  }
  if (follows) {
    follow(list, context.times);
  } else {
    steps_.emplace_back();
  }
  if (variable_.isNodal) {
    if (variable_.values.front().size() != mesh.nodes.size()) {
      refuse(where_,
             "the variable has " + std::to_string(variable_.values.front().size()) + " values, the mesh " +
                 std::to_string(mesh.nodes.size()) + " nodes.",
             "Give the file of the mesh itself.");
    }
  } else {
    arrangeElements(list, mesh);
  }
  numbering_ = mesh.numbering;
  const mesh::Elements elements(mesh);
  const auto nodes = std::make_shared<const std::vector<base::Vector3>>(mesh.nodes);
  for (const auto& [key, ofBody] : elementsOf(context.pieces)) {
    if (list.has("Part") && list.text("Part") != key.first) continue;
    bodies_.push_back({key.first, mortar::NearestFaces(mesh.dimension, nodes, mesh::skin(elements, ofBody))});
  }
}

void MeshField::follow(const input::Parameters& list, const std::vector<double>& times) {
  const std::vector<double>& known = variable_.times;
  const double early = times.front() * (1.0 + sameValue), late = times.back() * (1.0 - sameValue);
  if (early < known.front() || late > known.back()) {
    refuse(list.where("Follows Time"),
           "the load steps end at times from " + base::toText(times.front()) + " to " + base::toText(times.back()) +
               ", the file has times from " + base::toText(known.front()) + " to " + base::toText(known.back()) + ".",
           "Let it hold all of them, or choose one Time Step.");
  }
  for (const double time : times) {
    const auto after = std::upper_bound(known.begin(), known.end(), time);
    Between step;
    step.second = after == known.end() ? known.size() - 1 : static_cast<std::size_t>(after - known.begin());
    step.first = after == known.begin() || after == known.end() ? step.second : step.second - 1;
    if (step.first != step.second) {
      step.fraction = (time - known[step.first]) / (known[step.second] - known[step.first]);
    }
    steps_.push_back(step);
  }
}

/// In the order of the mesh, which does not have all blocks of the file.
void MeshField::arrangeElements(const input::Parameters& list, const mesh::Mesh& mesh) {
  std::vector<std::vector<double>> arranged(variable_.values.size());
  std::size_t block = 0, first = 0;
  for (const mesh::ElementBlock& wanted : mesh.blocks) {
    while (block < variable_.blocks.size() && variable_.blocks[block] != wanted.name) {
      first += static_cast<std::size_t>(variable_.blockSizes[block++]);
    }
    if (block == variable_.blocks.size() || variable_.blockSizes[block] != wanted.elements()) {
      refuse(list.where("Variable"), "the file has other blocks than the mesh.", "Give the file of the mesh itself.");
    }
    const std::size_t end = first + static_cast<std::size_t>(variable_.blockSizes[block++]);
    for (std::size_t s = 0; s < arranged.size(); ++s) {
      const std::vector<double>& values = variable_.values[s];
      arranged[s].insert(arranged[s].end(), values.begin() + static_cast<std::ptrdiff_t>(first),
                         values.begin() + static_cast<std::ptrdiff_t>(end));
    }
    first = end;
  }
  variable_.values = std::move(arranged);
}

double MeshField::valueOf(std::size_t entity, const Between& step) const {
  const double before = variable_.values[step.first][entity], after = variable_.values[step.second][entity];
  return before + step.fraction * (after - before);
}

double MeshField::valueOn(const Found& faces, const Between& step) const {
  double sum = 0.0;
  if (variable_.isNodal) {
    for (const auto& [node, weight] : faces.front().weights) {
      if (weight != 0.0) sum += weight * valueOf(static_cast<std::size_t>(node), step);
    }
    return sum;
  }
  std::set<int> elements;
  for (const auto& face : faces) elements.insert(face.element);
  for (const int element : elements) sum += valueOf(static_cast<std::size_t>(element), step);
  return sum / static_cast<double>(elements.size());
}

const MeshField::Between& MeshField::between(int step) const {
  return steps_.size() == 1 ? steps_.front() : steps_[static_cast<std::size_t>(step)];
}

double MeshField::inside(int step, const laws::InnerPoint& point) const {
  double value = 0.0;
  if (variable_.isNodal) {
    for (int a = 0; a < point.nodes; ++a) {
      value += point.weight[a] * valueOf(static_cast<std::size_t>(point.node[a]), between(step));
    }
  } else {
    value = valueOf(static_cast<std::size_t>(point.element), between(step));
  }
  if (!std::isfinite(value)) {
    refuse(where_, "the variable is no number in " + numbering_.nameOfElement(point.element) + ".", "Give one there.");
  }
  return value;
}

double MeshField::at(int step, const base::Vector3& place) const {
  const Between& between = this->between(step);
  std::vector<Found> found;
  double nearest = std::numeric_limits<double>::infinity(), size = 0.0, reach = nearest;
  for (const Body& body : bodies_) {
    found.emplace_back();
    if (body.faces.distanceToBox(place) > reach) continue;
    found.back() = body.faces.at(place);
    const auto& face = found.back().front();
    if (face.distance >= nearest) continue;
    nearest = face.distance;
    size = face.size;
    reach = nearest + mesh::conformingTolerance * size;
  }
  std::map<std::string, Found> parts;  // both sides of a plane that divides one count together
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (found[b].empty() || found[b].front().distance > reach) continue;
    Found& faces = parts[bodies_[b].part];
    faces.insert(faces.end(), found[b].begin(), found[b].end());
  }
  const auto& [first, faces] = *parts.begin();
  if (nearest > size) {
    refuse(where_,
           "the place " + textOf(place) + " is " + base::toText(nearest) + " away from the part " +
               base::quoted(first) + ".",
           "Name the part on whose faces the law acts.");
  }
  const double value = valueOn(faces, between);
  for (const auto& [part, others] : parts) {
    if (part == first) continue;
    const double here = valueOn(others, between);
    if (std::abs(here - value) <= sameValue * std::max(std::abs(here), std::abs(value))) continue;
    refuse(where_,
           "at " + textOf(place) + " the parts " + base::quoted(first) + " and " + base::quoted(part) +
               " have different values, " + base::toText(value) + " and " + base::toText(here) + ".",
           "Name one of them in \"Part\".");
  }
  if (!std::isfinite(value)) {
    refuse(where_, "the variable is no number at " + textOf(place) + ".", "Give one there.");
  }
  return value;
}

}  // namespace harmos::scene
