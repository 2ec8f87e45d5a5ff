#pragma once

#include <harmos/study/Design.hpp>
#include <harmos/study/Refinement.hpp>

namespace harmos::study {

/// The points with which a Refinement begins; the others follow from results.
class AdaptiveDesign : public Design {
 public:
  explicit AdaptiveDesign(const Refinement::Options& options) : options_(options) {}
  std::vector<std::vector<double>> points(const std::vector<Axis>& axes) const override {
    return Refinement(axes, options_).begin();
  }

 private:
  Refinement::Options options_;
};

}  // namespace harmos::study
