#include <harmos/latin/PointwiseLocalStage.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

#include <harmos/base/AllRanks.hpp>
#include <harmos/base/Error.hpp>

namespace harmos::latin {

PointwiseLocalStage::PointwiseLocalStage(const assembly::Assembly& assembly,
                                         const assembly::SearchDirection& searchDirection, const TraceLayout& layout,
                                         Formulation formulation)
    : assembly_(assembly),
      comm_(layout.comm()),
      lines_(assembly, searchDirection, layout),
      faces_(assembly, layout),
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
  base::onEachRank(comm_, [&] {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (!lines_.isActive(static_cast<int>(i)) || faces_.law(static_cast<int>(i)) != nullptr) continue;
      for (int t = 0; t < beta.numCols(); ++t) {
        solveJoint(static_cast<int>(i), t, beta, traction[t]);
        joints_[i].history[0].swap(joints_[i].history[1]);
      }
    }
  });
  if (faces_.isEmpty()) return;
  // In the velocity form a line begins where the load step before has ended.
  const bool areAllKnown = formulation_ == Formulation::displacement;
  if (areAllKnown) sumFaces(0, beta.numCols(), beta);
  for (int t = 0; t < beta.numCols(); ++t) {
    if (!areAllKnown) sumFaces(t, 1, beta);
    solveFaces(t, areAllKnown ? t : 0, beta, traction[t]);
    for (const int i : faces_.interfaces()) joints_[i].history[0].swap(joints_[i].history[1]);
  }
}

void PointwiseLocalStage::begin() {
  for (Joint& joint : joints_) {
    joint.history[0] = joint.start;
    std::fill(joint.jump.begin(), joint.jump.end(), 0.0);
  }
}

void PointwiseLocalStage::solveColumn(int column, const base::Matrix& beta, double* traction) {
  lines_.exchange(beta, column, 1);
  base::onEachRank(comm_, [&] {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (!lines_.isActive(static_cast<int>(i)) || faces_.law(static_cast<int>(i)) != nullptr) continue;
      solveJoint(static_cast<int>(i), column, beta, traction);
    }
  });
  if (faces_.isEmpty()) return;
  sumFaces(column, 1, beta);
  solveFaces(column, 0, beta, traction);
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
  base::onEachRank(comm_, [&] {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const int index = static_cast<int>(i);
      if (!lines_.isActive(index)) continue;
      const Met here = met(index, column);
      tangents.differentiate(index, here.step, here.lines, here.states, here.oldHistory);
    }
  });
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

void PointwiseLocalStage::fillLines(int interfaceIndex, int column, const base::Matrix& beta) {
  Joint& joint = joints_[interfaceIndex];
  lines_.fill(interfaceIndex, column, beta, joint.line);
  if (formulation_ == Formulation::velocity) beginAtLastJump(joint);
  addReference(assembly_.interfaces[interfaceIndex], joint, steps_[column]);
}

laws::NodeArrays PointwiseLocalStage::arrays(int interfaceIndex, int column) {
  Joint& joint = joints_[interfaceIndex];
  laws::NodeArrays nodes = assembly_.interfaces[interfaceIndex].nodes(assembly_.times, steps_[column]);
  nodes.line = joint.line.data();
  nodes.oldHistory = joint.history[0].data();
  nodes.newHistory = joint.history[1].data();
  nodes.state = joint.state.data() + static_cast<std::size_t>(column) * joint.line.size();
  return nodes;
}

void PointwiseLocalStage::finishJoint(int interfaceIndex, int column, double* traction) {
  const assembly::Interface& interface = assembly_.interfaces[interfaceIndex];
  Joint& joint = joints_[interfaceIndex];
  const laws::LocalState* state = joint.state.data() + static_cast<std::size_t>(column) * joint.line.size();
  const double check = lines_.write(interfaceIndex, state, traction);
  if (formulation_ == Formulation::velocity) keepJump(joint, state);
  if (!std::isfinite(check)) {
    const auto isBad = [](const laws::LocalState& each) { return !std::isfinite(base::norm(each.traction)); };
    const auto point = std::find_if(state, state + joint.line.size(), isBad) - state;
    throw base::Error("interface \"" + interface.name + "\", load step " + std::to_string(steps_[column] + 1) +
                          ": law \"" + interface.law->name() +
                          "\" met or returned a value that is not finite (NaN or infinity), at point " +
                          std::to_string(point + 1),
                      base::ExitCode::notConverged);
  }
}

void PointwiseLocalStage::solveJoint(int interfaceIndex, int column, const base::Matrix& beta, double* traction) {
  fillLines(interfaceIndex, column, beta);
  assembly_.interfaces[interfaceIndex].solve(steps_[column], arrays(interfaceIndex, column));
  finishJoint(interfaceIndex, column, traction);
}

void PointwiseLocalStage::sumFaces(int first, int count, const base::Matrix& beta) {
  faces_.begin(count);
  base::onEachRank(comm_, [&] {
    for (const int i : faces_.interfaces()) {
      if (!lines_.isActive(i)) continue;
      for (int t = 0; t < count; ++t) {
        fillLines(i, first + t, beta);
        faces_.add(i, t, steps_[first + t], arrays(i, first + t));
      }
    }
  });
  faces_.finish();
}

void PointwiseLocalStage::solveFaces(int column, int place, const base::Matrix& beta, double* traction) {
  base::onEachRank(comm_, [&] {
    for (const int i : faces_.interfaces()) {
      if (!lines_.isActive(i)) continue;
      fillLines(i, column, beta);
      faces_.law(i)->solvePoints(steps_[column], arrays(i, column), faces_.of(i, place));
      finishJoint(i, column, traction);
    }
  });
}

}  // namespace harmos::latin
