#include "JointSystem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <harmos/base/Error.hpp>

#include "BodyStiffness.hpp"

namespace harmos::benchmarks {
namespace {

constexpr std::array<const char*, 3> axes{"X", "Y", "Z"};

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw base::Error(where + ": " + what + " is not what the rivals solve.", base::ExitCode::input);
}

const input::Parameters* find(const scene::Scene& scene, const char* list, const std::string& name) {
  const auto& entries = scene.input.lists(list);
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& one) { return one.name() == name; });
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace

JointSystem::JointSystem(const Study& study) : study_(study) {
  const assembly::Assembly& assembly = study.problem.assembly;
  int dofs = 0;
  for (const substructure::Substructure& body : assembly.bodies) {
    if (body.dimension != 3 || body.loads.numRows() > 0) refuse(body.name, "a plane part or one with body forces");
    firstDof_.push_back(dofs);
    dofs += 3 * static_cast<int>(body.nodes.size());
  }
  firstDof_.push_back(dofs);
  master_.resize(dofs);
  std::iota(master_.begin(), master_.end(), 0);
  isHeld_.assign(dofs, 0);
  for (const assembly::Interface& interface : assembly.interfaces) {
    if (!interface.trace1.isSelection() || !interface.trace2.isSelection())
      refuse(interface.name, "an interface whose meshes do not match");
    if (const auto* entry = find(study.scene, "Interfaces", interface.name)) {
      join(interface, entry->list("Law"));
    } else if (const auto* boundary = find(study.scene, "Boundaries", interface.name)) {
      bound(interface, boundary->list("Law"));
    } else {
      refuse(interface.name, "a part cut into pieces");
    }
  }
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) stiffness_.push_back(stiffnessOf(assembly.bodies, b));
  number();
  makeMatrix();
  makeForces();
  makeReaders();
}

JointSystem::Case& JointSystem::addCase(const char* list, const std::string& name, const std::string& entry) {
  const auto found = std::find_if(cases_.begin(), cases_.end(),
                                  [&](const Case& one) { return one.name == name && one.entry == entry; });
  if (found != cases_.end()) return *found;
  return cases_.emplace_back(
      Case{list, name, entry, base::Matrix(firstDof_.back(), 1), base::Matrix(firstDof_.back(), 1)});
}

void JointSystem::join(const assembly::Interface& interface, const input::Parameters& law) {
  const bool isContact = law.type() == "Coulomb Friction";
  if (!isContact && law.type() != "Preload Jump") refuse(interface.name, "the law " + law.type());
  Case* tightened = isContact ? nullptr : &addCase("Interfaces", interface.name, "Jump");
  for (int p = 0; p < interface.pairs(); ++p) {
    const int first = dof(interface.body1, interface.trace1.node(p));
    const int second = dof(interface.body2, interface.trace2.node(p));
    if (master_[second] != second || master_[first] != first) refuse(interface.name, "a node in several interfaces");
    for (int c = 0; c < 3; ++c) {
      master_[second + c] = first + c;
      if (tightened) tightened->offset(second + c, 0) = -interface.frame[p][0][c];
    }
    if (!isContact) continue;
    if (std::abs(interface.gap[p]) > 1e-12 * base::norm(interface.position[p]) || law.schedule("Gap")[0] != 0.0)
      refuse(interface.name, "a gap");
    friction_.emplace_back(second, &interface);
    frame_.push_back(interface.frame[p]);
  }
}

void JointSystem::bound(const assembly::Interface& interface, const input::Parameters& law) {
  const bool isHeld = law.type() == "Prescribed Displacement";
  if (!isHeld && law.type() != "Prescribed Traction") refuse(interface.name, "the law " + law.type());
  const int steps = study_.problem.assembly.steps();
  for (int c = 0; c < 3; ++c) {
    if (isHeld && !law.has(axes[c])) continue;
    const input::Schedule schedule = law.schedule(axes[c]);
    bool isMoved = false;
    for (int t = 0; t < steps; ++t) isMoved = isMoved || schedule[t] != 0.0;
    Case* moved = isMoved ? &addCase("Boundaries", interface.name, axes[c]) : nullptr;
    for (int p = 0; p < interface.pairs(); ++p) {
      const int at = dof(interface.body1, interface.trace1.node(p)) + c;
      if (isHeld) isHeld_[at] = 1;
      if (moved) (isHeld ? moved->offset : moved->load)(at, 0) += isHeld ? 1.0 : interface.area[p];
    }
  }
}

void JointSystem::number() {
  const int dofs = firstDof_.back();
  int count = 0;
  shares_.resize(dofs);
  for (int i = 0; i < dofs; ++i) {
    if (master_[i] == i && !isHeld_[i]) shares_[i] = {{count++, 1.0}};
  }
  for (int i = 0; i < dofs; ++i) {
    if (master_[i] == i) continue;
    if (isHeld_[i] || master_[master_[i]] != master_[i])
      refuse("an interface", "a second side that is held or joined twice");
    shares_[i] = shares_[master_[i]];
  }
  for (int p = 0; p < pairs(); ++p) {
    for (int c = 0; c < 3; ++c) {
      for (int k = 0; k < 3; ++k) shares_[friction_[p].first + c].push_back({count + k, frame_[p][k][c]});
    }
    count += 3;
  }
  matrix_.pointers.assign(count + 1, 0);
}

