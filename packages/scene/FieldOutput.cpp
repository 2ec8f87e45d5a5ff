#include <harmos/scene/detail/FieldOutput.hpp>

#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <utility>

#include <harmos/elasticity/Stress.hpp>
#include <harmos/files/ResultLayout.hpp>
#include <harmos/input/EffectiveInput.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/scene/FieldFile.hpp>
#include <harmos/scene/detail/LawOutputs.hpp>
#include <harmos/scene/detail/PartStress.hpp>

namespace harmos::scene {

namespace {

using files::ResultStep;
using files::ResultVariables;

constexpr std::size_t stressComponents = 6;
// Of two stresses that count as the same one when the largest is looked for: the place does not depend on round-off.
constexpr double sameValue = 1e-6;
constexpr const char* statusLegend = "contact_status: 0 open, 1 stick, 2 slip, 3 bonded, 4 broken";
const char* const stressNames[] = {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx"};

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Stress components that can differ from 0.
std::vector<std::size_t> stressesOf(int dimension) {
  return dimension == 2 ? std::vector<std::size_t>{0, 1, 2, 3} : std::vector<std::size_t>{0, 1, 2, 3, 4, 5};
}

/// Means over the elements of `count` load steps. Empty: of bodies of other ranks.
std::vector<base::Matrix> elementStresses(const Problem& problem, const latin::Iterate& state, int first, int count) {
  const int dimension = problem.assembly.dimension;
  std::vector<base::Matrix> stress(problem.bodies.pieces.size());
  for (std::size_t body = 0; body < stress.size(); ++body) {
    if (!state.layout().owns(static_cast<int>(body))) continue;
    const auto& part = problem.bodies.pieces[body];
    base::Matrix displacement(static_cast<int>(part.nodes.size()) * dimension, count);
    for (int j = 0; j < count; ++j)
      for (int node = 0; node < static_cast<int>(part.nodes.size()); ++node) {
        const auto u = state.relativeDisplacement(static_cast<int>(body), node, first + j);
        for (int c = 0; c < dimension; ++c) displacement(node * dimension + c, j) = u[at(c)];
      }
    base::Matrix temperature = problem.temperatures->of(part);
    if (temperature.numRows() > 0) {
      temperature = base::Matrix(Teuchos::Copy, temperature, temperature.numRows(), count, 0, first);
    }
    stress[body] = elasticity::elementStress(problem.mesh, part, *problem.bodies.materials[body],
                                             problem.model.kinematics, displacement, &temperature);
  }
  return stress;
}

/// Recovered stress of the parts as nodal variables.
class NodalStress {
 public:
  explicit NodalStress(const Problem& problem)
      : parts_(PartStress::ofAll(problem.mesh, problem.bodies, problem.model, *problem.temperatures)),
        components_(stressesOf(problem.assembly.dimension)) {}

  /// Collective. Of `count` load steps.
  void recover(const latin::Iterate& state, int first, int count) {
    stress_.clear();
    for (const PartStress& part : parts_) stress_.push_back(part.recover(state, first, count));
  }

  static void addNames(int dimension, std::vector<std::string>& names) {
    for (const std::size_t c : stressesOf(dimension)) names.push_back(std::string("nodal_") + stressNames[c]);
    for (const char* name : {"nodal_von_mises", "principal_1", "principal_2", "principal_3"}) names.emplace_back(name);
  }

  /// Fills the nodal variables from number `first` on, of the parts that this rank has: load step j of those recovered.
  void fill(const files::PartsLayout& layout, int j, std::size_t first, ResultStep& step) const {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (stress_[i].numRows() == 0) continue;
      const std::vector<int>& bodies = parts_[i].bodies();
      for (std::size_t b = 0; b < bodies.size(); ++b) {
        for (int node = 0; node < parts_[i].nodes(b); ++node) {
          const double* stress = stress_[i][j] + stressComponents * at(parts_[i].node(b, node));
          const std::size_t to = at(layout.firstNode[at(bodies[b])] + node);
          std::size_t variable = first;
          for (const std::size_t c : components_) step.nodal[variable++][to] = stress[c];
          step.nodal[variable++][to] = elasticity::vonMises(stress);
          for (const double principal : elasticity::principalStresses(stress)) step.nodal[variable++][to] = principal;
        }
      }
    }
  }

 private:
  std::vector<PartStress> parts_;
  std::vector<std::size_t> components_;
  std::vector<base::Matrix> stress_;  // per part; no rows: another rank has it
};

/// The largest of some values that belong to the pieces in their order, on the rank that has all.
files::WorstPoint largestOf(const std::vector<double>& values, const Problem& problem,
                            const std::vector<std::vector<int>>& ofPieces,
                            const std::function<base::Vector3(int)>& place) {
  files::WorstPoint worst;
  for (std::size_t piece = 0; piece < ofPieces.size(); ++piece) {
    for (const int i : ofPieces[piece]) {
      if (worst.of.empty() || values[at(i)] > worst.value * (1.0 + sameValue)) {
        worst = {problem.bodies.pieces[piece].part, values[at(i)], place(i)};
      }
    }
  }
  return worst;
}

base::Vector3 centreOf(const files::ResultMesh& mesh, int element) {
  for (const files::ResultMesh::Block& block : mesh.blocks) {
    if (element >= block.elements()) {
      element -= block.elements();
      continue;
    }
    base::Vector3 sum{};
    for (int a = 0; a < block.nodesPerElement; ++a) {
      sum = sum + mesh.nodes[at(block.connectivity[at(element * block.nodesPerElement + a)])];
    }
    return (1.0 / block.nodesPerElement) * sum;
  }
  return {};
}

/// The largest von Mises stress of a step that rank 0 has gathered.
files::StressPeak peakOf(const Problem& problem, const files::PartsLayout& layout, const ResultStep& step,
                         std::optional<std::size_t> nodalVonMises) {
  const auto placeOfNode = [&](int node) { return layout.mesh.nodes[at(node)]; };
  const auto placeOfElement = [&](int element) { return centreOf(layout.mesh, element); };
  if (!nodalVonMises) return {largestOf(step.element.back(), problem, layout.element, placeOfElement), "elements"};
  std::vector<std::vector<int>> nodes;
  for (std::size_t piece = 0; piece < problem.bodies.pieces.size(); ++piece) {
    nodes.emplace_back(problem.bodies.pieces[piece].nodes.size());
    std::iota(nodes.back().begin(), nodes.back().end(), layout.firstNode[piece]);
  }
  return {largestOf(step.nodal[*nodalVonMises], problem, nodes, placeOfNode), "nodes"};
}

std::optional<files::StressPeak> writeParts(const Problem& problem, const latin::Iterate& state,
                                            const OutputChoice& choice, const std::string& path,
                                            const FieldFile& file) {
  const auto layout = files::layOutParts(problem.mesh, problem.bodies.pieces, problem.surfaces);
  const int dimension = problem.assembly.dimension;
  const auto components = stressesOf(dimension);
  ResultVariables variables;
  addVector(variables.nodal, "disp", dimension);
  const std::size_t firstNodalStress = variables.nodal.size();
  std::optional<NodalStress> nodal;
  std::optional<std::size_t> nodalVonMises;
  if (choice.nodalStress) {
    nodal.emplace(problem);
    NodalStress::addNames(dimension, variables.nodal);
    nodalVonMises = firstNodalStress + components.size();
  }
  for (std::size_t c : components) variables.element.push_back(stressNames[c]);
  variables.element.push_back("von_mises");
  std::vector<base::Matrix> stress;
  std::optional<files::StressPeak> peak;
  const auto writer = file.open(path, layout.mesh, variables);
  for (int t = 0; t < file.steps(); ++t) {
    if (t % latin::stepsAtOnce == 0) {
      // Together, so that the integrals over an element are formed only once for them.
      const int count = std::min(latin::stepsAtOnce, file.steps() - t);
      stress.clear();  // not beside those that follow
      stress = elementStresses(problem, state, t, count);
      if (nodal) nodal->recover(state, t, count);
    }
    ResultStep step = files::zeroStep(layout.mesh, variables, file.time(t));
    for (std::size_t body = 0; body < stress.size(); ++body) {
      if (!state.layout().owns(static_cast<int>(body))) continue;
      const auto& part = problem.bodies.pieces[body];
      for (int node = 0; node < static_cast<int>(part.nodes.size()); ++node) {
        const auto u = state.displacement(static_cast<int>(body), node, t);
        for (int c = 0; c < dimension; ++c) step.nodal[at(c)][at(layout.firstNode[body] + node)] = u[at(c)];
      }
      for (std::size_t e = 0; e < part.elements.size(); ++e) {
        const double* values = stress[body][t % latin::stepsAtOnce] + e * stressComponents;
        const auto element = at(layout.element[body][e]);
        for (std::size_t c = 0; c < components.size(); ++c) step.element[c][element] = values[components[c]];
        step.element.back()[element] = elasticity::vonMises(values);
      }
    }
    if (nodal) nodal->fill(layout, t % latin::stepsAtOnce, firstNodalStress, step);
    for (auto& values : step.nodal) file.gather(values);
    for (auto& values : step.element) file.gather(values);
    if (writer && t + 1 == file.steps()) peak = peakOf(problem, layout, step, nodalVonMises);
    file.write(writer.get(), step, t);
  }
  if (writer) writer->commit();
  return peak;
}

/// Fields of one pair of an interface at one load step, ready for the file.
class InterfaceStep {
 public:
  InterfaceStep(int dimension, ResultStep& step) : dimension_(at(dimension)), step_(step) {}

