#include <harmos/latin/LocalStage.hpp>

#include <cmath>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::latin {
namespace {

using laws::Vector3;

Vector3 toFrame(const mesh::Frame& frame, const Vector3& v) {
  return {frame[0][0] * v[0] + frame[0][1] * v[1] + frame[0][2] * v[2],
          frame[1][0] * v[0] + frame[1][1] * v[1] + frame[1][2] * v[2],
          frame[2][0] * v[0] + frame[2][1] * v[1] + frame[2][2] * v[2]};
}

Vector3 toGlobal(const mesh::Frame& frame, const Vector3& v) {
  return {frame[0][0] * v[0] + frame[1][0] * v[1] + frame[2][0] * v[2],
          frame[0][1] * v[0] + frame[1][1] * v[1] + frame[2][1] * v[2],
          frame[0][2] * v[0] + frame[1][2] * v[1] + frame[2][2] * v[2]};
}

}  // namespace

LocalStage::LocalStage(const interface::Assembly& assembly, const interface::SearchDirection& searchDirection,
                       const TraceLayout& layout, Formulation formulation)
    : assembly_(assembly), searchDirection_(searchDirection), layout_(layout), formulation_(formulation) {
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const interface::Interface& interface = assembly.interfaces[i];
    Joint joint;
    joint.begin1 = layout.begin(static_cast<int>(i), 0);
    joint.begin2 = layout.begin(static_cast<int>(i), 1);
    joint.active = joint.begin1 >= 0 || joint.begin2 >= 0;
    if (joint.active) {
      const auto pairs = static_cast<std::size_t>(interface.pairs());
      joint.line.resize(pairs);
      for (auto& history : joint.history)
        history.resize(pairs * static_cast<std::size_t>(interface.law->historySize()));
      joint.start.resize(joint.history[0].size());
      if (formulation == Formulation::velocity) joint.jump.resize(3 * pairs);
      if (interface.sides() == 2 && (joint.begin1 < 0 || joint.begin2 < 0)) {
        joint.neighbour = assembly.ownerOf(joint.begin1 < 0 ? interface.body1 : interface.body2);
      }
    }
    joints_.push_back(std::move(joint));
  }
}

void LocalStage::select(const std::vector<int>& steps) {
  steps_ = steps;
  for (Joint& joint : joints_) {
    if (!joint.active) continue;
    joint.state.assign(joint.line.size() * steps.size(), {});
    if (joint.neighbour >= 0) {
      joint.remote.resize(joint.line.size() * steps.size() * static_cast<std::size_t>(layout_.dimension()));
    }
  }
}

void LocalStage::startFromHere() {
  for (Joint& joint : joints_) joint.start = joint.history[0];
}

void LocalStage::startUnloaded() {
  for (Joint& joint : joints_) std::fill(joint.start.begin(), joint.start.end(), 0.0);
}

void LocalStage::exchange(const base::Matrix& beta, int first, int count) {
  // Every rank visits the interfaces in the same order, so the messages between two ranks match without tags.
  std::vector<std::vector<double>> sent;
  Teuchos::Array<Teuchos::RCP<Teuchos::CommRequest<int>>> requests;
  for (Joint& joint : joints_) {
    if (joint.neighbour < 0) continue;
    const int begin = joint.begin1 >= 0 ? joint.begin1 : joint.begin2;
    const int rows = static_cast<int>(joint.line.size()) * layout_.dimension();
    std::vector<double> buffer(static_cast<std::size_t>(rows) * static_cast<std::size_t>(count));
    for (int t = 0; t < count; ++t) std::copy_n(beta[first + t] + begin, rows, buffer.begin() + t * rows);
    sent.push_back(std::move(buffer));
    const auto received = Teuchos::arrayViewFromVector(joint.remote).view(first * rows, count * rows);
    requests.push_back(
        Teuchos::ireceive<int, double>(layout_.comm(), Teuchos::arcpFromArrayView(received), joint.neighbour));
    requests.push_back(Teuchos::isend<int, double>(
        layout_.comm(), Teuchos::arcpFromArrayView(Teuchos::arrayViewFromVector(sent.back())), joint.neighbour));
  }
  Teuchos::waitAll(layout_.comm(), requests());
}