void JointSystem::makeMatrix() {
  // T^T K T row by row: the rows of K that a row is made of, scattered over the unknowns.
  std::vector<std::vector<Share>> made(unknowns());
  for (int i = 0; i < firstDof_.back(); ++i) {
    for (const Share& share : shares_[i]) made[share.index].push_back({i, share.weight});
  }
  std::vector<double> sum(unknowns(), 0.0);
  std::vector<int> touchedBy(unknowns(), -1), touched;
  for (int row = 0; row < unknowns(); ++row) {
    touched.clear();
    for (const Share& from : made[row]) {
      const auto body = std::upper_bound(firstDof_.begin(), firstDof_.end(), from.index) - firstDof_.begin() - 1;
      const SparseMatrix& k = stiffness_[body];
      const int local = from.index - firstDof_[body];
      for (std::size_t e = k.pointers[local]; e < k.pointers[local + 1]; ++e) {
        const double value = from.weight * k.values[e];
        for (const Share& to : shares_[firstDof_[body] + k.columns[e]]) {
          if (touchedBy[to.index] != row) {
            touchedBy[to.index] = row;
            touched.push_back(to.index);
          }
          sum[to.index] += value * to.weight;
        }
      }
    }
    std::sort(touched.begin(), touched.end());
    for (const int column : touched) {
      matrix_.columns.push_back(column);
      matrix_.values.push_back(std::exchange(sum[column], 0.0));
    }
    matrix_.pointers[row + 1] = matrix_.columns.size();
  }
}

base::Matrix JointSystem::product(const base::Matrix& u) const {
  base::Matrix result(u.numRows(), 1);
  for (std::size_t b = 0; b + 1 < firstDof_.size(); ++b) {
    for (int i = 0; i < stiffness_[b].rows(); ++i)
      result(firstDof_[b] + i, 0) = stiffness_[b].product(i, u.values() + firstDof_[b]);
  }
  return result;
}

void JointSystem::reduce(const double* from, double* to) const {
  for (int i = 0; i < firstDof_.back(); ++i) {
    for (const Share& share : shares_[i]) to[share.index] += share.weight * from[i];
  }
}

void JointSystem::makeForces() {
  forces_.shape(unknowns(), static_cast<int>(cases_.size()));
  for (int k = 0; k < forces_.numCols(); ++k) {
    base::Matrix force = product(cases_[k].offset);
    force.scale(-1.0);
    force += cases_[k].load;
    reduce(force.values(), forces_[k]);
  }
}

void JointSystem::makeReaders() {
  const assembly::Assembly& assembly = study_.problem.assembly;
  std::vector<base::Matrix> covectors;  // of the bodies' displacements
  for (const auto& response : study_.problem.responses) {
    const auto gradient = response->isLinear() ? response->gradient(assembly) : std::nullopt;
    if (!gradient) continue;
    base::Matrix displacement(firstDof_.back(), 1), force(firstDof_.back(), 1);
    for (const auto& share : gradient->nodes) {
      for (int c = 0; c < 3; ++c) displacement(dof(share.body, share.node) + c, 0) += share.weight[c];
    }
    for (const auto& share : gradient->pairs) {
      const assembly::Interface& interface = assembly.interfaces[share.interface];
      for (int c = 0; c < 3; ++c)
        force(dof(interface.body1, interface.trace1.node(share.pair)) + c, 0) += share.weight[c];
    }
    displacement += product(force);  // forces on side 1 are K u, which is symmetric
    covectors.push_back(displacement);
    responses_.push_back(response->name());
  }
  const int count = static_cast<int>(covectors.size());
  readers_.shape(unknowns(), count);
  offsets_.shape(static_cast<int>(cases_.size()), count);
  for (int r = 0; r < count; ++r) {
    reduce(covectors[r].values(), readers_[r]);
    for (int k = 0; k < offsets_.numRows(); ++k) {
      for (int i = 0; i < firstDof_.back(); ++i) offsets_(k, r) += covectors[r](i, 0) * cases_[k].offset(i, 0);
    }
  }
}

base::Matrix JointSystem::amplitudes(const scene::Scene& scene) const {
  base::Matrix result(static_cast<int>(cases_.size()), study_.problem.assembly.steps());
  for (int k = 0; k < result.numRows(); ++k) {
    const input::Schedule schedule = find(scene, cases_[k].list, cases_[k].name)->list("Law").schedule(cases_[k].entry);
    for (int t = 0; t < result.numCols(); ++t) result(k, t) = schedule[t];
  }
  return result;
}

std::vector<double> JointSystem::frictions(const scene::Scene& scene, int step) const {
  std::vector<double> result;
  for (const auto& [node, interface] : friction_)
    result.push_back(find(scene, "Interfaces", interface->name)->list("Law").schedule("Friction Coefficient")[step]);
  return result;
}

}  // namespace harmos::benchmarks
