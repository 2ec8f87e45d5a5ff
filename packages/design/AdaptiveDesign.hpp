#pragma once

#include <harmos/design/Design.hpp>
#include <harmos/design/Refinement.hpp>

namespace harmos::design {

/// The points with which a Refinement begins; the others follow from results.
class AdaptiveDesign : public Design {
 public:
  /// The options of the Refinement that goes on from these points.
  explicit AdaptiveDesign(const Refinement::Options& options) : options_(options) {}
  /// Conditions of the study are not known here.
  std::vector<std::vector<double>> points(const std::vector<Axis>& axes) const override {
    return Refinement(axes, options_).begin();
  }

 private:
  Refinement::Options options_;
};

}  // namespace harmos::design
