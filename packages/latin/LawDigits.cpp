#include <harmos/latin/detail/LawDigits.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

#include <harmos/base/Names.hpp>
#include <harmos/latin/detail/FirstText.hpp>
#include <harmos/latin/detail/RoundOff.hpp>
#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/laws/LawFailure.hpp>
#include <harmos/laws/NewtonOnLine.hpp>

namespace harmos::latin {
namespace {

// Of the compliance of the solver's lines: least jump over traction that a line is turned to.
constexpr double leastCompliance = 1e-3;
// Of the free jump: lengths around it over which a law is asked, each over the next one. Kinks and bends scatter over
// some of them, round-off over all that are so many times longer than itself.
constexpr double longest = 0.1, alwaysAsked = 3e-3, shortest = 1e-7;
constexpr double shorter = 3.1622776601683795;
constexpr double beyondRoundOff = 100.0;
// Of the places: where all of them are scattered, so is the best quarter, but not where a kink is; how much less at
// most than the middle one, whose size times that of a rare deviation counts.
constexpr std::size_t quarter = laws::Scatter::windows / 4, half = laws::Scatter::windows / 2;
constexpr double alike = 0.05;
constexpr double rare = 3.0;
// Of k w: tractions below this are round-off themselves, as in a body that only turns, and are measured by it
// (NaturalSizes).
constexpr double leastTraction = 1e-7;
// Of the accuracy: round-off of a law in which corrections have come to no end.
constexpr double disturbing = 1e-4;

/// One pair of an interface, on lines of a compliance like that of the law: stiffer laws hide their round-off behind
/// softer lines.
class Probe {
 public:
  Probe(const assembly::Assembly& assembly, const assembly::Interface& interface, const PointwiseLocalStage::Met& met,
        int pair)
      : law_(*interface.law), step_(met.step), pair_(pair), line_(met.lines[static_cast<std::size_t>(pair)]) {
    const base::Vector3& traction = met.states[pair].traction;
    const base::Vector3 jump = line_.jump(traction);
    const double own = norm(jump) / norm(traction);
    if (own >= leastCompliance * line_.compliance) line_.compliance = std::min(line_.compliance, own);
    middle_ = jump + line_.compliance * traction;
    scale_ = norm(jump) + 2.0 * line_.compliance * norm(traction);
    const auto numbers = static_cast<std::size_t>(law_.historySize());
    history_.resize(numbers);
    nodes_ = interface.nodes(assembly.times, step_);
    nodes_.count = 1;
    nodes_.line = &line_;
    nodes_.gap += pair;
    nodes_.oldHistory = met.oldHistory.data() + static_cast<std::size_t>(pair) * numbers;
    nodes_.newHistory = history_.data();
    nodes_.state = &state_;
    if (nodes_.position != nullptr) nodes_.position += pair;
    if (nodes_.frame != nullptr) nodes_.frame += pair;
    if (nodes_.area != nullptr) nodes_.area += pair;
    if (nodes_.number != nullptr) {
      nodes_.number += pair;
    } else {
      nodes_.number = &pair_;
    }
  }
  Probe(const Probe&) = delete;
  Probe& operator=(const Probe&) = delete;

  /// Free jump of the line through the point that was met, and the size of its terms [length].
  const base::Vector3& middle() const { return middle_; }
  double scale() const { return scale_; }

  base::Vector3 operator()(const base::Vector3& freeJump) {
    line_.freeJump = freeJump;
    try {
      law_.solve(step_, nodes_);
    } catch (const laws::LawFailure&) {
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      return {none, none, none};
    }
    return state_.traction;
  }

