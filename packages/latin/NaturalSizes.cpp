#include <harmos/latin/NaturalSizes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Teuchos_CommHelpers.hpp>

namespace harmos::latin {
namespace {

constexpr double smallShare = 1e-3;
// Forces are differences of large numbers when bodies move without being held: f = alpha - k w. Where all of them are
// below this share of k w, with the automatic k, they are round-off; counted from reference motions, less of them is.
constexpr double nothing = 1e-10;
constexpr double nothingFromReference = 1e-12;
// Of k w: less is nothing but round-off, whatever the loads.
constexpr double digits = 1e-14;
// Of k w: what forces are measured by where there are none.
constexpr double cancellation = 1e-7;
// Of the loads, which balance each other where temperatures expand a body freely, or pressures squeeze it.
constexpr double cancellationOfLoads = 1e-7;

/// Sums of |nodal forces| on the volumes of the bodies of this rank and of |prescribed tractions| on their faces, per
/// load step.
std::vector<double> sumsOfLoads(const Iterate& state) {
  const assembly::Assembly& assembly = state.assembly();
  std::vector<double> sums(assembly.steps(), 0.0);
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const base::Matrix& loads = assembly.bodies[b].loads;
    if (!state.layout().owns(static_cast<int>(b))) continue;
    for (int t = 0; t < loads.numCols(); ++t) {
      for (int dof = 0; dof < loads.numRows(); ++dof) sums[t] += std::abs(loads(dof, t));
    }
  }
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (!interface.law->prescribesTraction() || !state.layout().owns(interface.body1)) continue;
    for (int t = 0; t < assembly.steps(); ++t) {
      const std::vector<base::Vector3> tractions = state.tractions(static_cast<int>(i), t);
      for (int p = 0; p < interface.pairs(); ++p) sums[t] += interface.area[p] * norm(tractions[p]);
    }
  }
  return sums;
}

/// Whether a row lies on a cut through a part.
std::vector<bool> rowsOfCuts(const Iterate& state) {
  const TraceLayout& layout = state.layout();
  std::vector<bool> result(layout.area().size(), false);
  for (const TraceLayout::Block& block : layout.blocks()) {
    if (!state.assembly().interfaces[block.interface].isCut) continue;
    const auto begin = result.begin() + block.begin;
    std::fill(begin, begin + block.pairs * layout.dimension(), true);
  }
  return result;
}

}  // namespace

NaturalSizes::NaturalSizes(const Iterate& state) {
  const TraceLayout& layout = state.layout();
  const auto steps = static_cast<std::size_t>(state.assembly().steps());
  std::vector<double> forces(steps, 0.0), springs(steps, 0.0), squaredSprings(steps, 0.0), energies(steps, 0.0);
  std::vector<double> total(1, 0.0);
  double stress = 0.0, springStress = 0.0;
  // What the loads do to a body that only k holds grows as 1/k; with the automatic k it is a natural size.
  double displacement = state.largestDisplacement(std::min(1.0, state.searchDirectionScale()));
  const auto add = [&](const base::Matrix& traction, const base::Matrix& trace, const std::vector<double>& area,
                       const std::vector<double>& k, const std::vector<bool>& isOfCut) {
    for (std::size_t t = 0; t < steps; ++t) {
      const double* f = traction[static_cast<int>(t)];
      const double* w = trace[static_cast<int>(t)];
      for (std::size_t row = 0; row < area.size(); ++row) {
        const double spring = k[row] / state.searchDirectionScale() * std::abs(w[row]);
        squaredSprings[t] += area[row] * spring * spring;
        if (isOfCut[row]) continue;
        energies[t] += area[row] * f[row] * f[row] * state.searchDirectionScale() / k[row];
        forces[t] += area[row] * std::abs(f[row]);
        springs[t] += area[row] * spring;
        stress = std::max(stress, std::abs(f[row]));
        springStress = std::max(springStress, spring);
        displacement = std::max(displacement, std::abs(w[row]));
      }
    }
    for (const double a : area) total[0] += a;
  };
  add(state.hattedTraction(), state.trace(), layout.area(), layout.stiffness(), rowsOfCuts(state));
  const BoundaryFields& boundaries = state.boundaryFields();
  if (!boundaries.interfaces.empty()) {
    add(boundaries.traction, boundaries.trace, boundaries.area, boundaries.stiffness,
        std::vector<bool>(boundaries.area.size(), false));
  }
  std::vector<double> loads = sumsOfLoads(state);
  for (auto* sums : {&forces, &springs, &squaredSprings, &energies, &total, &loads}) state.metric().sum(*sums);

  base::Vector3 lower, upper;
  lower.fill(std::numeric_limits<double>::infinity());
  upper.fill(-std::numeric_limits<double>::infinity());
  for (const auto& body : state.assembly().bodies) {
    for (const base::Vector3& x : body.nodes) {
      for (std::size_t c = 0; c < 3; ++c) {
        lower[c] = std::min(lower[c], x[c]);
        upper[c] = std::max(upper[c], x[c]);
      }
    }
  }
  length_ = std::hypot(upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]);

  const std::array<double, 3> mine = {displacement, stress, springStress};
  std::array<double, 3> all{};
  Teuchos::reduceAll(layout.comm(), Teuchos::REDUCE_MAX, 3, mine.data(), all.data());
  const auto largest = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  displacement_ = all[0];
  const double roundOff = state.reference().isEmpty() ? nothing : nothingFromReference;
  // Small as they are beside k w, where there are loads they are what carries these.
  const bool carryLoads = largest(loads) > 0.0 && largest(forces) > cancellationOfLoads * largest(loads) &&
                          largest(forces) > digits * largest(springs);
  const bool areNothing = largest(forces) <= roundOff * largest(springs) && !carryLoads;
  force_ = areNothing ? cancellation * largest(springs) : smallShare * largest(forces);
  stress_ = areNothing ? cancellation * all[2] : smallShare * all[1];
  squaredForce_ = areNothing ? cancellation * cancellation * largest(squaredSprings) : 0.0;
  const double balanced = cancellationOfLoads * largest(loads);
  if (balanced > 0.0 && total[0] > 0.0) {
    force_ = std::max(force_, balanced);
    stress_ = std::max(stress_, balanced / total[0]);
    squaredForce_ = std::max(squaredForce_, balanced * balanced / total[0]);
  }
  springEnergy_ = largest(energies);
  squaredDisplacement_ = smallShare * smallShare * displacement_ * displacement_ * total[0];
}

double NaturalSizes::floor(Quantity quantity) const {
  switch (quantity) {
    case Quantity::displacement:
      return smallShare * displacement_;
    case Quantity::force:
      return force_;
    case Quantity::moment:
      return force_ * length_;
    case Quantity::stress:
      return stress_;
    case Quantity::energy:
      return smallShare * force_ * displacement_;
    case Quantity::ratio:
      return smallShare;
  }
  return 0.0;
}

double NaturalSizes::natural(Quantity quantity, double force) const {
  switch (quantity) {
    case Quantity::displacement:
      return natural(Quantity::energy, force) / force;
    case Quantity::force:
      return force;
    case Quantity::moment:
      return force * length_;
    case Quantity::stress:
      return stress_ / smallShare;
    case Quantity::energy:
      return std::min(force * displacement_, springEnergy_);
    case Quantity::ratio:
      return 1.0;
  }
  return 0.0;
}

}  // namespace harmos::latin
