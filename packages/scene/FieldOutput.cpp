#include <harmos/scene/detail/FieldOutput.hpp>

#include <cmath>

#include <harmos/elasticity/Stress.hpp>
#include <harmos/files/ResultLayout.hpp>
#include <harmos/input/EffectiveInput.hpp>
#include <harmos/latin/Dissipation.hpp>
#include <harmos/scene/FieldFile.hpp>

namespace harmos::scene {

namespace {

using files::ResultStep;
using files::ResultVariables;

constexpr std::size_t stressComponents = 6;
const char* const stressNames[] = {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx"};

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Stress components that can differ from 0.
std::vector<std::size_t> stressesOf(int dimension) {
  return dimension == 2 ? std::vector<std::size_t>{0, 1, 2, 3} : std::vector<std::size_t>{0, 1, 2, 3, 4, 5};
}

void writeParts(const Problem& problem, const latin::Iterate& state, const std::string& path, const FieldFile& file) {
  const auto layout = files::layOutParts(problem.mesh, problem.bodies.pieces, problem.surfaces);
  const int dimension = problem.mesh.dimension, steps = problem.assembly.steps();
  const auto components = stressesOf(dimension);
  ResultVariables variables;
  addVector(variables.nodal, "disp", dimension);
  for (std::size_t c : components) variables.element.push_back(stressNames[c]);
  variables.element.push_back("von_mises");

  // Stresses of all steps at once: the integrals over an element are formed only once.
  std::vector<base::Matrix> stress(problem.bodies.pieces.size());
  for (std::size_t body = 0; body < stress.size(); ++body) {
    if (!state.layout().owns(static_cast<int>(body))) continue;
    const auto& part = problem.bodies.pieces[body];
    base::Matrix displacement(static_cast<int>(part.nodes.size()) * dimension, steps);
    for (int t = 0; t < steps; ++t)
      for (int node = 0; node < static_cast<int>(part.nodes.size()); ++node) {
        const auto u = state.relativeDisplacement(static_cast<int>(body), node, t);
        for (int c = 0; c < dimension; ++c) displacement(node * dimension + c, t) = u[at(c)];
      }
    const base::Matrix temperature = problem.temperatures->of(part);
    stress[body] = elasticity::elementStress(problem.mesh, part, *problem.bodies.materials[body],
                                             problem.model.kinematics, displacement, &temperature);
  }

  const auto writer = file.open(path, layout.mesh, variables);
  for (int t = 0; t < file.steps(); ++t) {
    ResultStep step = files::zeroStep(layout.mesh, variables, file.time(t));
    for (std::size_t body = 0; body < stress.size(); ++body) {
      if (!state.layout().owns(static_cast<int>(body))) continue;
      const auto& part = problem.bodies.pieces[body];
      for (int node = 0; node < static_cast<int>(part.nodes.size()); ++node) {
        const auto u = state.displacement(static_cast<int>(body), node, t);
        for (int c = 0; c < dimension; ++c) step.nodal[at(c)][at(layout.firstNode[body] + node)] = u[at(c)];
      }
      for (std::size_t e = 0; e < part.elements.size(); ++e) {
        const double* values = stress[body][t] + e * stressComponents;
        const auto element = at(layout.element[body][e]);
        for (std::size_t c = 0; c < components.size(); ++c) step.element[c][element] = values[components[c]];
        step.element.back()[element] = elasticity::vonMises(values);
      }
    }
    for (auto& values : step.nodal) file.gather(values);
    for (auto& values : step.element) file.gather(values);
    file.fillGlobals(step, t);
    if (writer) writer->write(step);
  }
  if (writer) writer->commit();
}

/// Fields of one pair of an interface at one load step, ready for the file.
class InterfaceStep {
 public:
  InterfaceStep(int dimension, ResultStep& step) : dimension_(at(dimension)), step_(step) {}

  static ResultVariables variables(int dimension) {
    ResultVariables result;
    addVector(result.nodal, "disp", dimension);
    result.nodal.push_back("contact_pressure");
    addVector(result.nodal, "traction", dimension);
    for (const char* name : {"contact_status", "opening"}) result.nodal.push_back(name);
    addVector(result.nodal, "slip", dimension);
    for (const char* name : {"slip_magnitude", "dissipation"}) result.nodal.push_back(name);
    return result;
  }

  void fill(const assembly::Interface& interface, const latin::PairFields& fields, int t, int p, int node,
            double dissipation) {
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
    put(hasJump ? jump[0] + interface.gap[at(p)] : 0.0);
    for (std::size_t d = 0; d < dimension_; ++d) put(hasJump ? frame[1][d] * jump[1] + frame[2][d] * jump[2] : 0.0);
    put(hasJump ? std::hypot(jump[1], jump[2]) : 0.0);
    put(dissipation);
  }

 private:
  void put(double value) { step_.nodal[variable_++][node_] = value; }

  std::size_t dimension_;
  ResultStep& step_;
  std::size_t variable_ = 0, node_ = 0;
};

void writeInterfaces(const Problem& problem, const latin::Iterate& state, const std::string& path,
                     const FieldFile& file) {
  const auto layout = files::layOutInterfaces(problem.mesh.dimension, problem.surfaces);
  const int dimension = problem.mesh.dimension;
  const auto& interfaces = problem.assembly.interfaces;
  std::vector<latin::PairFields> fields;
  std::vector<std::vector<double>> dissipation;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    fields.push_back(latin::pairFields(state, static_cast<int>(i)));
    dissipation.push_back(latin::lostWork(interfaces[i], fields.back()));
  }
  const auto variables = InterfaceStep::variables(dimension);
  const auto writer = file.open(path, layout.mesh, variables);
  for (int t = 0; t < file.steps(); ++t) {
    ResultStep step = files::zeroStep(layout.mesh, variables, file.time(t));
    InterfaceStep filler(dimension, step);
    for (std::size_t s = 0; s < problem.surfaces.size(); ++s) {
      for (std::size_t p = 0; p < problem.places[s].size(); ++p) {
        const PairPlace& place = problem.places[s][p];
        if (place.interface < 0) continue;
        const auto i = at(place.interface);
        filler.fill(interfaces[i], fields[i], t, place.pair, layout.firstPair[s] + static_cast<int>(p),
                    dissipation[i][fields[i].at(t, place.pair)]);
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
    file.fillGlobals(step, t);
    if (writer) writer->write(step);
  }
  if (writer) writer->commit();
}

}  // namespace

void writeFields(const Scene& scene, const Problem& problem, const latin::Iterate& state,
                 const std::vector<GlobalVariable>& globals, int solvedSteps, const files::ResultFiles& files,
                 const Teuchos::Comm<int>& comm) {
  std::string title = scene.input.text("Title");
  if (title.empty()) title = scene.path;
  const std::vector<double> times(scene.times.begin(), scene.times.begin() + solvedSteps);
  const FieldFile file(title, input::effectiveInput(scene.input), times, globals, comm);
  writeParts(problem, state, files.parts, file);
  writeInterfaces(problem, state, files.interfaces, file);
}

}  // namespace harmos::scene
