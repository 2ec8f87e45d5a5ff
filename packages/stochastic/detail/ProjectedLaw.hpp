#pragma once

#include <memory>
#include <vector>

#include <harmos/laws/InterfaceLaw.hpp>
#include <harmos/stochastic/Projection.hpp>

namespace harmos::stochastic {

/// A random prescribed traction as a law of modal columns: at column (load step) * terms + a it prescribes the
/// coefficient a of the traction, sum over the points of w_q psi_a(xi_q) f_q.
class ProjectedLaw final : public laws::InterfaceLaw {
 public:
  /// One law that prescribes tractions for every point.
  ProjectedLaw(std::vector<std::shared_ptr<const laws::InterfaceLaw>> realisations,
               std::shared_ptr<const Projection> projection)
      : realisations_(std::move(realisations)), projection_(std::move(projection)) {}

  const char* name() const override { return realisations_[0]->name(); }
  int historySize() const override { return 0; }
  laws::Frame frame() const override { return realisations_[0]->frame(); }
  laws::Sides sides() const override { return realisations_[0]->sides(); }
  bool prescribesTraction() const override { return true; }
  bool dissipates() const override { return false; }
  bool isAffine() const override { return realisations_[0]->isAffine(); }
  void solve(int column, const laws::NodeArrays& nodes) const override;

 private:
  std::vector<std::shared_ptr<const laws::InterfaceLaw>> realisations_;
  std::shared_ptr<const Projection> projection_;
};

}  // namespace harmos::stochastic
