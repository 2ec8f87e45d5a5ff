#include <harmos/study/detail/StochasticFields.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/files/ResultLayout.hpp>
#include <harmos/input/EffectiveInput.hpp>
#include <harmos/latin/PairFields.hpp>
#include <harmos/scene/FieldFile.hpp>

namespace harmos::study {

namespace {

using files::ResultStep;
using files::ResultVariables;

// Standard deviation over the largest mean of its field up to which a value is constant but for round-off.
constexpr double leastSpread = 1e-10;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Which moments of a field are written, and their values from its coefficients, which come one polynomial after the
/// other, so that those of all entities need not be held together.
class Moments {
 public:
  explicit Moments(const probability::Basis& basis) : basis_(basis) {
    for (std::size_t a = 0; a < basis_.indices().size(); ++a) onlyGerm_.push_back(onlyGermOf(a));
  }

  /// "disp_x" becomes "disp_x_mean", "disp_x_std", "disp_x_sobol_E_1", ..
  std::vector<std::string> names(const std::vector<std::string>& fields) const {
    std::vector<std::string> names;
    for (const std::string& field : fields) {
      names.push_back(field + "_mean");
      names.push_back(field + "_std");
      for (std::size_t g = 0; g < basis_.variables().variables().size(); ++g) {
        const bool isIndependent = basis_.variables().isIndependent();
        names.push_back(field + "_sobol_" +
                        (isIndependent ? basis_.variables().variables()[g].name : "xi_" + std::to_string(g + 1)));
      }
    }
    return names;
  }
  std::size_t count() const { return 2 + at(basis_.variables().dimension()); }

  /// Adds the coefficient of polynomial number `a` to the sums of field number `field` at an entity.
  void add(std::vector<std::vector<double>>& values, std::size_t field, std::size_t entity, std::size_t a,
           double coefficient) const {
    const std::size_t first = field * count();
    if (a == 0) {
      values[first][entity] = coefficient;
      return;
    }
    const double square = coefficient * coefficient;
    values[first + 1][entity] += square;
    if (onlyGerm_[a] >= 0) values[first + 2 + at(onlyGerm_[a])][entity] += square;
  }

  /// Makes moments of the sums of all polynomials.
  void finish(std::vector<std::vector<double>>& values) const {
    for (std::size_t first = 0; first < values.size(); first += count()) {
      for (std::size_t entity = 0; entity < values[first].size(); ++entity) {
        const double variance = values[first + 1][entity];
        values[first + 1][entity] = std::sqrt(variance);
        for (std::size_t share = 2; variance > 0.0 && share < count(); ++share) {
          values[first + share][entity] /= variance;
        }
      }
    }
    removeNoise(values);
  }

 private:
  /// Shares of a variance that is round-off beside the field are no shares.
  void removeNoise(std::vector<std::vector<double>>& values) const {
    for (std::size_t first = 0; first < values.size(); first += count()) {
      double largest = 0.0;
      for (const double mean : values[first]) largest = std::max(largest, std::abs(mean));
      for (std::size_t entity = 0; entity < values[first].size(); ++entity) {
        if (values[first + 1][entity] > leastSpread * largest) continue;
        for (std::size_t share = 2; share < count(); ++share) values[first + share][entity] = 0.0;
      }
    }
  }

  /// The germ that polynomial `a` depends on, -1 when it depends on several.
  int onlyGermOf(std::size_t a) const {
    int only = -1;
    const auto& degrees = basis_.indices()[a];
    for (std::size_t g = 0; g < degrees.size(); ++g) {
      if (degrees[g] == 0) continue;
      if (only >= 0) return -1;
      only = static_cast<int>(g);
    }
    return only;
  }