  /// Of pair `p` of interface `i`; `hasArea`: its area is to stand at this node.
  void fill(const assembly::Interface& interface, const InterfaceFields& all, std::size_t i, int t, int p, bool hasArea,
            int node) {
    const latin::PairFields& fields = all.fields[i];
    const auto& frame = interface.frame[at(p)];
    const auto& traction = fields.traction[fields.at(t, p)];
    const auto& jump = fields.jump[fields.at(t, p)];
    const auto status = fields.status[fields.at(t, p)];
    const bool isContact =
        status == laws::Status::open || status == laws::Status::stick || status == laws::Status::slip;
    const bool hasJump = isContact || interface.sides() == 2;
    variable_ = dimension_;  // after the displacement
    node_ = at(node);
    put(-traction[0]);
    for (std::size_t d = 0; d < dimension_; ++d)
      put(frame[0][d] * traction[0] + frame[1][d] * traction[1] + frame[2][d] * traction[2]);
    put(static_cast<double>(status));
    // On a boundary the gap is part of the distance to a tool, and the jump is the motion of the part.
    put(hasJump ? jump[0] + (interface.sides() == 2 ? interface.gap[at(p)] : 0.0) : 0.0);
    for (std::size_t d = 0; d < dimension_; ++d) put(hasJump ? frame[1][d] * jump[1] + frame[2][d] * jump[2] : 0.0);
    put(hasJump ? std::hypot(jump[1], jump[2]) : 0.0);
    put(all.law[i].lost[fields.at(t, p)]);
    put(all.safety[i].slip[fields.at(t, p)]);
    put(all.safety[i].gaping[fields.at(t, p)]);
    put(hasArea ? interface.area[at(p)] : 0.0);
  }

