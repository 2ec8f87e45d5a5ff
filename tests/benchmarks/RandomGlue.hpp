#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <harmos/scene/Problem.hpp>
#include <harmos/stochastic/Projection.hpp>
#include <harmos/stochastic/Realisations.hpp>

namespace harmos::benchmarks {

/// The glued assembly of xml/glued_assembly.xml, the moduli of its two glues normal with the mean of the scene and the
/// coefficients of variation 0.2 and 0.25.
class RandomGlue {
 public:
  /// Reads the scene and builds mesh and bodies.
  explicit RandomGlue(const std::string& path);
  RandomGlue(const RandomGlue&) = delete;
  RandomGlue& operator=(const RandomGlue&) = delete;

  const assembly::Assembly& assembly() const { return problem_.assembly; }
  /// Displacement of A along x and y.
  const std::vector<std::shared_ptr<const latin::Response>>& responses() const { return responses_; }
  const latin::DisplacementResponse& displacement(std::size_t i) const {
    return dynamic_cast<const latin::DisplacementResponse&>(*responses_[i]);
  }
  const latin::StageOptions& stages() const { return stages_; }
  /// Order and Gauss points per germ.
  std::shared_ptr<const stochastic::Projection> projection(int order, int points) const;

  /// Index in the assembly of glue 0 or 1, and its mean stiffness [stress/length], normal and tangential.
  int interfaceOf(std::size_t glue) const { return glues_[glue].interface; }
  std::pair<double, double> stiffness(std::size_t glue) const { return {glues_[glue].normal, glues_[glue].tangential}; }
  /// Moduli over their means at a point of germs.
  std::vector<double> factors(const std::vector<double>& germs) const { return variables_->values(germs); }
  /// The laws of all interfaces for moduli that are `factors` times their means.
  std::vector<std::shared_ptr<const laws::InterfaceLaw>> laws(const std::vector<double>& factors) const;
  stochastic::Realisations realisations(const stochastic::Projection& projection) const;

 private:
  struct Glue {
    int interface = -1;
    double normal = 0.0, tangential = 0.0;
  };

  scene::Scene scene_;
  scene::Problem problem_;
  latin::StageOptions stages_;
  std::vector<std::shared_ptr<const latin::Response>> responses_;
  std::vector<Glue> glues_;
  std::shared_ptr<const probability::RandomVector> variables_;
};

}  // namespace harmos::benchmarks
