#pragma once

#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/scene/detail/HeldNodes.hpp>
#include <harmos/scene/detail/Span.hpp>

namespace harmos::scene {

/// What boundaries prescribe of the jump of a pair, w2 - w1, or -w1 on a boundary: it along all directions along which
/// they hold every node that the pair feels.
class HeldJump {
 public:
  /// `components`: of a displacement, 2 or 3.
  HeldJump(const HeldNodes& held, const assembly::Interface& interface, int pair, int components);

  /// Directions along which some node is not held; all of them where nothing is known.
  const Span& free() const { return free_; }
  /// The jump along a unit vector at right angles to free(), per load step [length].
  std::vector<double> along(const base::Vector3& direction) const;
  /// What of it is no more than round-off, and, where a side of the pair is the mean of several nodes, what these
  /// differ by, per load step [length].
  std::vector<double> uncertainty(const base::Vector3& direction) const;
  /// Positions of the boundaries that hold it along a direction, ascending.
  std::vector<int> holders(const base::Vector3& direction) const;

 private:
  struct Node {
    int side;       // 0 or 1
    double weight;  // of its displacement in the jump
    std::vector<HeldAxis> axes;
    std::vector<Holding> holdings;
  };

  void feel(const HeldNodes& held, const assembly::Interface& interface, int pair, int side);
  static double displacement(const Node& node, const base::Vector3& direction, std::size_t step);

  Span free_;
  std::size_t steps_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace harmos::scene
