#include <harmos/latin/PairTangents.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <harmos/laws/AffineComponent.hpp>

namespace harmos::latin {
namespace {

// The difference over what the tractions would move the pair freely, and its bounds over the free jump itself: small
// beside the forces, for the tangent; large beside the round-off of the jump.
constexpr double differenceOfForces = 1e-9;
constexpr double leastDifference = 1e-10;
constexpr double largestDifference = 1e-7;

double largest(const base::Vector3& x) {
  return std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
}

}  // namespace

PairTangents::PairTangents(const assembly::Assembly& assembly, InterfaceLines& lines)
    : assembly_(assembly), lines_(lines), tangents_(assembly.interfaces.size()), faces_(assembly, lines.layout()) {}

void PairTangents::differentiate(int interfaceIndex, int step, const std::vector<laws::LocalLine>& lines,
                                 const laws::LocalState* states, const std::vector<double>& oldHistory) {
  step_ = step;
  if (faces_.law(interfaceIndex) != nullptr) return;
  const assembly::Interface& interface = assembly_.interfaces[interfaceIndex];
  const auto pairs = static_cast<std::size_t>(interface.pairs());
  double jump = 0.0, traction = 0.0, length = 0.0;
  for (std::size_t p = 0; p < pairs; ++p) {
    jump = std::max(jump, largest(lines[p].freeJump));
    traction = std::max(traction, lines[p].compliance * largest(states[p].traction));
    length = std::max(length, std::sqrt(interface.area[p]));
  }
  // Nothing has moved yet: anything small will do.
  if (jump == 0.0) jump = length;
  const double difference = std::clamp(differenceOfForces * traction, leastDifference * jump, largestDifference * jump);
  std::vector<base::Frame>& tangents = tangents_[interfaceIndex];
  tangents.assign(pairs, {});
  std::vector<laws::LocalLine> shifted(lines);
  std::vector<laws::LocalState> moved(pairs);
  std::vector<double> newHistory(oldHistory.size());
  laws::NodeArrays nodes = interface.nodes(assembly_.times, step);
  nodes.line = shifted.data();
  nodes.oldHistory = oldHistory.data();
  nodes.newHistory = newHistory.data();
  nodes.state = moved.data();
  for (std::size_t c = 0; c < static_cast<std::size_t>(assembly_.dimension); ++c) {
    for (std::size_t p = 0; p < pairs; ++p) shifted[p].freeJump[c] = lines[p].freeJump[c] + difference;
    interface.solve(step, nodes);
    for (std::size_t p = 0; p < pairs; ++p) {
      const double exact = shifted[p].freeJump[c] - lines[p].freeJump[c];
      for (std::size_t i = 0; i < 3; ++i) {
        tangents[p][i][c] = (moved[p].traction[i] - states[p].traction[i]) / exact;
      }
      shifted[p].freeJump[c] = lines[p].freeJump[c];
    }
  }
  // From here on they meet fields of many directions, whose components are these.
  const bool isLocal = interface.law->frame() == laws::Frame::interface;
  for (std::size_t p = 0; p < pairs; ++p) {
    if (isLocal) tangents[p] = base::turnedBack(interface.frame[p], tangents[p]);
    for (base::Vector3& row : tangents[p]) row = (lines[p].compliance / interface.sides()) * row;
  }
}

base::Frame PairTangents::exactly(int interfaceIndex, int pair, double compliance) const {
  const assembly::Interface& interface = assembly_.interfaces[interfaceIndex];
  if (!interface.law->isAffine()) return of(interfaceIndex, pair);
  const auto components = laws::affineComponents(*interface.law, step_, compliance);
  base::Frame result{};
  for (std::size_t c = 0; c < static_cast<std::size_t>(assembly_.dimension); ++c) {
    const double k = components[c].stiffness * compliance;
    result[c][c] = (std::isinf(k) ? 1.0 : k / (1.0 + k)) / interface.sides();
  }
  return interface.law->frame() == laws::Frame::interface ? base::turnedBack(interface.frame[pair], result) : result;
}

base::Frame PairTangents::of(int interfaceIndex, int pair) const {
  if (faces_.law(interfaceIndex) == nullptr) return tangents_[interfaceIndex][pair];
  const double perfect = 1.0 / assembly_.interfaces[interfaceIndex].sides();
  return {base::Vector3{perfect, 0.0, 0.0}, base::Vector3{0.0, perfect, 0.0}, base::Vector3{0.0, 0.0, perfect}};
}

void PairTangents::transpose() {
  for (std::vector<base::Frame>& tangents : tangents_) {
    for (base::Frame& tangent : tangents) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < i; ++j) std::swap(tangent[i][j], tangent[j][i]);
      }
    }
  }
}

void PairTangents::apply(const base::Matrix& y, base::Matrix& traction) const {
  lines_.reserve(y.numCols());
  lines_.exchange(y, 0, y.numCols());
  if (lines_.layout().blocks().empty()) {
    traction.shape(y.numRows(), y.numCols());  // the row that stands for none
  } else if (traction.numRows() != y.numRows() || traction.numCols() != y.numCols()) {
    traction.shapeUninitialized(y.numRows(), y.numCols());
  }
  for (std::size_t i = 0; i < tangents_.size(); ++i) {
    const int index = static_cast<int>(i);
    if (!lines_.isActive(index) || faces_.law(index) != nullptr) continue;
    for (int column = 0; column < y.numCols(); ++column) {
      lines_.map(index, tangents_[i], column, y, traction[column]);
    }
  }
  if (!faces_.isEmpty()) applyFaces(y, traction);
}

void PairTangents::applyFaces(const base::Matrix& y, base::Matrix& traction) const {
  FaceSums sums(faces_);
  std::vector<laws::LocalLine> lines;
  std::vector<laws::LocalState> states;
  const auto arrays = [&](int i, int column) {
    lines_.fill(i, column, y, lines);
    states.resize(lines.size());
    laws::NodeArrays nodes = assembly_.interfaces[i].nodes(assembly_.times, step_);
    nodes.line = lines.data();
    nodes.state = states.data();
    return nodes;
  };
  sums.begin(y.numCols());
  for (const int i : faces_.interfaces()) {
    if (!lines_.isActive(i)) continue;
    for (int column = 0; column < y.numCols(); ++column) sums.add(i, column, step_, arrays(i, column));
  }
  sums.finish();
  for (const int i : faces_.interfaces()) {
    if (!lines_.isActive(i)) continue;
    for (int column = 0; column < y.numCols(); ++column) {
      faces_.law(i)->solveTangent(step_, arrays(i, column), sums.of(i, column));
      lines_.write(i, states.data(), traction[column]);
    }
  }
}

}  // namespace harmos::latin
