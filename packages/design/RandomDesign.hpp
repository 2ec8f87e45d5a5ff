#pragma once

#include <harmos/design/Design.hpp>

namespace harmos::design {

/// Independent uniform points. A longer design with the same seed begins with the points of a shorter one.
class RandomDesign : public Design {
 public:
  /// Number of points, and where the random numbers begin.
  RandomDesign(int count, int seed) : count_(count), seed_(seed) {}
  std::vector<std::vector<double>> points(const std::vector<Axis>& axes) const override;

 private:
  int count_, seed_;
};

}  // namespace harmos::design
