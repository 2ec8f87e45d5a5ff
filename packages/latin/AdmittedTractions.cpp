#include <harmos/latin/detail/AdmittedTractions.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <harmos/latin/detail/TractionProbe.hpp>
#include <harmos/laws/AffineComponent.hpp>
#include <harmos/laws/CoupledLaw.hpp>

namespace harmos::latin {
namespace {

// The pressure that closes a pair and makes it stick, over the tractions around it: far more than these, and little
// enough that openings keep their digits beside it.
constexpr double pressing = 1e3;

/// t_n <= 0 of any size, and friction that is the same in all directions.
bool isContact(const laws::AdmissibleTractions& admissible) {
  using base::Vector3;
  return admissible.isCone && admissible.lower == Vector3{-laws::AdmissibleTractions::unlimited, 0.0, 0.0} &&
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
    : dimension_(assembly.dimension),
      interface_(assembly.interfaces[interfaceIndex]),
      replay_(assembly, interfaceIndex, std::move(pairs)),
      compliances_(std::move(compliances)) {}

std::vector<AdmittedTractions::Set> AdmittedTractions::next(int step, const std::vector<At>& states, double tolerance) {
  const laws::InterfaceLaw& law = *interface_.law;
  std::vector<Set> sets;
  if (law.isAffine()) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      const auto axes = rigidAxes(interface_, replay_.pairs()[i], dimension_, step, compliances_[0]);
      sets.push_back({TractionSet::span(states[i].traction, axes)});
    }
    return sets;
  }
  const bool canBeAsked = law.frame() == laws::Frame::interface && !law.prescribesTraction() &&
                          dynamic_cast<const laws::CoupledLaw*>(&law) == nullptr;
  if (!canBeAsked) {
    for (const At& at : states) sets.push_back({TractionSet::point(at.traction)});
    return sets;
  }
  std::vector<laws::LocalLine> through, pressed;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const base::Vector3 jump = replay_.toLaw(i, states[i].jump);
    const double h = compliances_[i];
    through.push_back({jump + h * replay_.toLaw(i, states[i].traction), h});
    pressed.push_back({jump - base::Vector3{h * pressing * states[i].size, 0.0, 0.0}, h});
  }
  const std::vector<laws::LocalState> answers = replay_.ask(step, pressed);
  const auto admissible = law.admissibleTractions(step);
  sets = admissible && isContact(*admissible) ? ofContact(states, admissible->friction, answers, tolerance)
                                              : ofOthers(step, states, pressed, answers, tolerance);
  replay_.advance(step, through);
  return sets;
}

double AdmittedTractions::none(std::size_t i, const At& at, double tolerance) const {
  return std::max(at.uncertainty, tolerance * compliances_[i] * at.size);
}

double AdmittedTractions::opening(std::size_t i, const At& at, const laws::LocalState& answer) const {
  return compliances_[i] * (answer.traction[0] + pressing * at.size);
}

std::vector<AdmittedTractions::Set> AdmittedTractions::ofContact(const std::vector<At>& states, double friction,
                                                                 const std::vector<laws::LocalState>& answers,
                                                                 double tolerance) const {
  std::vector<Set> sets;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const At& at = states[i];
    const base::Vector3& answer = answers[i].traction;
    const double shear = base::tangentialNorm(answer), slip = compliances_[i] * shear;
    const base::Frame& frame = interface_.frame[replay_.pairs()[i]];
    if (at.size == 0.0 || opening(i, at, answers[i]) > none(i, at, tolerance)) {
      sets.push_back({TractionSet::point(at.traction)});
    } else if (friction > 0.0 && slip > none(i, at, tolerance)) {
      const double scale = friction / shear;
      sets.push_back({TractionSet::ray(base::toGlobal(frame, {-1.0, scale * answer[1], scale * answer[2]})), true});
    } else {
      const bool slides = friction > 0.0 && slip > at.uncertainty;
      sets.push_back({TractionSet::cone(frame, friction, dimension_), slides});
    }
  }
  return sets;
}

std::vector<AdmittedTractions::Set> AdmittedTractions::ofOthers(int step, const std::vector<At>& states,
                                                                const std::vector<laws::LocalLine>& pressed,
                                                                const std::vector<laws::LocalState>& answers,
                                                                double tolerance) const {
  std::vector<TractionProbe::Pair> pairs(states.size());
  std::vector<bool> slides(states.size(), false);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const At& at = states[i];
    TractionProbe::Pair& pair = pairs[i];
    pair.traction = replay_.toLaw(i, at.traction);
    pair.compliance = compliances_[i];
    pair.jump = pressed[i].jump(answers[i].traction);
    if (at.size == 0.0 || std::abs(opening(i, at, answers[i])) > none(i, at, tolerance)) continue;
    pair.size = at.size;
    const double slip = compliances_[i] * base::tangentialNorm(answers[i].traction);
    slides[i] = slip > at.uncertainty;
    pair.slides = slip > none(i, at, tolerance);
    if (!pair.slides) continue;
    const base::Vector3 jump = replay_.toLaw(i, at.jump);
    pair.jump = {pair.jump[0], jump[1], jump[2]};
  }
  const std::vector<std::optional<TractionSet>> found =
      TractionProbe(replay_, interface_, dimension_).find(step, pairs);
  std::vector<Set> sets;
  for (std::size_t i = 0; i < states.size(); ++i) {
    sets.push_back(found[i] ? Set{*found[i], slides[i]} : Set{TractionSet::point(states[i].traction)});
  }
  return sets;
}

}  // namespace harmos::latin
