#include <harmos/latin/Safety.hpp>

#include <algorithm>

namespace harmos::latin {
namespace {

// Share of the largest pressure of an interface below which a pair touches by accident.
constexpr double pressed = 1e-2;

double ratio(double capacity, double demand) {
  return capacity < largestSafety * demand ? std::max(1.0, capacity / demand) : largestSafety;
}

}  // namespace

ContactKind ContactKind::of(const laws::InterfaceLaw& law, int step) {
  const auto admissible = law.admissibleTractions(step);
  if (law.prescribesTraction() || !admissible || law.frame() != laws::Frame::interface) return {};
  const bool gapes = admissible->upper[0] == 0.0 && admissible->lower[0] == -laws::AdmissibleTractions::unlimited;
  return {gapes, gapes ? admissible->friction : 0.0};
}

Safety safety(const assembly::Interface& interface, const PairFields& fields) {
  const std::size_t size = fields.traction.size();
  Safety result{std::vector<double>(size, largestSafety), std::vector<double>(size, largestSafety),
                std::vector<bool>(size, false)};
  double largest = 0.0;
  for (const base::Vector3& t : fields.traction) largest = std::max(largest, -t[0]);
  std::vector<double> mostPressed(static_cast<std::size_t>(fields.pairs), 0.0);
  for (int step = 0; step < fields.steps; ++step) {
    const ContactKind kind = ContactKind::of(*interface.law, step);
    if (!kind.gapes) continue;
    for (int p = 0; p < fields.pairs; ++p) {
      const std::size_t at = fields.at(step, p);
      const base::Vector3& t = fields.traction[at];
      const double pressure = std::max(0.0, -t[0]);
      double& most = mostPressed[static_cast<std::size_t>(p)];
      most = std::max(most, pressure);
      result.counts[at] = most > 0.0 && most >= pressed * largest;
      if (pressure > 0.0 && kind.friction > 0.0) {
        result.slip[at] = ratio(kind.friction * pressure, base::tangentialNorm(t));
      }
      if (most > 0.0) result.gaping[at] = ratio(most, most - pressure);
    }
  }
  return result;
}

double ContactSums::slip() const {
  return capacity > 0.0 ? ratio(capacity, shear) : largestSafety;
}

double ContactSums::gaping() const {
  return largestPressure > 0.0 ? ratio(largestPressure, largestPressure - pressure) : largestSafety;
}

void add(const assembly::Interface& interface, const PairFields& fields, int step, ContactSums& sums) {
  const ContactKind kind = ContactKind::of(*interface.law, step);
  if (!kind.gapes) return;
  for (int p = 0; p < fields.pairs; ++p) {
    const base::Vector3& t = fields.traction[fields.at(step, p)];
    const double pressure = interface.area[static_cast<std::size_t>(p)] * std::max(0.0, -t[0]);
    sums.pressure += pressure;
    sums.capacity += kind.friction * pressure;
    if (kind.friction > 0.0) sums.shear += interface.area[static_cast<std::size_t>(p)] * base::tangentialNorm(t);
  }
}

}  // namespace harmos::latin
