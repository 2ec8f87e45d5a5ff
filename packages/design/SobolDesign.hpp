#pragma once

#include <harmos/design/Design.hpp>

namespace harmos::design {

/// Sobol' sequence: fills the space evenly; a longer design begins with the points of a shorter one.
///
/// Without a shift the sequence starts at the middle of the box (the point at its corner is left out). A seed other
/// than 0 shifts all digits at random (a digital shift), which keeps the evenness and gives independent repetitions.
/// Source: Joe and Kuo, Constructing Sobol' sequences with better two-dimensional projections, SIAM J. Sci. Comput. 30
/// (2008), doi:10.1137/070709359; numbers as in Boost.Random.
class SobolDesign : public Design {
 public:
  /// Number of points, and of the shift; 0: none.
  SobolDesign(int count, int seed) : count_(count), seed_(seed) {}
  std::vector<std::vector<double>> points(const std::vector<Axis>& axes) const override;

 private:
  int count_, seed_;
};

}  // namespace harmos::design
