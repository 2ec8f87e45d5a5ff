#include <harmos/mortar/detail/DoublyHeld.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace harmos::mortar {
namespace {

constexpr double parallel = 0.99;  // cosine between directions that count as one
constexpr double along = 0.5;      // most of the cosine to the normal of a direction along the surface
constexpr double some = 0.2;       // of the sizes of the weights of a row, on held nodes
constexpr double roundOff = 1e-9;  // of weights
constexpr double same = 1e-6;      // sine between directions that are one
constexpr double stray = 1e-6;     // sum of the sizes of weights of a row that may be left out

/// Sums of the sizes of the weights of a row, on nodes that are held along a direction and on the others.
struct Weights {
  double held = 0.0;
  double others = 0.0;
};

/// `isOne`: of two directions, whether they count as one.
template <class IsOne>
bool isHeldAlong(const HeldDirections& held, int node, const base::Vector3& direction, const IsOne& isOne) {
  const auto found = held.find(node);
  return found != held.end() && std::any_of(found->second.begin(), found->second.end(),
                                            [&](const base::Vector3& other) { return isOne(direction, other); });
}

bool areParallel(const base::Vector3& a, const base::Vector3& b) {
  return std::abs(dot(a, b)) >= parallel;
}

bool areSame(const base::Vector3& a, const base::Vector3& b) {
  return norm(cross(a, b)) <= same;
}

template <class IsOne>
Weights weightsOf(const mesh::TraceOperator& trace, int point, const HeldDirections& held,
                  const base::Vector3& direction, const IsOne& isOne) {
  Weights weights;
  for (const auto& [node, weight] : trace.row(point)) {
    (isHeldAlong(held, node, direction, isOne) ? weights.held : weights.others) += std::abs(weight);
  }
  return weights;
}

/// The row without what is not held along the direction; its sum is 1 again.
std::vector<mesh::TraceOperator::Entry> heldPart(const mesh::TraceOperator::Row& row, const HeldDirections& held,
                                                 const base::Vector3& direction) {
  std::vector<mesh::TraceOperator::Entry> part;
  double sum = 0.0;
  for (const mesh::TraceOperator::Entry& entry : row) {
    if (!isHeldAlong(held, entry.node, direction, areSame)) continue;
    part.push_back(entry);
    sum += entry.weight;
  }
  for (mesh::TraceOperator::Entry& entry : part) entry.weight /= sum;
  return part;
}

}  // namespace

std::vector<bool> findDoublyHeld(const JoinedSurface& surface, const HeldDirections& held) {
  std::vector<bool> result;
  for (std::size_t p = 0; p < surface.node.size(); ++p) {
    const auto found = held.find(surface.node[p]);
    bool is = false;
    if (found != held.end()) {
      for (const base::Vector3& direction : found->second) {
        if (std::abs(dot(direction, surface.frame[p][0])) > along) continue;
        const int point = static_cast<int>(p);
        const Weights one = weightsOf(surface.trace[0], point, held, direction, areParallel);
        const Weights two = weightsOf(surface.trace[1], point, held, direction, areParallel);
        const bool areBothHeld = one.held >= some * one.others && two.held >= some * two.others;
        is = is || (areBothHeld && std::max(one.others, two.others) > roundOff);
      }
    }
    result.push_back(is);
  }
  return result;
}

void leaveOutStrayWeights(JoinedSurface& surface, const HeldDirections& held) {
  std::array<mesh::TraceOperator, 2> traces;
  for (std::size_t p = 0; p < surface.node.size(); ++p) {
    const int point = static_cast<int>(p);
    const base::Vector3* direction = nullptr;
    const auto found = held.find(surface.node[p]);
    for (std::size_t i = 0; found != held.end() && i < found->second.size(); ++i) {
      const base::Vector3& one = found->second[i];
      const bool isStray =
          std::all_of(surface.trace.begin(), surface.trace.end(), [&](const mesh::TraceOperator& trace) {
            return weightsOf(trace, point, held, one, areSame).others <= stray;
          });
      if (isStray && std::abs(dot(one, surface.normal[p])) <= along * norm(surface.normal[p])) direction = &one;
    }
    for (std::size_t side = 0; side < traces.size(); ++side) {
      if (direction == nullptr) {
        traces[side].appendFrom(surface.trace[side], point);
      } else {
        traces[side].append(heldPart(surface.trace[side].row(point), held, *direction));
      }
    }
  }
  surface.trace = std::move(traces);
}

}  // namespace harmos::mortar