  const probability::Basis& basis_;
  std::vector<int> onlyGerm_;  // of every polynomial
};

void writeParts(const ChaosStudy& chaos, const Moments& moments, const std::string& path,
                const scene::FieldFile& file) {
  const scene::Problem& problem = chaos.problem();
  const auto& solver = chaos.solver();
  const auto layout = files::layOutParts(problem.mesh, problem.bodies.pieces, problem.surfaces);
  const int dimension = problem.assembly.dimension;
  std::vector<std::string> fields;
  scene::addVector(fields, "disp", dimension);
  ResultVariables variables;
  variables.nodal = moments.names(fields);
  const auto writer = file.open(path, layout.mesh, variables);
  for (int t = 0; t < problem.assembly.steps(); ++t) {
    ResultStep step = files::zeroStep(layout.mesh, variables, file.time(t));
    // Nodes inside: bodies that keep few columns at a time solve for those of the polynomials only once.
    for (int a = 0; a < chaos.basis().size(); ++a) {
      for (std::size_t body = 0; body < problem.bodies.pieces.size(); ++body) {
        if (!solver.state().layout().owns(static_cast<int>(body))) continue;
        for (int node = 0; node < static_cast<int>(problem.bodies.pieces[body].nodes.size()); ++node) {
          const base::Vector3 u = solver.state().displacement(static_cast<int>(body), node, solver.column(t, a));
          for (std::size_t c = 0; c < at(dimension); ++c) {
            moments.add(step.nodal, c, at(layout.firstNode[body] + node), at(a), u[c]);
          }
        }
      }
    }
    for (auto& values : step.nodal) file.gather(values);
    moments.finish(step.nodal);
    file.write(writer.get(), step, t);
  }
  if (writer) writer->commit();
}

void writeInterfaces(const ChaosStudy& chaos, const Moments& moments, const std::string& path,
                     const scene::FieldFile& file) {
  const scene::Problem& problem = chaos.problem();
  const auto& solver = chaos.solver();
  const auto layout = files::layOutInterfaces(problem.mesh.dimension, problem.surfaces);
  const int dimension = problem.assembly.dimension;
  std::vector<std::string> fields = {"contact_pressure"};
  scene::addVector(fields, "traction", dimension);
  ResultVariables variables;
  variables.nodal = moments.names(fields);
  std::vector<latin::PairFields> pairs;
  for (std::size_t i = 0; i < problem.assembly.interfaces.size(); ++i) {
    pairs.push_back(latin::pairFields(solver.state(), static_cast<int>(i)));
  }
  const auto writer = file.open(path, layout.mesh, variables);
  for (int t = 0; writer && t < problem.assembly.steps(); ++t) {
    ResultStep step = files::zeroStep(layout.mesh, variables, file.time(t));
    for (std::size_t s = 0; s < problem.surfaces.size(); ++s) {
      for (std::size_t p = 0; p < problem.places[s].size(); ++p) {
        const scene::PairPlace& place = problem.places[s][p];
        if (place.interface < 0) continue;
        const auto node = at(layout.firstPair[s]) + p;
        const auto& frame = problem.assembly.interfaces[at(place.interface)].frame[at(place.pair)];
        const latin::PairFields& field = pairs[at(place.interface)];
        for (std::size_t a = 0; a < at(chaos.basis().size()); ++a) {
          const base::Vector3& f = field.traction[field.at(solver.column(t, static_cast<int>(a)), place.pair)];
          moments.add(step.nodal, 0, node, a, -f[0]);
          for (std::size_t d = 0; d < at(dimension); ++d) {
            moments.add(step.nodal, 1 + d, node, a, frame[0][d] * f[0] + frame[1][d] * f[1] + frame[2][d] * f[2]);
          }
        }
      }
    }
    moments.finish(step.nodal);
    file.write(writer.get(), step, t);
  }
  if (writer) writer->commit();
}

}  // namespace

void writeStochasticFields(const Study& study, const ChaosStudy& chaos, const files::StochasticFiles& files,
                           const Teuchos::Comm<int>& comm) {
  const std::string& title = study.title;
  const scene::FieldFile file(title.empty() ? study.path : title, input::effectiveInput(study.input), study.scene.times,
                              {}, comm);
  const Moments moments(chaos.basis());
  writeParts(chaos, moments, files.parts, file);
  writeInterfaces(chaos, moments, files.interfaces, file);
}

}  // namespace harmos::study