  /// What the law of interface `i` adds, right after fill(): `variables` are those of its outputs.
  void fillOutputs(const InterfaceFields& all, std::size_t i, int t, int p, const std::vector<std::size_t>& variables) {
    for (std::size_t k = 0; k < variables.size(); ++k) {
      step_.nodal[variable_ + variables[k]][node_] = all.law[i].outputs[k][all.fields[i].at(t, p)];
    }
  }

 private:
  void put(double value) { step_.nodal[variable_++][node_] = value; }

  std::size_t dimension_;
  ResultStep& step_;
  std::size_t variable_ = 0, node_ = 0;
};

/// Per point of every surface, whether it shows the area of its pair: once, and not at copies, for areas are summed up.
std::vector<std::vector<bool>> showAreasOnce(const Problem& problem) {
  std::set<std::pair<int, int>> shown;
  std::vector<std::vector<bool>> shows;
  for (std::size_t s = 0; s < problem.surfaces.size(); ++s) {
    auto& ofSurface = shows.emplace_back();
    for (std::size_t p = 0; p < problem.places[s].size(); ++p) {
      const PairPlace& place = problem.places[s][p];
      const auto row = problem.surfaces[s].trace1.row(static_cast<int>(p));
      ofSurface.push_back(row.begin() != row.end() && shown.emplace(place.interface, place.pair).second);
    }
  }
  return shows;
}

void writeInterfaces(const Problem& problem, const latin::Iterate& state, const InterfaceFields& fields,
                     const LawOutputs& outputs, const std::vector<std::vector<std::size_t>>& ofLaws,
                     const std::string& path, const FieldFile& file) {
  const auto layout = files::layOutInterfaces(problem.mesh.dimension, problem.surfaces);
  const int dimension = problem.assembly.dimension;
  const auto& interfaces = problem.assembly.interfaces;
  ResultVariables variables;
  variables.nodal = interfaceVariables(dimension);
  for (const laws::OutputField& field : outputs.fields()) variables.nodal.push_back(field.name);
  const auto writer = file.open(path, layout.mesh, variables);
  const auto hasArea = showAreasOnce(problem);
  for (int t = 0; t < file.steps(); ++t) {
    ResultStep step = files::zeroStep(layout.mesh, variables, file.time(t));
    InterfaceStep filler(dimension, step);
    for (std::size_t s = 0; s < problem.surfaces.size(); ++s) {
      for (std::size_t p = 0; p < problem.places[s].size(); ++p) {
        const PairPlace& place = problem.places[s][p];
        if (place.interface < 0) continue;
        const auto i = at(place.interface);
        filler.fill(interfaces[i], fields, i, t, place.pair, hasArea[s][p], layout.firstPair[s] + static_cast<int>(p));
        filler.fillOutputs(fields, i, t, place.pair, ofLaws[i]);
      }
    }
    for (int c = 0; c < dimension; ++c) {
      auto& values = step.nodal[at(c)];
      for (std::size_t s = 0; s < problem.surfaces.size(); ++s) {
        const mesh::InterfaceSurface& surface = problem.surfaces[s];
        for (int p = 0; p < surface.pairs(); ++p) {
          double& value = values[at(layout.firstPair[s] + p)];
          const auto row = surface.trace1.row(p);
          const PairPlace& place = problem.places[s][at(p)];
          if (row.begin() != row.end()) {
            if (!state.layout().owns(surface.piece1)) continue;
            for (const auto& [node, weight] : row) value += weight * state.displacement(surface.piece1, node, t)[at(c)];
          } else if (place.interface >= 0 && state.layout().owns(interfaces[at(place.interface)].body1)) {
            value = state.traceOfBody(interfaces[at(place.interface)], place.pair, t)[at(c)];
          }
        }
      }
      file.gather(values);
    }
    file.write(writer.get(), step, t);
  }
  if (writer) writer->commit();
}

}  // namespace

std::optional<files::StressPeak> writeFields(const Scene& scene, const Problem& problem, const latin::Iterate& state,
                                             const InterfaceFields& fields, const std::vector<GlobalVariable>& globals,
                                             int solvedSteps, const files::ResultFiles& files,
                                             const Teuchos::Comm<int>& comm) {
  std::string title = scene.input.text("Title");
  if (title.empty()) title = scene.path;
  const std::vector<double> times(scene.times.begin(), scene.times.begin() + solvedSteps);
  LawOutputs outputs;
  std::vector<std::vector<std::size_t>> ofLaws;
  for (const assembly::Interface& interface : problem.assembly.interfaces)
    ofLaws.push_back(outputs.add(*interface.law));
  const std::string information =
      std::string(statusLegend) + "\n" + outputs.legend() + input::effectiveInput(scene.input);
  const FieldFile file(title, information, times, globals, comm);
  auto peak = writeParts(problem, state, scene.output, files.parts, file);
  writeInterfaces(problem, state, fields, outputs, ofLaws, files.interfaces, file);
  return peak;
}

}  // namespace harmos::scene
