#include <harmos/latin/detail/AdmittedTractions.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <harmos/laws/AffineComponent.hpp>

namespace harmos::latin {
namespace {

// The pressure that closes a pair and makes it stick, over the tractions around it: far more than these, and little
// enough that openings keep their digits beside it.
constexpr double pressing = 1e3;

/// t_n <= 0 of any size, and friction.
bool isContact(const laws::AdmissibleTractions& admissible) {
  using base::Vector3;
  return admissible.lower == Vector3{-laws::AdmissibleTractions::unlimited, 0.0, 0.0} &&
         admissible.upper == Vector3{0.0, 0.0, 0.0};
}

}  // namespace

std::vector<base::Vector3> rigidAxes(const assembly::Interface& interface, int pair, int dimension, int step,
                                     double compliance) {
  const auto components = laws::affineComponents(*interface.law, step, compliance);
  std::vector<base::Vector3> axes;
  for (int c = 0; c < dimension; ++c) {
    if (!std::isinf(components[c].stiffness)) continue;
    base::Vector3 axis{};
    axis[c] = 1.0;
    axes.push_back(interface.law->frame() == laws::Frame::interface ? interface.frame[pair][c] : axis);
  }
  return axes;
}

AdmittedTractions::AdmittedTractions(const assembly::Assembly& assembly, int interfaceIndex, std::vector<int> pairs,
                                     std::vector<double> compliances)
    : assembly_(assembly),
      interface_(assembly.interfaces[interfaceIndex]),
      pairs_(std::move(pairs)),
      compliances_(std::move(compliances)),
      history_(pairs_.size() * static_cast<std::size_t>(interface_.law->historySize()), 0.0) {
  for (const int p : pairs_) {
    gaps_.push_back(interface_.gap[p]);
    areas_.push_back(interface_.area[p]);
    positions_.push_back(interface_.position[p]);
    frames_.push_back(interface_.frame[p]);
  }
}

base::Vector3 AdmittedTractions::toLaw(std::size_t i, const base::Vector3& v) const {
  return interface_.law->frame() == laws::Frame::interface ? base::toFrame(interface_.frame[pairs_[i]], v) : v;
}

std::vector<laws::LocalState> AdmittedTractions::ask(int step, const std::vector<laws::LocalLine>& lines,
                                                     std::vector<double>& history) {
  std::vector<laws::LocalState> states(lines.size());
  history.resize(history_.size());
  laws::NodeArrays nodes = interface_.nodes(assembly_.times, step);
  nodes.count = static_cast<int>(lines.size());
  nodes.line = lines.data();
  nodes.gap = gaps_.data();
  nodes.oldHistory = history_.data();
  nodes.newHistory = history.data();
  nodes.state = states.data();
  nodes.position = positions_.data();
  nodes.frame = frames_.data();
  nodes.area = areas_.data();
  nodes.number = pairs_.data();
  interface_.solve(step, nodes);
  return states;
}

std::vector<AdmittedTractions::Set> AdmittedTractions::next(int step, const std::vector<At>& states, double tolerance) {
  const laws::InterfaceLaw& law = *interface_.law;
  std::vector<Set> sets;
  if (law.isAffine()) {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const auto axes = rigidAxes(interface_, pairs_[i], assembly_.dimension, step, compliances_[0]);
      sets.push_back({TractionSet::span(states[i].traction, axes)});
    }
    return sets;
  }
  const auto admissible = law.admissibleTractions(step);
  if (!admissible || !isContact(*admissible) || law.frame() != laws::Frame::interface) {
    for (const At& at : states) sets.push_back({TractionSet::point(at.traction)});
    return sets;
  }
  std::vector<laws::LocalLine> through, pressed;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const base::Vector3 jump = toLaw(i, states[i].jump);
    const double h = compliances_[i];
    through.push_back({jump + h * toLaw(i, states[i].traction), h});
    pressed.push_back({jump - base::Vector3{h * pressing * states[i].size, 0.0, 0.0}, h});
  }
  std::vector<double> history;
  const std::vector<laws::LocalState> answers = ask(step, pressed, history);
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const At& at = states[i];
    const base::Vector3& answer = answers[i].traction;
    const double none = std::max(at.uncertainty, tolerance * compliances_[i] * at.size);
    const double opening = compliances_[i] * (answer[0] + pressing * at.size);
    const double shear = base::tangentialNorm(answer), slip = compliances_[i] * shear;
    const base::Frame& frame = interface_.frame[pairs_[i]];
    if (at.size == 0.0 || opening > none) {
      sets.push_back({TractionSet::point(at.traction)});
    } else if (admissible->friction > 0.0 && slip > none) {
      const double scale = admissible->friction / shear;
      sets.push_back({TractionSet::ray(base::toGlobal(frame, {-1.0, scale * answer[1], scale * answer[2]})), true});
    } else {
      const bool slides = admissible->friction > 0.0 && slip > at.uncertainty;
      sets.push_back({TractionSet::cone(frame, admissible->friction, assembly_.dimension), slides});
    }
  }
  if (!history_.empty()) {
    ask(step, through, history);
    history_.swap(history);
  }
  return sets;
}

}  // namespace harmos::latin
