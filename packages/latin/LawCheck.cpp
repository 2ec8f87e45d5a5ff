#include <harmos/latin/LawCheck.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/AllRanks.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/latin/FaceSums.hpp>
#include <harmos/latin/detail/FirstText.hpp>
#include <harmos/latin/detail/LawDigits.hpp>
#include <harmos/laws/LawFailure.hpp>

namespace harmos::latin {
namespace {

// Of the compliance of the solver's lines. Softening laws meet only the steeper lines once for sure.
constexpr double steeper = 0.25;
constexpr double flatter = 4.0;
// Of the free jump along the normal or along the surface: how far on a law that says that it never falls is asked.
constexpr double farther = 1.1;
// Units in the last place of the free jump, which the law must tell apart.
constexpr double digitsOfJump = 1e4 * std::numeric_limits<double>::epsilon();
// Of the largest traction: what laws whose points are found numerically may leave.
constexpr double digitsOfLaws = 1e-7;
// Of the largest traction times the largest jump of an interface: what counts as energy.
constexpr double smallestEnergy = 1e-6;

/// Where something is worst.
struct Worst {
  double size = 0.0;
  int step = -1;
  int pair = -1;

  void include(double candidate, int atStep, int atPair) {
    if (!(candidate > size)) return;
    size = candidate;
    step = atStep;
    pair = atPair;
  }
};

/// What is looked for: laws without a graph, or also those that fall and energies that do not go together.
enum class Search { graphs, all };

/// One interface along the load steps.
class Watch {
 public:
  Watch(const assembly::Assembly& assembly, int index, Search search)
      : assembly_(assembly),
        interface_(assembly.interfaces[index]),
        law_(*interface_.law),
        search_(search),
        states_(static_cast<std::size_t>(interface_.pairs())),
        now_(states_.size() * static_cast<std::size_t>(law_.historySize())) {
    if (std::isfinite(law_.lowestSlope())) ratios_.push_back(steeper);
    if (law_.lowestSlope() == 0.0) ratios_.push_back(flatter);
    if (search_ == Search::all && law_.dissipates() && !laws::isCoupled(law_)) jumps_.assign(states_.size(), {});
    stored_.assign(jumps_.size(), 0.0);
    lengths_.assign(jumps_.size(), 0.0);
  }

  void look(const PointwiseLocalStage::Met& met) {
    for (std::size_t p = 0; p < states_.size(); ++p) {
      traction_ = std::max(traction_, norm(met.states[p].traction));
      jump_ = std::max(jump_, norm(met.lines[p].jump(met.states[p].traction)));
    }
    if (!jumps_.empty()) balance(met);
  }

  /// Whether the law says that lines of this compliance, over that of the solver, meet it at one point.
  bool answers(double ratio) const { return std::find(ratios_.begin(), ratios_.end(), ratio) != ratios_.end(); }

  /// The lines of that compliance through the points that were found.
  static std::vector<laws::LocalLine> turned(const PointwiseLocalStage::Met& met, double ratio) {
    std::vector<laws::LocalLine> lines(met.lines);
    for (std::size_t p = 0; p < lines.size(); ++p) {
      const base::Vector3& traction = met.states[p].traction;
      lines[p].freeJump = met.lines[p].jump(traction) + ratio * met.lines[p].compliance * traction;
      lines[p].compliance *= ratio;
    }
    return lines;
  }

  void compare(const PointwiseLocalStage::Met& met, double ratio) {
    const std::vector<laws::LocalLine> lines = turned(met, ratio);
    try {
      law_.solve(met.step, arrays(met, lines));
    } catch (const laws::LawFailure&) {
      return;  // it has met the lines of the solver
    }
    include(met, lines);
  }

  /// The same of a law over a whole face, in two turns: its share of the sums, and what it makes of all of them.
  void addToSums(const PointwiseLocalStage::Met& met, double ratio, int index, FaceSums& sums) {
    const std::vector<laws::LocalLine> lines = turned(met, ratio);
    sums.add(index, 0, met.step, arrays(met, lines));
  }
  void compare(const PointwiseLocalStage::Met& met, double ratio, int index, const FaceSums& sums, double lost) {
    const std::vector<laws::LocalLine> lines = turned(met, ratio);
    sums.law(index)->solvePoints(met.step, arrays(met, lines), sums.of(index, 0));
    include(met, lines, lost);
  }
  /// Of its tractions: what the digits of its free jumps leave open of sums over the face.
  double lostOfSums(const PointwiseLocalStage::Met& met, double ratio) const {
    const std::vector<laws::LocalLine> lines = turned(met, ratio);
    double largest = 0.0;
    for (std::size_t p = 0; p < lines.size(); ++p) largest = std::max(largest, loss(met, lines, p));
    return largest;
  }

