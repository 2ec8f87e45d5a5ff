#include <harmos/latin/Dissipation.hpp>

#include <algorithm>

namespace harmos::latin {
namespace {

/// A line on which the pair is where it is; any compliance does, one of the size of the fields keeps most digits.
laws::LocalLine lineThrough(const base::Vector3& jump, const base::Vector3& traction, double compliance) {
  return {jump + compliance * traction, compliance};
}

double complianceOf(const PairFields& fields) {
  double jump = 0.0, traction = 0.0;
  for (const base::Vector3& each : fields.jump) jump = std::max(jump, base::norm(each));
  for (const base::Vector3& each : fields.traction) traction = std::max(traction, base::norm(each));
  return jump > 0.0 && traction > 0.0 ? jump / traction : 1.0;
}

}  // namespace

std::vector<double> lostWork(const assembly::Interface& interface, const PairFields& fields) {
  const laws::InterfaceLaw& law = *interface.law;
  const auto pairs = static_cast<std::size_t>(fields.pairs), numbers = static_cast<std::size_t>(law.historySize());
  std::vector<double> lost(fields.jump.size(), 0.0);
  if (!law.dissipates()) return lost;
  const bool isGlobal = law.frame() == laws::Frame::global;
  const auto toLaw = [&](std::size_t p, const base::Vector3& v) {
    return isGlobal ? base::toGlobal(interface.frame[p], v) : v;
  };
  const double compliance = complianceOf(fields);
  std::vector<laws::LocalLine> lines(pairs);
  std::vector<laws::LocalState> states(pairs);
  std::vector<double> old(pairs * numbers, 0.0), now(pairs * numbers, 0.0);
  for (int t = 0; t < fields.steps; ++t) {
    for (std::size_t p = 0; p < pairs; ++p) {
      const std::size_t at = fields.at(t, static_cast<int>(p));
      lines[p] = lineThrough(toLaw(p, fields.jump[at]), toLaw(p, fields.traction[at]), compliance);
    }
    if (numbers > 0) {
      law.solve(t, {fields.pairs, lines.data(), interface.gap.data(), old.data(), now.data(), states.data()});
    }
    for (std::size_t p = 0; p < pairs; ++p) {
      const std::size_t at = fields.at(t, static_cast<int>(p));
      laws::PairStep step;
      if (t > 0) step.oldJump = toLaw(p, fields.jump[at - pairs]);
      step.jump = toLaw(p, fields.jump[at]);
      step.traction = toLaw(p, fields.traction[at]);
      step.oldHistory = old.data() + p * numbers;
      step.history = now.data() + p * numbers;
      lost[at] = (t > 0 ? lost[at - pairs] : 0.0) + step.work() - law.keptWork(step);
    }
    old.swap(now);
  }
  return lost;
}

}  // namespace harmos::latin
