#pragma once

#include <harmos/design/Design.hpp>

namespace harmos::design {

/// As many strata of every axis as there are points, each hit once, at a random place in it.
///
/// Source: McKay, Beckman, Conover, A comparison of three methods for selecting values of input variables,
/// Technometrics 21 (1979), doi:10.1080/00401706.1979.10489755.
class LatinHypercubeDesign : public Design {
 public:
  /// Number of points, and where the random numbers begin.
  LatinHypercubeDesign(int count, int seed) : count_(count), seed_(seed) {}
  std::vector<std::vector<double>> points(const std::vector<Axis>& axes) const override;

 private:
  int count_, seed_;
};

}  // namespace harmos::design