  /// Whether it is asked farther on: the law says that its traction never falls while the jump grows.
  bool isAskedFarther() const {
    return search_ == Search::all && law_.lowestSlope() == 0.0 && !law_.isAffine() && !laws::isCoupled(law_);
  }

  /// Asks for a point farther on along the normal (`first` 0, `end` 1) or along the surface (1, 3), with the history of
  /// the points that were found. A monotone law answers each with (t_a - t_b).(delta_a - delta_b) >= 0, and so it does
  /// with the components of that direction alone, since the others leave -H |t_a - t_b|^2.
  void goFarther(const PointwiseLocalStage::Met& met, std::size_t first, std::size_t end) {
    std::vector<laws::LocalLine> lines(met.lines);
    for (laws::LocalLine& line : lines) {
      for (std::size_t c = first; c < end; ++c) line.freeJump[c] *= farther;
    }
    try {
      law_.solve(met.step, arrays(met, lines));
    } catch (const laws::LawFailure&) {
      return;  // it has met the lines of the solver
    }
    for (std::size_t p = 0; p < lines.size(); ++p) {
      const base::Vector3& traction = met.states[p].traction;
      const base::Vector3 change = states_[p].traction - traction;
      const base::Vector3 way = lines[p].jump(states_[p].traction) - met.lines[p].jump(traction);
      double work = 0.0;
      for (std::size_t c = first; c < end; ++c) work += change[c] * way[c];
      if (!(work < 0.0)) continue;
      const double lost = loss(met, lines, p);
      if (first > 0 && std::abs(change[0]) > lost) continue;  // friction depends on the pressure
      double force = 0.0, length = 0.0;
      for (std::size_t c = first; c < end; ++c) {
        force = std::hypot(force, change[c]);
        length = std::hypot(length, way[c]);
      }
      falls_.include(-work / (length + lines[p].compliance * force) - lost, met.step, static_cast<int>(p));
    }
  }

  /// Empty: it does not fall, or says so.
  std::string falls(double accuracy) const {
    if (!(falls_.size > std::max(accuracy, digitsOfLaws) * traction_)) return {};
    return "law " + base::quoted(law_.name()) + " of interface " + base::quoted(interface_.name) +
           " says that its traction never falls (lowest slope 0), but it falls while the jump grows, worst in load "
           "step " +
           std::to_string(falls_.step + 1) + " at point " + std::to_string(falls_.pair + 1) +
           ": there may be other solutions; state its lowest slope";
  }

  /// Empty: the law has a graph.
  std::string falseGraph(double accuracy) const {
    if (!(difference_.size > std::max(accuracy, digitsOfLaws) * traction_)) return {};
    return "interface " + base::quoted(interface_.name) + ", load step " + std::to_string(difference_.step + 1) +
           ", point " + std::to_string(difference_.pair + 1) + ": law " + base::quoted(law_.name()) +
           " gives another traction at the same jump when it is asked with another search direction, by " +
           base::toText(std::round(1000.0 * difference_.size / traction_) / 10.0) +
           " % of its largest: it does not solve its own equations, or its traction falls while the jump grows by more "
           "than it says (lowest slope). The result would depend on the search direction; run the conformance suite on "
           "the law";
  }

  /// Empty: its energies go together. Digits are taken off already.
  std::string energies() const {
    const double small = smallestEnergy * traction_ * jump_;
    const auto remark = [&](const Worst& worst, const std::string& what) {
      return "law " + base::quoted(law_.name()) + " of interface " + base::quoted(interface_.name) + " " + what +
             ", worst in load step " + std::to_string(worst.step + 1) + " at point " + std::to_string(worst.pair + 1) +
             ": do not rely on its dissipation";
    };
    if (broken_.size > 0.0) return remark(broken_, "gives energies that are not finite");
    if (gain_.size > small) return remark(gain_, "keeps more work than is done on it");
    if (excess_.size > small) return remark(excess_, "stores more energy than the work that it keeps");
    return {};
  }

 private:
  laws::NodeArrays arrays(const PointwiseLocalStage::Met& met, const std::vector<laws::LocalLine>& lines) {
    return arrays(met, lines, met.step);
  }
  laws::NodeArrays arrays(const PointwiseLocalStage::Met& met, const std::vector<laws::LocalLine>& lines, int step) {
    laws::NodeArrays nodes = interface_.nodes(assembly_.times, step);
    nodes.line = lines.data();
    nodes.oldHistory = met.oldHistory.data();
    nodes.newHistory = now_.data();
    nodes.state = states_.data();
    return nodes;
  }