 private:
  const laws::InterfaceLaw& law_;
  int step_, pair_;
  laws::LocalLine line_;
  base::Vector3 middle_{};
  double scale_ = 0.0;
  laws::LocalState state_;
  std::vector<double> history_;
  laws::NodeArrays nodes_;
};

/// Round-off of the tractions of an interface over the largest of them, or what they are measured by [-], at a load
/// step.
std::pair<double, int> roundOffOfLaw(FixedPoint& fixedPoint, int index) {
  const assembly::Assembly& assembly = fixedPoint.assembly();
  const assembly::Interface& interface = assembly.interfaces[index];
  const PointwiseLocalStage& stage = fixedPoint.pointwiseStage();
  const std::vector<laws::LocalState>& states = stage.states(index);
  const int columns = static_cast<int>(states.size()) / std::max(1, interface.pairs());
  if (columns == 0) return {0.0, -1};
  const auto isLess = [](const laws::LocalState& a, const laws::LocalState& b) {
    return norm(a.traction) < norm(b.traction);
  };
  const PointwiseLocalStage::Met met = stage.met(index, columns - 1);
  const laws::LocalState* const end = met.states + interface.pairs();
  const int pair = static_cast<int>(std::max_element(met.states, end, isLess) - met.states);
  if (!(norm(met.states[pair].traction) > 0.0)) return {0.0, met.step};
  const laws::LocalLine& line = met.lines[static_cast<std::size_t>(pair)];
  const double largest = std::max(norm(std::max_element(states.begin(), states.end(), isLess)->traction),
                                  leastTraction * norm(line.freeJump) / line.compliance);
  Probe probe(assembly, interface, met, pair);
  double least = std::numeric_limits<double>::infinity(), usual = least;
  for (double share = longest;
       share >= alwaysAsked || (least > 0.0 && share >= std::max(shortest, beyondRoundOff * least)); share /= shorter) {
    const laws::Scatter scatter(probe, probe.middle(), share * probe.scale());
    if (!std::isfinite(scatter.largest)) return {0.0, met.step};
    least = std::min(least, scatter.sizes[quarter] / largest);
    usual = std::min(usual, scatter.sizes[half] / largest);
  }
  return {least >= alike * usual ? rare * usual : least, met.step};
}

/// 'law "L" of interface "I" leaves its tractions no digits below ... ' of the law with most round-off, more than
/// `least`, and `remedy` of that round-off; empty: there is none.
std::string describeWorst(FixedPoint& fixedPoint, double least, const std::function<std::string(double)>& remedy) {
  const assembly::Assembly& assembly = fixedPoint.assembly();
  double worst = least;
  std::string mine;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const auto index = static_cast<int>(i);
    const laws::InterfaceLaw& law = *assembly.interfaces[i].law;
    if (fixedPoint.layout().begin(index, 0) < 0 || law.isAffine() || laws::isCoupled(law)) continue;
    const auto [roundOff, step] = roundOffOfLaw(fixedPoint, index);
    if (!(roundOff > worst)) continue;
    worst = roundOff;
    std::ostringstream text;
    text.precision(2);
    text << "law " << base::quoted(law.name()) << " of interface " << base::quoted(assembly.interfaces[i].name)
         << " leaves its tractions no digits below " << roundOff << " of the largest, as at load step " << step + 1
         << ", since large terms cancel in it" << remedy(roundOff) << ", or write it without such terms";
    mine = text.str();
  }
  return firstText(mine, fixedPoint.layout().comm());
}

std::string askFor(double accuracy) {
  std::ostringstream text;
  text.precision(2);
  text << "; ask for an accuracy of " << accuracy << " or more";
  return text.str();
}

}  // namespace

std::string lackOfDigits(FixedPoint& fixedPoint, double accuracy) {
  const std::string worst = describeWorst(fixedPoint, shareOfRoundOff * accuracy,
                                          [](double roundOff) { return askFor(roundOff / shareOfRoundOff); });
  return worst.empty() ? worst : "double precision does not give this accuracy: " + worst;
}

std::string scatterOfLaws(FixedPoint& fixedPoint, double accuracy) {
  return describeWorst(fixedPoint, disturbing * accuracy, [](double roundOff) {
    return ", and corrections may come to no end in that" + askFor(roundOff / disturbing);
  });
}

}  // namespace harmos::latin
