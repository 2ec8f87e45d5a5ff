#include <harmos/mortar/detail/DoublyHeld.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::mortar {
namespace {

constexpr double parallel = 0.99;  // cosine between directions that count as one
constexpr double along = 0.5;      // most of the cosine to the normal of a direction along the surface
constexpr double some = 0.2;       // of the sizes of the weights of a row, on held nodes
constexpr double roundOff = 1e-9;  // of weights

/// Sums of the sizes of the weights of a row, on nodes that are held along a direction and on the others.
struct Weights {
  double held = 0.0;
  double others = 0.0;
};

Weights weightsOf(const mesh::TraceOperator& trace, int point, const HeldDirections& held,
                  const base::Vector3& direction) {
  Weights weights;
  for (const auto& [node, weight] : trace.row(point)) {
    const auto found = held.find(node);
    const bool isHeld =
        found != held.end() && std::any_of(found->second.begin(), found->second.end(), [&](const base::Vector3& other) {
          return std::abs(dot(direction, other)) >= parallel;
        });
    if (isHeld) {
      weights.held += std::abs(weight);
    } else {
      weights.others += std::abs(weight);
    }
  }
  return weights;
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
        const Weights one = weightsOf(surface.trace[0], point, held, direction);
        const Weights two = weightsOf(surface.trace[1], point, held, direction);
        const bool areBothHeld = one.held >= some * one.others && two.held >= some * two.others;
        is = is || (areBothHeld && std::max(one.others, two.others) > roundOff);
      }
    }
    result.push_back(is);
  }
  return result;
}

}  // namespace harmos::mortar