  /// `least`: of every traction that much is lost.
  void include(const PointwiseLocalStage::Met& met, const std::vector<laws::LocalLine>& lines, double least = 0.0) {
    for (std::size_t p = 0; p < lines.size(); ++p) {
      const double change = norm(states_[p].traction - met.states[p].traction);
      const double lost = std::max(least, loss(met, lines, p));
      difference_.include(std::isfinite(change) ? change - lost : std::numeric_limits<double>::max(), met.step,
                          static_cast<int>(p));
    }
  }

  /// Of the traction of a pair: what the digits of its free jump leave open.
  static double loss(const PointwiseLocalStage::Met& met, const std::vector<laws::LocalLine>& lines, std::size_t pair) {
    return digitsOfJump * (norm(met.lines[pair].freeJump) / lines[pair].compliance + norm(met.states[pair].traction));
  }

  /// Which pairs the law answers as it would have in the load step before: nothing that it was given has changed, as
  /// the place of a tool or a gap with a history does, which do work that its energies know nothing of.
  std::vector<bool> constantPairs(const PointwiseLocalStage::Met& met) {
    const std::vector<laws::LocalState> states(states_);
    const std::vector<double> history(now_);
    law_.solve(met.step - 1, arrays(met, met.lines, met.step - 1));
    const auto numbers = static_cast<std::ptrdiff_t>(law_.historySize());
    std::vector<bool> result(states_.size());
    for (std::size_t p = 0; p < states_.size(); ++p) {
      const auto first = static_cast<std::ptrdiff_t>(p) * numbers;
      result[p] = states[p].traction == states_[p].traction &&
                  std::equal(history.begin() + first, history.begin() + first + numbers, now_.begin() + first);
    }
    now_ = history;
    return result;
  }

  void balance(const PointwiseLocalStage::Met& met) {
    law_.solve(met.step, arrays(met, met.lines));
    // What it has stored at the unloaded start is not known, and long load steps do not feel how softening goes on.
    const std::vector<bool> isConstant =
        met.step > 0 && law_.lowestSlope() == 0.0 ? constantPairs(met) : std::vector<bool>(states_.size(), false);
    laws::NodeArrays nodes = interface_.nodes(assembly_.times, met.step);
    const auto numbers = static_cast<std::size_t>(law_.historySize());
    for (std::size_t p = 0; p < states_.size(); ++p) {
      laws::PairStep step;
      step.oldJump = jumps_[p];
      step.traction = met.states[p].traction;
      step.jump = met.lines[p].jump(step.traction);
      step.oldHistory = met.oldHistory.data() + p * numbers;
      step.history = now_.data() + p * numbers;
      step.at = laws::NodeContext(met.step, nodes, static_cast<int>(p));
      const double kept = law_.keptWork(step), stored = law_.storedEnergy(step);
      if (!std::isfinite(kept) || !std::isfinite(stored)) {
        broken_.include(std::numeric_limits<double>::max(), met.step, static_cast<int>(p));
      }
      // A jump has the digits of the free jump that it is left of.
      const double length = norm(met.lines[p].freeJump);
      const double digits =
          digitsOfJump * (norm(step.traction) * (length + lengths_[p]) + std::abs(stored) + std::abs(stored_[p]));
      gain_.include(kept - step.work() - digits, met.step, static_cast<int>(p));
      if (isConstant[p]) excess_.include(stored - stored_[p] - kept - digits, met.step, static_cast<int>(p));
      jumps_[p] = step.jump;
      stored_[p] = stored;
      lengths_[p] = length;
    }
  }

