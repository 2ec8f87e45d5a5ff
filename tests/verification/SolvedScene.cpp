#include "SolvedScene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include <Tpetra_Core.hpp>

#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/PairFields.hpp>
#include <harmos/scene/Problem.hpp>

namespace harmos::verification {

SolvedScene::SolvedScene(const SceneInput& input) : SolvedScene(input, Tpetra::getDefaultComm()) {}

SolvedScene::SolvedScene(const SceneInput& input, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  base::Timers timers;
  const scene::Scene scene = input.scene();
  const scene::Problem problem = scene::makeProblem(scene, *comm, timers);
  latin::LatinSolver solver(problem.assembly, latin::LatinOptions(scene.input.list("Solver")), comm, timers);
  for (const auto& response : problem.responses) solver.addResponse(response);
  result = solver.solve();

  const assembly::Assembly& assembly = problem.assembly;
  pairs_.resize(assembly.steps());
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    auto name = std::find(names_.begin(), names_.end(), interface.name);
    if (name == names_.end()) name = names_.insert(name, interface.name);
    const latin::PairFields fields = latin::pairFields(solver.state(), static_cast<int>(i));
    for (int t = 0; t < assembly.steps(); ++t) {
      for (int p = 0; p < interface.pairs(); ++p) {
        const auto pair = static_cast<std::size_t>(p);
        const std::size_t at = fields.at(t, p);
        pairs_[t].push_back({static_cast<int>(name - names_.begin()),
                             {interface.position[pair], interface.area[pair], fields.traction[at], fields.jump[at],
                              fields.status[at]}});
      }
    }
  }

  std::vector<double> components;
  for (std::size_t body = 0; body < assembly.bodies.size(); ++body) {
    const mesh::Piece& part = problem.bodies.pieces[body];
    for (std::size_t node = 0; node < part.nodes.size(); ++node) {
      base::Vector3 u{};
      if (solver.state().layout().owns(static_cast<int>(body))) {
        u = solver.state().displacement(static_cast<int>(body), static_cast<int>(node), assembly.steps() - 1);
      }
      displacements_.push_back({part.nodes[node], {}});
      components.insert(components.end(), u.begin(), u.end());
    }
  }
  solver.state().metric().sum(components);
  for (std::size_t i = 0; i < displacements_.size(); ++i) {
    std::copy_n(components.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, displacements_[i].displacement.begin());
  }
}

const std::vector<double>& SolvedScene::values(const std::string& response) const {
  for (const auto& one : result.responses) {
    if (one.name == response) return one.values;
  }
  throw std::invalid_argument("the scene has no response " + response);
}

double SolvedScene::value(const std::string& response, int step) const {
  const auto& all = values(response);
  return step < 0 ? all.back() : all.at(static_cast<std::size_t>(step));
}

std::vector<PairValue> SolvedScene::pairs(const std::string& interface, int step) const {
  const auto name = static_cast<int>(std::find(names_.begin(), names_.end(), interface) - names_.begin());
  std::vector<PairValue> found;
  for (const NamedPair& pair : step < 0 ? pairs_.back() : pairs_.at(static_cast<std::size_t>(step))) {
    if (pair.interface == name) found.push_back(pair.value);
  }
  if (found.empty()) throw std::invalid_argument("the scene has no interface " + interface);
  return found;
}

double displacementDifference(const SolvedScene& run, const SolvedScene& reference) {
  std::map<int, base::Vector3> expected;
  double largest = 0.0;
  for (const NodeValue& node : reference.displacements()) {
    const base::Vector3& u = node.displacement;
    expected[node.meshNode] = u;
    largest = std::max(largest, std::hypot(u[0], u[1], u[2]));
  }
  double difference = 0.0;
  for (const NodeValue& node : run.displacements()) {
    const base::Vector3& u = node.displacement;
    const base::Vector3& v = expected.at(node.meshNode);
    difference = std::max(difference, std::hypot(u[0] - v[0], u[1] - v[1], u[2] - v[2]));
  }
  return difference / largest;
}

}  // namespace harmos::verification
