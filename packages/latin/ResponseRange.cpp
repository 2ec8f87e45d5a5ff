#include <harmos/latin/ResponseRange.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

#include <harmos/base/Names.hpp>
#include <harmos/latin/detail/TractionShare.hpp>

namespace harmos::latin {
namespace {

/// Response::slope() of a pair of a finding, with what the reactions of boundaries at its nodes add that take what it
/// gives up.
base::Vector3 wholeSlope(const Iterate& state, const Response& response, const RedundantGroup::Pair& pair,
                         const Response::At& at, int step) {
  base::Vector3 slope = response.slope(state.assembly(), at);
  for (const RedundantGroup::Holder& holder : pair.holders) {
    const base::Vector3 there =
        response.slope(state.assembly(), {holder.interface, holder.pair, base::Vector3{}, base::Vector3{}});
    const auto tractionOf = [&](const base::Vector3& reaction) {
      return state.eliminated().traction(holder.interface, holder.pair, step, base::Vector3{}, reaction);
    };
    const base::Vector3 none = tractionOf(base::Vector3{});
    for (std::size_t c = 0; c < 3; ++c) {
      base::Vector3 reaction{};
      reaction[c] = -holder.share * pair.area;
      slope[c] += base::dot(there, tractionOf(reaction) - none);
    }
  }
  return slope;
}

/// The response where it is largest (sign 1) or smallest (sign -1) at every load step; infinite where that has no end.
/// Nothing where it feels none of the findings.
std::optional<std::vector<double>> extreme(const TractionShare& share,
                                           const std::vector<TractionShare::Finding>& findings, const Iterate& state,
                                           const Response& response, double sign,
                                           const std::function<void(const base::Matrix&)>& add) {
  const assembly::Assembly& assembly = state.assembly();
  base::Matrix difference(state.layout().rows(), assembly.steps());
  std::vector<bool> isEndless(assembly.steps(), false);
  bool isFelt = false;
  for (const TractionShare::Finding& finding : findings) {
    const auto& pairs = share.pairs(finding);
    std::vector<base::Vector3> slopes;
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      const Response::At at{pairs[j].interface, pairs[j].pair, finding.tractions[j],
                            finding.jumps[j] - finding.oldJumps[j]};
      slopes.push_back(sign * wholeSlope(state, response, pairs[j], at, finding.step));
    }
    if (!finding.stress.changes(slopes)) continue;
    isFelt = true;
    const auto tractions = finding.stress.farthest(slopes);
    if (tractions) {
      share.addDifference(finding, *tractions, state.layout(), difference);
    } else {
      isEndless[finding.step] = true;
    }
  }
  if (!isFelt) return std::nullopt;
  add(difference);
  std::vector<double> values = response.evaluate(state);
  difference *= -1.0;
  add(difference);
  for (std::size_t t = 0; t < values.size(); ++t) {
    if (isEndless[t]) values[t] = sign * std::numeric_limits<double>::infinity();
  }
  return values;
}

/// Whether the pressure that friction at a pair lives on may be another by more than `tolerance` of what is there.
bool hasFreePressure(const TractionShare::Finding& finding, std::size_t place, const assembly::Interface& interface,
                     int pair, double tolerance) {
  const auto admissible = interface.law->admissibleTractions(finding.step);
  const base::Vector3& n = interface.frame[pair][0];
  if (!admissible || admissible->friction == 0.0) return false;
  double size = 0.0;
  for (const base::Vector3& t : finding.tractions) size = std::max(size, base::norm(t));
  const auto isFreeBy = [&](const SelfStress& stress) {
    if (!stress.actsOn(place, n)) return false;
    for (const double sign : {-1.0, 1.0}) {
      std::vector<base::Vector3> weights(finding.tractions.size(), base::Vector3{});
      weights[place] = sign * n;
      const auto farthest = stress.farthest(weights);
      if (!farthest || std::abs(base::dot((*farthest)[place] - finding.tractions[place], n)) > tolerance * size)
        return true;
    }
    return false;
  };
  return isFreeBy(finding.stress) || isFreeBy(finding.pressures);
}

}  // namespace

int ResponseRange::widest() const {
  int widest = lower.empty() ? -1 : 0;
  for (int t = 1; t < static_cast<int>(lower.size()); ++t) {
    if (upper[t] - lower[t] > upper[widest] - lower[widest]) widest = t;
  }
  return widest;
}

double ResponseRange::width() const {
  return lower.empty() ? 0.0 : upper[widest()] - lower[widest()];
}

std::string describe(const std::string& response, const ResponseRange& range, const std::vector<double>& values) {
  const int step = range.widest();
  std::ostringstream text;
  text << "response " << base::quoted(response) << " is not determined: at load step " << step + 1 << " ";
  const double lower = range.lower[step], upper = range.upper[step];
  if (std::isinf(lower) && std::isinf(upper)) {
    text << "any value";
  } else if (std::isinf(upper)) {
    text << "any value from " << lower << " on";
  } else if (std::isinf(lower)) {
    text << "any value up to " << upper;
  } else {
    text << "any value from " << lower << " to " << upper;
  }
  text << " goes with the same displacements, since joints share there what parts feel the sum of; " << values[step]
       << " is that of the least tractions";
  return text.str();
}

Indeterminacy findIndeterminacy(const TractionShare& share, const Iterate& state,
                                const std::vector<std::shared_ptr<const Response>>& responses, double tolerance,
                                const std::function<void(const base::Matrix&)>& add) {
  Indeterminacy result;
  result.responses.resize(responses.size());
  const std::vector<TractionShare::Finding> findings = share.find(state, tolerance);
  constexpr double noEnd = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < responses.size(); ++i) {
    if (share.dependsOnHolders([&](int interface, int pair) {
          return responses[i]->slope(state.assembly(), {interface, pair, base::Vector3{}, base::Vector3{}});
        })) {
      const std::vector<double> all(state.assembly().steps(), noEnd), none(state.assembly().steps(), -noEnd);
      result.responses[i] = {none, all};
      continue;
    }
    if (findings.empty()) continue;
    auto lower = extreme(share, findings, state, *responses[i], -1.0, add);
    auto upper = extreme(share, findings, state, *responses[i], 1.0, add);
    if (!lower || !upper) continue;
    const std::vector<double> here = responses[i]->evaluate(state);
    for (std::size_t t = 0; t < here.size(); ++t) {
      (*lower)[t] = std::min((*lower)[t], here[t]);
      (*upper)[t] = std::max((*upper)[t], here[t]);
    }
    result.responses[i] = {std::move(*lower), std::move(*upper)};
  }
  std::set<std::string> names;
  for (const TractionShare::Finding& finding : findings) {
    const auto& pairs = share.pairs(finding);
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      const assembly::Interface& interface = state.assembly().interfaces[pairs[j].interface];
      if (names.count(interface.name) == 0 && hasFreePressure(finding, j, interface, pairs[j].pair, tolerance))
        names.insert(interface.name);
    }
  }
  result.pressures.assign(names.begin(), names.end());
  return result;
}

}  // namespace harmos::latin
