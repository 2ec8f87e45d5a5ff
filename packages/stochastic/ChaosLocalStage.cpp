#include <harmos/stochastic/ChaosLocalStage.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

#include <harmos/base/AllRanks.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/laws/CoupledLaw.hpp>

namespace harmos::stochastic {

ChaosLocalStage::ChaosLocalStage(const assembly::Assembly& modal, const assembly::SearchDirection& searchDirection,
                                 const latin::TraceLayout& layout, std::shared_ptr<const Projection> projection)
    : modal_(modal),
      searchDirection_(searchDirection),
      projection_(std::move(projection)),
      lines_(modal, searchDirection, layout),
      faces_(modal, layout),
      joints_(modal.interfaces.size()) {
  lines_.reserve(modal.steps());
  count_ = steps();
}

void ChaosLocalStage::setLaws(const Realisations& laws, Method method) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const assembly::Interface& interface = modal_.interfaces[i];
    Joint& joint = joints_[i];
    joint = {};
    if (interface.law->prescribesTraction()) continue;
    for (const auto& point : laws) joint.laws.push_back(point[i]);
    if (method == Method::galerkin) {
      // On every rank, so that all throw or none.
      const double compliance = interface.sides() / searchDirection_.of(static_cast<int>(i))[0];
      joint.springs.emplace(interface, joint.laws, *projection_, steps(), compliance);
      if (!joint.springs->isRandom()) joint.springs.reset();
    }
    if (!lines_.isActive(static_cast<int>(i))) continue;
    const std::size_t size =
        static_cast<std::size_t>(interface.pairs()) * static_cast<std::size_t>(interface.law->historySize());
    const std::vector<double> zero(size, 0.0);
    joint.histories.assign(joint.laws.size(), {zero, zero, zero});
  }
}

void ChaosLocalStage::select(const std::vector<int>& columns) {
  const int terms = projection_->terms();
  first_ = columns.front() / terms;
  count_ = static_cast<int>(columns.size()) / terms;
  assert(columns.front() == first_ * terms && columns.back() == (first_ + count_) * terms - 1 &&
         "the polynomials of a load step are solved together");
}

void ChaosLocalStage::startFromHere() {
  for (Joint& joint : joints_) {
    for (Histories& history : joint.histories) history.start = history.now;
  }
}

void ChaosLocalStage::startUnloaded() {
  for (Joint& joint : joints_) {
    for (Histories& history : joint.histories) std::fill(history.start.begin(), history.start.end(), 0.0);
  }
}

bool ChaosLocalStage::hasMemory() const {
  return std::any_of(joints_.begin(), joints_.end(),
                     [](const Joint& joint) { return !joint.laws.empty() && joint.laws[0]->historySize() > 0; });
}

void ChaosLocalStage::solve(const base::Matrix& beta, base::Matrix& traction) {
  lines_.exchange(beta, 0, beta.numCols());
  sumFaces(beta);
  base::onEachRank(lines_.layout().comm(), [&] {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (!lines_.isActive(static_cast<int>(i))) continue;
      for (Histories& history : joints_[i].histories) history.now = history.start;
      for (int t = 0; t < count_; ++t) solveJoint(static_cast<int>(i), joints_[i], t, beta, traction);
    }
  });
}

void ChaosLocalStage::sumFaces(const base::Matrix& beta) {
  if (faces_.isEmpty()) return;
  const int points = projection_->points();
  faces_.begin(count_ * points);
  base::onEachRank(lines_.layout().comm(), [&] {
    for (const int i : faces_.interfaces()) {
      if (!lines_.isActive(i)) continue;
      for (int t = 0; t < count_; ++t) {
        fillLines(i, t, beta);
        projection_->toPoints(freeJumps_, freeJumpsAtPoints_);
        for (int q = 0; q < points; ++q) {
          const auto& law = dynamic_cast<const laws::CoupledLaw&>(*joints_[i].laws[q]);
          faces_.add(i, t * points + q, first_ + t, arraysAt(i, first_ + t, q), law);
        }
      }
    }
  });
  faces_.finish();
}

void ChaosLocalStage::fillLines(int interfaceIndex, int column, const base::Matrix& beta) {
  const int terms = projection_->terms();
  freeJumps_.shapeUninitialized(3 * modal_.interfaces[interfaceIndex].pairs(), terms);
  for (int a = 0; a < terms; ++a) {
    lines_.fill(interfaceIndex, column * terms + a, beta, line_);
    double* free = freeJumps_[a];
    for (const laws::LocalLine& line : line_) free = std::copy_n(line.freeJump.begin(), 3, free);
  }
  state_.resize(line_.size());
}

laws::NodeArrays ChaosLocalStage::arraysAt(int interfaceIndex, int step, int point) {
  laws::NodeArrays nodes = modal_.interfaces[interfaceIndex].nodes(modal_.times, step * projection_->terms());
  const double* free = freeJumpsAtPoints_[point];
  for (laws::LocalLine& line : line_) {
    std::copy_n(free, 3, line.freeJump.begin());
    free += 3;
  }
  nodes.line = line_.data();
  nodes.state = state_.data();
  return nodes;
}

void ChaosLocalStage::solvePoints(int interfaceIndex, Joint& joint, int column) {
  const int step = first_ + column;
  const bool isCoupled = faces_.law(interfaceIndex) != nullptr;
  for (int q = 0; q < projection_->points(); ++q) {
    Histories& history = joint.histories[q];
    laws::NodeArrays nodes = arraysAt(interfaceIndex, step, q);
    nodes.oldHistory = history.now.data();
    nodes.newHistory = history.next.data();
    if (isCoupled) {
      dynamic_cast<const laws::CoupledLaw&>(*joint.laws[q])
          .solvePoints(step, nodes, faces_.of(interfaceIndex, column * projection_->points() + q));
    } else {
      joint.laws[q]->solve(step, nodes);
    }
    history.now.swap(history.next);
    double* traction = tractionsAtPoints_[q];
    for (const laws::LocalState& state : state_) traction = std::copy_n(state.traction.begin(), 3, traction);
  }
}

void ChaosLocalStage::solveJoint(int interfaceIndex, Joint& joint, int t, const base::Matrix& beta,
                                 base::Matrix& traction) {
  const assembly::Interface& interface = modal_.interfaces[interfaceIndex];
  const int terms = projection_->terms();
  const int step = first_ + t;
  fillLines(interfaceIndex, t, beta);
  if (joint.springs) {
    joint.springs->solve(step, line_, freeJumps_, tractions_);
  } else {
    projection_->toPoints(freeJumps_, freeJumpsAtPoints_);
    tractionsAtPoints_.shapeUninitialized(freeJumps_.numRows(), projection_->points());
    solvePoints(interfaceIndex, joint, t);
    projection_->toCoefficients(tractionsAtPoints_, tractions_);
  }
  double check = 0.0;
  for (int a = 0; a < terms; ++a) {
    const double* from = tractions_[a];
    for (laws::LocalState& state : state_) {
      std::copy_n(from, 3, state.traction.begin());
      from += 3;
    }
    check += lines_.write(interfaceIndex, state_.data(), traction[t * terms + a]);
  }
  if (!std::isfinite(check)) {
    throw base::Error("interface \"" + interface.name + "\", load step " + std::to_string(step + 1) + ": law \"" +
                          interface.law->name() + "\" met or returned a value that is not finite (NaN or infinity)",
                      base::ExitCode::notConverged);
  }
}

}  // namespace harmos::stochastic
