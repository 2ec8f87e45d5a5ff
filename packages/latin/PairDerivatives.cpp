#include <harmos/latin/detail/PairDerivatives.hpp>

#include <algorithm>
#include <utility>

#include <harmos/base/Error.hpp>

namespace harmos::latin {
namespace {

// Of the largest traction of an interface: the same calls with the same numbers leave round-off at most.
constexpr double same = 1e-9;

}  // namespace

PairDerivatives::PairDerivatives(const assembly::Assembly& assembly, InterfaceLines& lines,
                                 std::vector<Laws> parameters)
    : assembly_(assembly), lines_(lines), parameters_(std::move(parameters)), joints_(assembly.interfaces.size()) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (!lines_.isActive(static_cast<int>(i))) continue;
    const assembly::Interface& interface = assembly.interfaces[i];
    const auto numbers =
        static_cast<std::size_t>(interface.pairs()) * static_cast<std::size_t>(interface.law->historySize());
    joints_[i].before.assign(parameters_.size(), std::vector<double>(numbers, 0.0));
    joints_[i].after = joints_[i].before;
  }
}

void PairDerivatives::meet(int column, const PointwiseLocalStage& local) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (!lines_.isActive(static_cast<int>(i))) continue;
    const PointwiseLocalStage::Met met = local.met(static_cast<int>(i), column);
    joints_[i].step = met.step;
    joints_[i].lines = met.lines;
    joints_[i].history = met.oldHistory;
    demandSame(static_cast<int>(i), met);
  }
}

void PairDerivatives::demandSame(int interfaceIndex, const PointwiseLocalStage::Met& met) {
  const assembly::Interface& interface = assembly_.interfaces[interfaceIndex];
  moved_.resize(met.lines.size());
  newHistory_.resize(met.oldHistory.size());
  laws::NodeArrays nodes = interface.nodes(assembly_.times, met.step);
  nodes.line = met.lines.data();
  nodes.oldHistory = met.oldHistory.data();
  nodes.newHistory = newHistory_.data();
  nodes.state = moved_.data();
  interface.solve(met.step, nodes);
  double difference = 0.0, size = 0.0;
  for (std::size_t p = 0; p < moved_.size(); ++p) {
    difference = std::max(difference, base::distance(moved_[p].traction, met.states[p].traction));
    size = std::max(size, base::norm(met.states[p].traction));
  }
  if (difference <= same * size) return;
  throw base::Error("interface \"" + interface.name + "\": derivatives are not known of the law \"" +
                    interface.law->name() + "\", which asks for more than the pairs of this interface.");
}

void PairDerivatives::solve(int interfaceIndex, int parameter, double sign,
                            const std::vector<laws::LocalLine>& change) {
  const Joint& joint = joints_[interfaceIndex];
  const Laws& laws = parameters_[parameter];
  const double length = sign * laws.step;
  for (std::size_t p = 0; p < change.size(); ++p) {
    shifted_[p] = joint.lines[p];
    shifted_[p].freeJump = shifted_[p].freeJump + length * change[p].freeJump;
  }
  for (std::size_t n = 0; n < oldHistory_.size(); ++n) {
    oldHistory_[n] = joint.history[n] + length * joint.before[parameter][n];
  }
  laws::NodeArrays nodes = assembly_.interfaces[interfaceIndex].nodes(assembly_.times, joint.step);
  nodes.line = shifted_.data();
  nodes.oldHistory = oldHistory_.data();
  nodes.newHistory = newHistory_.data();
  nodes.state = moved_.data();
  (sign > 0.0 ? laws.more : laws.less)[interfaceIndex]->solve(joint.step, nodes);
}

void PairDerivatives::differentiate(int interfaceIndex, int parameter, const std::vector<laws::LocalLine>& change) {
  Joint& joint = joints_[interfaceIndex];
  shifted_.resize(change.size());
  moved_.resize(change.size());
  states_.resize(change.size());
  oldHistory_.resize(joint.history.size());
  newHistory_.resize(joint.history.size());
  std::vector<double>& history = joint.after[parameter];
  const double factor = 0.5 / parameters_[parameter].step;
  solve(interfaceIndex, parameter, 1.0, change);
  for (std::size_t p = 0; p < change.size(); ++p) states_[p].traction = moved_[p].traction;
  history = newHistory_;
  solve(interfaceIndex, parameter, -1.0, change);
  for (std::size_t p = 0; p < change.size(); ++p) {
    states_[p].traction = factor * (states_[p].traction - moved_[p].traction);
  }
  for (std::size_t n = 0; n < history.size(); ++n) history[n] = factor * (history[n] - newHistory_[n]);
}

void PairDerivatives::apply(const base::Matrix& dbeta, base::Matrix& traction) {
  lines_.reserve(dbeta.numCols());
  lines_.exchange(dbeta, 0, dbeta.numCols());
  std::vector<laws::LocalLine> change;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const int index = static_cast<int>(i);
    if (!lines_.isActive(index)) continue;
    for (int j = 0; j < dbeta.numCols(); ++j) {
      lines_.fill(index, j, dbeta, change);
      differentiate(index, j, change);
      lines_.write(index, j, states_.data(), traction);
    }
  }
}

void PairDerivatives::accept() {
  for (Joint& joint : joints_) joint.before = joint.after;
}

}  // namespace harmos::latin