  const assembly::Assembly& assembly_;
  const assembly::Interface& interface_;
  const laws::InterfaceLaw& law_;
  Search search_;
  std::vector<double> ratios_;
  std::vector<laws::LocalState> states_;  // scratch, as the next
  std::vector<double> now_;
  std::vector<base::Vector3> jumps_;  // of the load step before; empty: the law does not dissipate
  std::vector<double> stored_;
  std::vector<double> lengths_;         // of their free jumps
  double traction_ = 0.0, jump_ = 0.0;  // largest
  Worst difference_, falls_, broken_, gain_, excess_;
};

/// Watches of interfaces, by their numbers.
using Watches = std::vector<std::pair<int, Watch>>;

/// Of every interface what lostOfSums() is of all of its face, on all ranks. Collective.
std::vector<double> lostOfFaces(const Watches& watches, const FaceSums& faces, const PointwiseLocalStage& stage,
                                const assembly::Assembly& assembly, int step, double ratio,
                                const Teuchos::Comm<int>& comm) {
  std::vector<double> mine(assembly.interfaces.size(), 0.0), all(mine);
  for (const auto& [index, watch] : watches) {
    if (faces.law(index) != nullptr && watch.answers(ratio))
      mine[index] = watch.lostOfSums(stage.met(index, step), ratio);
  }
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, static_cast<int>(mine.size()), mine.data(), all.data());
  std::map<int, double> ofFaces;
  for (const int i : faces.interfaces()) {
    double& most = ofFaces[assembly.interfaces[i].face];
    most = std::max(most, all[i]);
  }
  for (const int i : faces.interfaces()) {
    if (assembly.interfaces[i].face >= 0) all[i] = ofFaces[assembly.interfaces[i].face];
  }
  return all;
}

/// Asks the laws of all interfaces of this rank. Collective.
Watches ask(FixedPoint& fixedPoint, const Iterate& iterate, Search search) {
  const assembly::Assembly& assembly = fixedPoint.assembly();
  const TraceLayout& layout = fixedPoint.layout();
  Watches watches;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const auto index = static_cast<int>(i);
    if (layout.begin(index, 0) < 0) continue;
    watches.emplace_back(index, Watch(assembly, index, search));
  }
  FaceSums faces(assembly, layout);
  PointwiseLocalStage& stage = fixedPoint.pointwiseStage();
  std::vector<double> traction(static_cast<std::size_t>(iterate.beta().numRows()));
  stage.begin();
  for (int t = 0; t < iterate.beta().numCols(); ++t) {
    stage.solveColumn(t, iterate.beta(), traction.data());
    base::onEachRank(layout.comm(), [&] {
      for (auto& [index, watch] : watches) {
        watch.look(stage.met(index, t));
        if (!watch.isAskedFarther()) continue;
        watch.goFarther(stage.met(index, t), 0, 1);
        watch.goFarther(stage.met(index, t), 1, 3);
      }
    });
    for (const double ratio : {steeper, flatter}) {
      if (!faces.isEmpty()) faces.begin(1);
      base::onEachRank(layout.comm(), [&] {
        for (auto& [index, watch] : watches) {
          if (!watch.answers(ratio)) continue;
          if (faces.law(index) == nullptr) {
            watch.compare(stage.met(index, t), ratio);
          } else {
            watch.addToSums(stage.met(index, t), ratio, index, faces);
          }
        }
      });
      if (faces.isEmpty()) continue;
      faces.finish();
      // Sums over a face have the digits of the largest of its parts.
      const std::vector<double> lost = lostOfFaces(watches, faces, stage, assembly, t, ratio, layout.comm());
      base::onEachRank(layout.comm(), [&] {
        for (auto& [index, watch] : watches) {
          if (faces.law(index) != nullptr && watch.answers(ratio))
            watch.compare(stage.met(index, t), ratio, index, faces, lost[index]);
        }
      });
    }
    stage.accept();
  }
  return watches;
}

/// Collective. Empty: all laws have a graph.
std::string falseGraph(const Watches& watches, double accuracy, const Teuchos::Comm<int>& comm) {
  std::string mine;
  for (const auto& [index, watch] : watches) {
    if (mine.empty()) mine = watch.falseGraph(accuracy);
  }
  return firstText(mine, comm);
}

}  // namespace

std::string lackOfGraph(FixedPoint& fixedPoint, const Iterate& iterate, double accuracy) {
  const Watches watches = ask(fixedPoint, iterate, Search::graphs);
  const std::string found = falseGraph(watches, accuracy, fixedPoint.layout().comm());
  return found.empty() ? lackOfDigits(fixedPoint, accuracy) : found;
}

LawFindings checkLaws(FixedPoint& fixedPoint, const Iterate& iterate, double accuracy) {
  const assembly::Assembly& assembly = fixedPoint.assembly();
  const TraceLayout& layout = fixedPoint.layout();
  const Watches watches = ask(fixedPoint, iterate, Search::all);
  LawFindings findings;
  findings.falseGraph = falseGraph(watches, accuracy, layout.comm());
  const auto remark = [&](const std::string& mine) {
    const std::string text = firstText(mine, layout.comm());
    auto& known = findings.remarks;
    // Pieces of one interface say the same but for the place.
    const std::string what = text.substr(0, text.find(", worst"));
    const auto isKnown = [&](const std::string& other) { return other.rfind(what, 0) == 0; };
    if (!text.empty() && std::none_of(known.begin(), known.end(), isKnown)) known.push_back(text);
  };
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const auto mine = std::find_if(watches.begin(), watches.end(),
                                   [&](const auto& each) { return each.first == static_cast<int>(i); });
    const bool isHere = mine != watches.end();
    remark(isHere ? mine->second.falls(accuracy) : "");
    if (assembly.interfaces[i].law->dissipates()) remark(isHere ? mine->second.energies() : "");
  }
  findings.lackOfDigits = lackOfDigits(fixedPoint, accuracy);
  return findings;
}

}  // namespace harmos::latin
