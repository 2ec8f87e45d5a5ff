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

// Interfaces that a sentence names.
constexpr std::size_t mostNames = 6;

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

/// How far the pressure that friction at a pair lives on may go.
struct PressureRange {
  bool isFree = false;  ///< it may be another by more than the tolerance
  /// The tractions of the group where it is least and largest, if that has an end.
  std::vector<std::vector<base::Vector3>> ends;
};

PressureRange pressureRange(const TractionShare::Finding& finding, std::size_t place,
                            const assembly::Interface& interface, int pair, double tolerance) {
  const base::Vector3& n = interface.frame[pair][0];
  PressureRange range;
  if (!finding.stress.hasFriction(place, n)) return range;
  double size = 0.0;
  for (const base::Vector3& t : finding.tractions) size = std::max(size, base::norm(t));
  for (const SelfStress* stress : {&finding.stress, &finding.pressures}) {
    if (!stress->actsOn(place, n)) continue;
    range.ends.clear();
    for (const double sign : {1.0, -1.0}) {
      std::vector<base::Vector3> weights(finding.tractions.size(), base::Vector3{});
      weights[place] = sign * n;
      const auto farthest = stress->farthest(weights);
      if (!farthest || std::abs(base::dot((*farthest)[place] - finding.tractions[place], n)) > tolerance * size)
        range.isFree = true;
      range.ends.push_back(farthest ? *farthest : finding.tractions);
    }
    if (range.isFree) break;
  }
  return range;
}

/// Indeterminacy::pressures and ways.
void addPressures(const TractionShare& share, const std::vector<TractionShare::Finding>& findings, const Iterate& state,
                  double tolerance, Indeterminacy& result) {
  std::set<std::string> names;
  for (const TractionShare::Finding& finding : findings) {
    const auto& pairs = share.pairs(finding);
    bool goesSomeWay = false;
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      const assembly::Interface& interface = state.assembly().interfaces[pairs[j].interface];
      if (goesSomeWay && names.count(interface.name) != 0) continue;
      const PressureRange range = pressureRange(finding, j, interface, pairs[j].pair, tolerance);
      if (!range.isFree) continue;
      names.insert(interface.name);
      if (goesSomeWay) continue;
      goesSomeWay = true;
      result.ways.resize(range.ends.size());
      for (std::size_t i = 0; i < range.ends.size(); ++i) {
        if (result.ways[i].numRows() == 0) result.ways[i].shape(state.layout().rows(), state.assembly().steps());
        share.addDifference(finding, range.ends[i], state.layout(), result.ways[i]);
      }
    }
  }
  result.pressures.assign(names.begin(), names.end());
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

void ResponseRange::extend(const std::vector<double>& values, const std::vector<double>& others, double tolerance) {
  const std::vector<double> least = lower.empty() ? values : lower, most = upper.empty() ? values : upper;
  for (std::size_t t = 0; t < others.size(); ++t) {
    if (others[t] >= least[t] - tolerance && others[t] <= most[t] + tolerance) continue;
    if (lower.empty()) {
      lower = values;
      upper = values;
    }
    goesToOtherMotions = true;
    lower[t] = std::min(lower[t], others[t]);
    upper[t] = std::max(upper[t], others[t]);
  }
}

std::string describePressures(const std::vector<std::string>& interfaces) {
  std::vector<std::string> names;
  for (const std::string& name : interfaces) names.push_back(base::quoted(name));
  return "pressures are not determined where pairs of " + base::joinNames(names, mostNames) +
         " meet at one node, and their friction with them: there may be other solutions, with other displacements";
}

std::string describe(const std::string& response, const ResponseRange& range, const std::vector<double>& values) {
  const int step = range.widest();
  std::ostringstream text;
  text << "response " << base::quoted(response) << " is not determined: at load step " << step + 1 << " ";
  const double lower = range.lower[step], upper = range.upper[step];
  if (range.goesToOtherMotions && std::isfinite(lower) && std::isfinite(upper)) {
    text << "solutions with other pressures and displacements give from " << lower << " to " << upper
         << ", and there may be more; " << values[step] << " is that of this one";
    return text.str();
  }
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
       << (range.isOneOfMany ? " is one of them" : " is that of the least tractions which leave gaps open");
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
    const SharedReactions::Open open = share.reactions().leaveOpen([&](int interface, int pair) {
      return responses[i]->slope(state.assembly(), {interface, pair, base::Vector3{}, base::Vector3{}});
    });
    if (open != SharedReactions::Open::no) {
      const std::vector<double> all(state.assembly().steps(), noEnd), none(state.assembly().steps(), -noEnd);
      result.responses[i] = {none, all, false, open == SharedReactions::Open::atFaces};
      continue;
    }
    if (findings.empty()) continue;
    auto lower = extreme(share, findings, state, *responses[i], -1.0, add);
    auto upper = extreme(share, findings, state, *responses[i], 1.0, add);
    if (!lower || !upper) continue;
    const std::vector<double> here = responses[i]->evaluate(state);
    for (std::size_t t = 0; t < here.size(); ++t) {
      // A magnitude also grows where its slope, perhaps that of tractions that are nearly nothing, says it falls.
      if (responses[i]->isMagnitude() && std::isinf((*lower)[t])) (*lower)[t] = noEnd;
      const auto [least, most] = std::minmax({(*lower)[t], (*upper)[t], here[t]});
      (*lower)[t] = least;
      (*upper)[t] = most;
    }
    result.responses[i] = {std::move(*lower), std::move(*upper), false, false};
  }
  addPressures(share, findings, state, tolerance, result);
  return result;
}

}  // namespace harmos::latin
