#include <harmos/latin/Safety.hpp>

#include <algorithm>

namespace harmos::latin {
namespace {

// Share of the largest pressure of an interface below which a pair touches by accident.
constexpr double pressed = 1e-2;

double ratio(double capacity, double demand) {
  return capacity < largestSafety * demand ? std::max(1.0, capacity / demand) : largestSafety;
}

/// Shear that friction bears at every pair [stress]; of one that slides, what it bears.
std::vector<double> shearLimits(const assembly::Interface& interface, const PairFields& fields, int step) {
  const auto admissible = interface.law->admissibleTractions(step);
  const bool isCone = admissible && admissible->isCone;
  const laws::NodeArrays nodes = interface.nodes(fields.times, step);
  std::vector<double> limits;
  for (int p = 0; p < fields.pairs; ++p) {
    const std::size_t at = fields.at(step, p);
    const base::Vector3& t = fields.traction[at];
    // How much that is may depend on the velocity.
    const bool isKnown = !isCone && fields.status[at] == laws::Status::slip;
    limits.push_back(isKnown ? base::tangentialNorm(t)
                             : interface.law->shearLimit(laws::NodeContext(step, nodes, p), t).value_or(0.0));
  }
  return limits;
}

}  // namespace

ContactKind ContactKind::of(const assembly::Interface& interface, const std::vector<double>& times, int step) {
  const laws::InterfaceLaw& law = *interface.law;
  if (law.prescribesTraction() || law.frame() != laws::Frame::interface) return {};
  const auto admissible = law.admissibleTractions(step);
  const laws::NodeArrays nodes = interface.nodes(times, step);
  ContactKind kind;
  kind.gapes =
      admissible && admissible->upper[0] == 0.0 && admissible->lower[0] == -laws::AdmissibleTractions::unlimited;
  for (int p = 0; p < nodes.count && !kind.slips; ++p) {
    kind.slips = law.shearLimit(laws::NodeContext(step, nodes, p), {-1.0, 0.0, 0.0}).value_or(0.0) > 0.0;
  }
  return kind;
}

Safety safety(const assembly::Interface& interface, const PairFields& fields) {
  const std::size_t size = fields.traction.size();
  Safety result{std::vector<double>(size, largestSafety), std::vector<double>(size, largestSafety),
                std::vector<bool>(size, false)};
  double largest = 0.0;
  for (const base::Vector3& t : fields.traction) largest = std::max(largest, -t[0]);
  std::vector<double> mostPressed(static_cast<std::size_t>(fields.pairs), 0.0);
  for (int step = 0; step < fields.steps; ++step) {
    const ContactKind kind = ContactKind::of(interface, fields.times, step);
    if (!kind.gapes && !kind.slips) continue;
    const std::vector<double> borne = kind.slips ? shearLimits(interface, fields, step) : std::vector<double>();
    for (int p = 0; p < fields.pairs; ++p) {
      const std::size_t at = fields.at(step, p);
      const base::Vector3& t = fields.traction[at];
      const double pressure = std::max(0.0, -t[0]);
      double& most = mostPressed[static_cast<std::size_t>(p)];
      most = std::max(most, pressure);
      result.counts[at] = most > 0.0 && most >= pressed * largest;
      if (kind.slips && borne[static_cast<std::size_t>(p)] > 0.0) {
        result.slip[at] = ratio(borne[static_cast<std::size_t>(p)], base::tangentialNorm(t));
      }
      if (kind.gapes && most > 0.0) result.gaping[at] = ratio(most, most - pressure);
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
  const ContactKind kind = ContactKind::of(interface, fields.times, step);
  if (!kind.gapes && !kind.slips) return;
  const std::vector<double> borne = kind.slips ? shearLimits(interface, fields, step) : std::vector<double>();
  for (int p = 0; p < fields.pairs; ++p) {
    const base::Vector3& t = fields.traction[fields.at(step, p)];
    const double area = interface.area[static_cast<std::size_t>(p)];
    sums.pressure += area * std::max(0.0, -t[0]);
    if (!kind.slips) continue;
    sums.capacity += area * borne[static_cast<std::size_t>(p)];
    sums.shear += area * base::tangentialNorm(t);
  }
}

}  // namespace harmos::latin
