#include <harmos/latin/LawFields.hpp>

#include <algorithm>

#include <harmos/laws/CoupledLaw.hpp>

namespace harmos::latin {
namespace {

// Of the compliance up to which a softening law meets every line once: what is taken, away from the bound.
constexpr double withinUniqueness = 0.5;

/// Of a line on which the pair is where it is; any does that meets the law only there, one of the size of the fields
/// keeps most digits.
double complianceOf(const laws::InterfaceLaw& law, const PairFields& fields) {
  double jump = 0.0, traction = 0.0;
  for (const base::Vector3& each : fields.jump) jump = std::max(jump, base::norm(each));
  for (const base::Vector3& each : fields.traction) traction = std::max(traction, base::norm(each));
  const double compliance = jump > 0.0 && traction > 0.0 ? jump / traction : 1.0;
  const double slope = law.lowestSlope();
  return slope < 0.0 ? std::min(compliance, -withinUniqueness / slope) : compliance;
}

}  // namespace

LawFields lawFields(const assembly::Interface& interface, const PairFields& fields) {
  const laws::InterfaceLaw& law = *interface.law;
  const auto pairs = static_cast<std::size_t>(fields.pairs), numbers = static_cast<std::size_t>(law.historySize());
  LawFields result;
  result.lost.assign(fields.jump.size(), 0.0);
  result.stored = result.lost;
  result.outputs.assign(law.outputs().size(), result.lost);
  const bool isGlobal = law.frame() == laws::Frame::global, dissipates = law.dissipates();
  const auto toLaw = [&](std::size_t p, const base::Vector3& v) {
    return isGlobal ? base::toGlobal(interface.frame[p], v) : v;
  };
  const double compliance = complianceOf(law, fields);
  std::vector<laws::LocalLine> lines(pairs, laws::LocalLine{{}, compliance});
  std::vector<laws::LocalState> states(pairs);
  std::vector<double> old(pairs * numbers, 0.0), now(pairs * numbers, 0.0), outputs(result.outputs.size());
  for (int t = 0; t < fields.steps; ++t) {
    laws::NodeArrays nodes = interface.nodes(fields.times, t);
    // A piece of a face does not tell what a law over all of it remembers, and such laws have no fields of their own.
    if (numbers > 0 && !laws::isCoupled(law)) {
      for (std::size_t p = 0; p < pairs; ++p) {
        const std::size_t at = fields.at(t, static_cast<int>(p));
        lines[p].freeJump = toLaw(p, fields.jump[at] + compliance * fields.traction[at]);
      }
      nodes.line = lines.data();
      nodes.oldHistory = old.data();
      nodes.newHistory = now.data();
      nodes.state = states.data();
      interface.solve(t, nodes);
    }
    for (std::size_t p = 0; p < pairs; ++p) {
      const std::size_t at = fields.at(t, static_cast<int>(p));
      laws::PairStep step;
      if (t > 0) step.oldJump = toLaw(p, fields.jump[at - pairs]);
      step.jump = toLaw(p, fields.jump[at]);
      step.traction = toLaw(p, fields.traction[at]);
      step.oldHistory = old.data() + p * numbers;
      step.history = now.data() + p * numbers;
      step.at = laws::NodeContext(t, nodes, static_cast<int>(p));
      if (dissipates) result.lost[at] = (t > 0 ? result.lost[at - pairs] : 0.0) + step.work() - law.keptWork(step);
      result.stored[at] = law.storedEnergy(step);
      if (outputs.empty()) continue;
      law.output(step, outputs.data());
      for (std::size_t i = 0; i < outputs.size(); ++i) result.outputs[i][at] = outputs[i];
    }
    old.swap(now);
  }
  return result;
}

}  // namespace harmos::latin
