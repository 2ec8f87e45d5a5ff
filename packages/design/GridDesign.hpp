#pragma once

#include <harmos/design/Design.hpp>

namespace harmos::design {

/// All combinations of the levels; the last axis runs fastest, so that neighbours in the list differ little.
class GridDesign : public Design {
 public:
  /// Throws base::Error (input) when an axis has no levels or the grid more points than mostConfigurations.
  std::vector<std::vector<double>> points(const std::vector<Axis>& axes) const override;
};

}  // namespace harmos::design
