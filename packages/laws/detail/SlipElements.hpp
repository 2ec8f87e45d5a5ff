#pragma once

#include <vector>

#include <harmos/laws/OutputField.hpp>
#include <harmos/laws/detail/NormalSpring.hpp>
#include <harmos/laws/detail/TangentialSlip.hpp>

namespace harmos::laws {

/// Jenkins elements in parallel along the surface, beside a normal spring: t_t = k delta_t + sum of t_i, t_i = k_i
/// (delta_t - s_i), |t_i| <= tau_i. History: the slips s_i, two numbers each.
///
/// On a line the jump is where the gradient of a strictly convex function vanishes, |delta - delta_free|^2 / (2 H) and
/// the energies of the elements: found by Newton's method with a line search and bounded steps. Source: Iwan (1967).
class SlipElements {
 public:
  static constexpr bool dissipates = true;

  /// Stiffnesses k_i > 0 [stress/length] and strengths tau_i >= 0 [stress] of the elements, and k >= 0 of a spring
  /// beside them that does not slide.
  SlipElements(const NormalSpring& normal, std::vector<double> stiffnesses, std::vector<double> strengths,
               double spring);

  int historySize() const { return 2 * static_cast<int>(stiffnesses_.size()); }
  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const;
  /// All but tau_i times the slip of each.
  double keptWork(const PairStep& step) const;
  double storedEnergy(const PairStep& step) const;
  /// How much of the strength of all elements slides.
  static std::vector<OutputField> outputs();
  void output(const PairStep& step, double* values) const;

 private:
  struct Gradient;
  /// Of the energy of the elements at a tangential jump.
  Gradient gradient(const Tangential& jump, const double* old) const;

  NormalSpring normal_;
  std::vector<double> stiffnesses_, strengths_;
  double spring_;
};

}  // namespace harmos::laws
