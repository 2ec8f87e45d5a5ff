#pragma once

#include <memory>
#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/base/Vector3.hpp>

namespace harmos::scene {

/// A direction along which a boundary holds a node of a body.
struct Holding {
  int interface = -1;                                       // position in the list
  int body = -1;                                            // where
  int node = -1;                                            // of that body
  base::Vector3 direction{};                                // unit vector
  std::shared_ptr<const std::vector<double>> displacement;  // along it, per load step [length]
};

/// One of the directions along which a node is held, at right angles to each other.
struct HeldAxis {
  int interface = -1;                // position in the list of the boundary that holds it
  base::Vector3 direction{};         // unit vector
  std::vector<double> displacement;  // along it, per load step [length]
};

/// A holding that those before it do not allow.
struct Conflict {
  Holding holding;        // the later one
  int other = -1;         // interface of an earlier one
  int step = -1;          // from 0
  double expected = 0.0;  // what the earlier ones make of the displacement along the direction [length]
};

/// Which nodes boundaries hold, and where: of all laws, affine at every place, that leave a component no choice,
/// whatever its traction. Nodes that interfaces bond move as one and count as one. Interfaces whose points are no nodes
/// hold and bond none.
class HeldNodes {
 public:
  /// `nodes`: how many each body has. The interfaces must outlive this.
  HeldNodes(const std::vector<assembly::Interface>& interfaces, const std::vector<int>& nodes, int dimension,
            int steps);

  /// Of one node of a body, in the order of the interfaces.
  const std::vector<Holding>& of(int body, int node) const;
  /// Directions that span those of a node; of holdings that contradict each other the first counts.
  std::vector<HeldAxis> axes(int body, int node) const;
  /// Of every two interfaces one at most where nodes count as one.
  std::vector<Conflict> conflicts() const;

 private:
  void bond();
  void hold(int interfaceIndex);

  const std::vector<assembly::Interface>& interfaces_;
  int dimension_, steps_;
  std::vector<int> first_;                      // number of node 0 of each body
  std::vector<int> representative_;             // by these numbers: the number that stands for all that move as one
  std::vector<std::vector<Holding>> holdings_;  // by representative
};

}  // namespace harmos::scene
