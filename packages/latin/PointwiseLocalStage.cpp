#include <harmos/latin/PointwiseLocalStage.hpp>

#include <cassert>
#include <cmath>

#include <harmos/base/Error.hpp>

namespace harmos::latin {

PointwiseLocalStage::PointwiseLocalStage(const assembly::Assembly& assembly,
                                         const assembly::SearchDirection& searchDirection, const TraceLayout& layout,
                                         Formulation formulation)
    : assembly_(assembly),
      lines_(assembly, searchDirection, layout),
      formulation_(formulation),
      joints_(assembly.interfaces.size()) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (!lines_.isActive(static_cast<int>(i))) continue;
    const assembly::Interface& interface = assembly.interfaces[i];
    const auto pairs = static_cast<std::size_t>(interface.pairs());
    Joint& joint = joints_[i];
    joint.line.resize(pairs);
    for (auto& history : joint.history) history.resize(pairs * static_cast<std::size_t>(interface.law->historySize()));
    joint.start.resize(joint.history[0].size());
    if (formulation == Formulation::velocity) joint.jump.resize(3 * pairs);
  }
}

void PointwiseLocalStage::select(const std::vector<int>& steps) {
  steps_ = steps;
  lines_.reserve(static_cast<int>(steps.size()));
  for (Joint& joint : joints_) joint.state.assign(joint.line.size() * steps.size(), {});
}

void PointwiseLocalStage::startFromHere() {
  assert(formulation_ == Formulation::displacement && "the velocity form keeps no jump to start from");
  for (Joint& joint : joints_) joint.start = joint.history[0];
}

void PointwiseLocalStage::startUnloaded() {
  for (Joint& joint : joints_) std::fill(joint.start.begin(), joint.start.end(), 0.0);
}

void PointwiseLocalStage::solve(const base::Matrix& beta, base::Matrix& traction) {
  lines_.exchange(beta, 0, beta.numCols());
  begin();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (!lines_.isActive(static_cast<int>(i))) continue;
    for (int t = 0; t < beta.numCols(); ++t) {
      solveJoint(static_cast<int>(i), joints_[i], t, beta, traction);
      joints_[i].history[0].swap(joints_[i].history[1]);
    }
  }
}

void PointwiseLocalStage::begin() {
  for (Joint& joint : joints_) {
    joint.history[0] = joint.start;
    std::fill(joint.jump.begin(), joint.jump.end(), 0.0);
  }
}

void PointwiseLocalStage::solveColumn(int column, const base::Matrix& beta, base::Matrix& traction) {
  lines_.exchange(beta, column, 1);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (lines_.isActive(static_cast<int>(i))) solveJoint(static_cast<int>(i), joints_[i], column, beta, traction);
  }
}

void PointwiseLocalStage::accept() {
  for (Joint& joint : joints_) joint.history[0].swap(joint.history[1]);
}

PointwiseLocalStage::Met PointwiseLocalStage::met(int interfaceIndex, int column) const {
  const Joint& joint = joints_[interfaceIndex];
  return {steps_[column], joint.line, joint.state.data() + static_cast<std::size_t>(column) * joint.line.size(),
          joint.history[0]};
}

void PointwiseLocalStage::differentiateColumn(int column, PairTangents& tangents) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const int index = static_cast<int>(i);
    if (!lines_.isActive(index)) continue;
    const Met here = met(index, column);
    tangents.differentiate(index, here.step, here.lines, here.states, here.oldHistory);
  }
}

void PointwiseLocalStage::beginAtLastJump(Joint& joint) {
  for (std::size_t i = 0; i < joint.jump.size(); ++i) joint.line[i / 3].freeJump[i % 3] += joint.jump[i];
}

void PointwiseLocalStage::keepJump(Joint& joint, const laws::LocalState* state) {
  for (std::size_t i = 0; i < joint.jump.size(); ++i) {
    joint.jump[i] = joint.line[i / 3].jump(state[i / 3].traction)[i % 3];
  }
}

void PointwiseLocalStage::addReference(const assembly::Interface& interface, Joint& joint, int step) const {
  if (reference_ == nullptr || reference_->isEmpty()) return;
  const bool local = interface.law->frame() == laws::Frame::interface;
  for (std::size_t p = 0; p < joint.line.size(); ++p) {
    const base::Vector3 jump = reference_->jump(interface, static_cast<int>(p), step);
    laws::LocalLine& line = joint.line[p];
    line.freeJump = line.freeJump + (local ? base::toFrame(interface.frame[p], jump) : jump);
  }
}

void PointwiseLocalStage::solveJoint(int interfaceIndex, Joint& joint, int t, const base::Matrix& beta,
                                     base::Matrix& traction) {
  const assembly::Interface& interface = assembly_.interfaces[interfaceIndex];
  lines_.fill(interfaceIndex, t, beta, joint.line);
  if (formulation_ == Formulation::velocity) beginAtLastJump(joint);
  laws::LocalState* state = joint.state.data() + static_cast<std::size_t>(t) * joint.line.size();
  const int step = steps_[t];
  addReference(interface, joint, step);
  laws::NodeArrays nodes = interface.nodes(assembly_.times, step);
  nodes.line = joint.line.data();
  nodes.oldHistory = joint.history[0].data();
  nodes.newHistory = joint.history[1].data();
  nodes.state = state;
  interface.law->solve(step, nodes);
  const double check = lines_.write(interfaceIndex, t, state, traction);
  if (formulation_ == Formulation::velocity) keepJump(joint, state);
  if (!std::isfinite(check)) {
    throw base::Error("interface \"" + interface.name + "\", load step " + std::to_string(step + 1) + ": law \"" +
                          interface.law->name() + "\" met or returned a value that is not finite (NaN or infinity)",
                      base::ExitCode::notConverged);
  }
}

}  // namespace harmos::latin
