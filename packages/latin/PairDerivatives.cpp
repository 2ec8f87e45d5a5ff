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
    : assembly_(assembly),
      lines_(lines),
      faces_(assembly, lines.layout()),
      parameters_(std::move(parameters)),
      joints_(assembly.interfaces.size()) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (!lines_.isActive(static_cast<int>(i))) continue;
    const assembly::Interface& interface = assembly.interfaces[i];
    const auto numbers =
        static_cast<std::size_t>(interface.pairs()) * static_cast<std::size_t>(interface.law->historySize());
    joints_[i].before.assign(parameters_.size(), std::vector<double>(numbers, 0.0));
    joints_[i].after = joints_[i].before;
    joints_[i].states.resize(parameters_.size());
  }
}

void PairDerivatives::meet(int column, const PointwiseLocalStage& local) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (!lines_.isActive(static_cast<int>(i))) continue;
    const PointwiseLocalStage::Met met = local.met(static_cast<int>(i), column);
    joints_[i].step = met.step;
    joints_[i].lines = met.lines;
    joints_[i].history = met.oldHistory;
    if (faces_.law(static_cast<int>(i)) == nullptr) demandSame(static_cast<int>(i), met);
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

laws::NodeArrays PairDerivatives::shift(int interfaceIndex, int parameter, double offset,
                                        const std::vector<laws::LocalLine>& change) {
  const Joint& joint = joints_[interfaceIndex];
  shifted_.resize(change.size());
  moved_.resize(change.size());
  oldHistory_.resize(joint.history.size());
  newHistory_.resize(joint.history.size());
  for (std::size_t p = 0; p < change.size(); ++p) {
    shifted_[p] = joint.lines[p];
    shifted_[p].freeJump = shifted_[p].freeJump + offset * change[p].freeJump;
  }
  for (std::size_t n = 0; n < oldHistory_.size(); ++n) {
    oldHistory_[n] = joint.history[n] + offset * joint.before[parameter][n];
  }
  laws::NodeArrays nodes = assembly_.interfaces[interfaceIndex].nodes(assembly_.times, joint.step);
  nodes.line = shifted_.data();
  nodes.oldHistory = oldHistory_.data();
  nodes.newHistory = newHistory_.data();
  nodes.state = moved_.data();
  return nodes;
}

void PairDerivatives::add(int interfaceIndex, int parameter, std::size_t value, base::Matrix& traction) {
  Joint& joint = joints_[interfaceIndex];
  const std::vector<Laws::At>& all = parameters_[parameter].at;
  const double weight = all[value].point.weight;
  std::vector<laws::LocalState>& states = joint.states[parameter];
  if (value == 0) {
    states.assign(moved_.size(), {});
    joint.after[parameter].assign(newHistory_.size(), 0.0);
  }
  for (std::size_t p = 0; p < moved_.size(); ++p) {
    states[p].traction = states[p].traction + weight * moved_[p].traction;
  }
  for (std::size_t n = 0; n < newHistory_.size(); ++n) joint.after[parameter][n] += weight * newHistory_[n];
  if (value + 1 == all.size()) lines_.write(interfaceIndex, states.data(), traction[parameter]);
}

void PairDerivatives::apply(const base::Matrix& dbeta, base::Matrix& traction) {
  const int columns = dbeta.numCols();
  lines_.reserve(columns);
  lines_.exchange(dbeta, 0, columns);
  std::vector<laws::LocalLine> change;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const int index = static_cast<int>(i);
    if (!lines_.isActive(index) || faces_.law(index) != nullptr) continue;
    for (int j = 0; j < columns; ++j) {
      lines_.fill(index, j, dbeta, change);
      const std::vector<Laws::At>& all = parameters_[j].at;
      for (std::size_t v = 0; v < all.size(); ++v) {
        all[v].laws[i]->solve(joints_[i].step, shift(index, j, all[v].point.offset, change));
        add(index, j, v, traction);
      }
    }
  }
  if (!faces_.isEmpty()) applyFaces(dbeta, traction);
}

void PairDerivatives::applyFaces(const base::Matrix& dbeta, base::Matrix& traction) {
  std::size_t values = 0;
  for (const Laws& one : parameters_) values = std::max(values, one.at.size());
  const auto forEach = [&](std::size_t value, const auto& use) {
    std::vector<laws::LocalLine> change;
    for (const int i : faces_.interfaces()) {
      if (!lines_.isActive(i)) continue;
      for (int j = 0; j < dbeta.numCols(); ++j) {
        if (value >= parameters_[j].at.size()) continue;
        const Laws::At& at = parameters_[j].at[value];
        lines_.fill(i, j, dbeta, change);
        const laws::NodeArrays nodes = shift(i, j, at.point.offset, change);
        use(i, j, nodes, dynamic_cast<const laws::CoupledLaw&>(*at.laws[i]));
      }
    }
  };
  FaceSums sums(faces_);
  for (std::size_t value = 0; value < values; ++value) {
    sums.begin(dbeta.numCols());
    forEach(value, [&](int i, int j, const laws::NodeArrays& nodes, const laws::CoupledLaw& moved) {
      sums.add(i, j, joints_[i].step, nodes, moved);
    });
    sums.finish();
    forEach(value, [&](int i, int j, const laws::NodeArrays& nodes, const laws::CoupledLaw& moved) {
      moved.solvePoints(joints_[i].step, nodes, sums.of(i, j));
      add(i, j, value, traction);
    });
  }
}

void PairDerivatives::accept() {
  for (Joint& joint : joints_) joint.before = joint.after;
}

}  // namespace harmos::latin