void LocalStage::solve(const base::Matrix& beta, base::Matrix& traction) {
  if (layout_.comm().getSize() > 1) exchange(beta, 0, beta.numCols());
  begin();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (!joints_[i].active) continue;
    for (int t = 0; t < beta.numCols(); ++t) {
      solveJoint(static_cast<int>(i), joints_[i], t, beta, traction);
      joints_[i].history[0].swap(joints_[i].history[1]);
    }
  }
}

void LocalStage::begin() {
  for (Joint& joint : joints_) {
    joint.history[0] = joint.start;
    std::fill(joint.jump.begin(), joint.jump.end(), 0.0);
  }
}

void LocalStage::solveColumn(int column, const base::Matrix& beta, base::Matrix& traction) {
  if (layout_.comm().getSize() > 1) exchange(beta, column, 1);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].active) solveJoint(static_cast<int>(i), joints_[i], column, beta, traction);
  }
}

void LocalStage::accept() {
  for (Joint& joint : joints_) joint.history[0].swap(joint.history[1]);
}

void LocalStage::solveJoint(int interfaceIndex, Joint& joint, int t, const base::Matrix& beta, base::Matrix& traction) {
  const interface::Interface& interface = assembly_.interfaces[static_cast<std::size_t>(interfaceIndex)];
  const std::vector<double>& k = searchDirection_.of(interfaceIndex);
  const int dimension = layout_.dimension();
  const int pairs = interface.pairs();
  const bool local = interface.law->frame() == laws::Frame::interface;
  const bool incremental = formulation_ == Formulation::velocity;

  const double* remote = joint.remote.data() + static_cast<std::size_t>(t) * pairs * dimension;
  const double* beta1 = joint.begin1 >= 0 ? beta[t] + joint.begin1 : remote;
  const double* beta2 = interface.sides() == 1 ? nullptr : joint.begin2 >= 0 ? beta[t] + joint.begin2 : remote;
  const double sides = interface.sides();
  for (int p = 0; p < pairs; ++p) {
    const double compliance = 1.0 / k[static_cast<std::size_t>(p)];
    Vector3 free{};
    for (int c = 0; c < dimension; ++c) {
      const double b2 = beta2 != nullptr ? beta2[p * dimension + c] : 0.0;
      free[static_cast<std::size_t>(c)] = compliance * (beta1[p * dimension + c] - b2);
    }
    laws::LocalLine& line = joint.line[static_cast<std::size_t>(p)];
    line.compliance = sides * compliance;
    line.freeJump = local ? toFrame(interface.frame[static_cast<std::size_t>(p)], free) : free;
    if (incremental) {
      for (std::size_t c = 0; c < 3; ++c) line.freeJump[c] += joint.jump[3 * static_cast<std::size_t>(p) + c];
    }
  }

  laws::LocalState* state = joint.state.data() + static_cast<std::size_t>(t) * static_cast<std::size_t>(pairs);
  const int step = steps_[static_cast<std::size_t>(t)];
  interface.law->solve(
      step, {pairs, joint.line.data(), interface.gap.data(), joint.history[0].data(), joint.history[1].data(), state});

  double check = 0.0;
  for (int p = 0; p < pairs; ++p) {
    const Vector3& f = state[p].traction;
    check += f[0] + f[1] + f[2];
    const Vector3 global = local ? toGlobal(interface.frame[static_cast<std::size_t>(p)], f) : f;
    for (int c = 0; c < dimension; ++c) {
      if (joint.begin1 >= 0) traction[t][joint.begin1 + p * dimension + c] = global[static_cast<std::size_t>(c)];
      if (joint.begin2 >= 0) traction[t][joint.begin2 + p * dimension + c] = -global[static_cast<std::size_t>(c)];
    }
    if (incremental) {
      const Vector3 jump = joint.line[static_cast<std::size_t>(p)].jump(f);
      std::copy(jump.begin(), jump.end(), joint.jump.begin() + 3 * p);
    }
  }
  if (!std::isfinite(check)) {
    throw base::Error("interface \"" + interface.name + "\", load step " + std::to_string(step + 1) + ": law \"" +
                          interface.law->name() + "\" met or returned a value that is not finite (NaN or infinity)",
                      base::ExitCode::notConverged);
  }
}

}  // namespace harmos::latin
