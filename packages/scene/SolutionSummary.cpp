#include <harmos/scene/detail/SolutionSummary.hpp>

#include <algorithm>
#include <utility>

#include <harmos/latin/SectionForces.hpp>
#include <harmos/scene/detail/PartPieces.hpp>

namespace harmos::scene {
namespace {

// Of two values that count as the same one when the worst point is looked for.
constexpr double sameValue = 1e-6;

/// Positions in the assembly of the interfaces of one name.
using Named = std::pair<std::string, std::vector<int>>;

std::vector<Named> interfacesByName(const Problem& problem) {
  std::vector<Named> result;
  for (std::size_t i = 0; i < problem.assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = problem.assembly.interfaces[i];
    if (interface.isCut) continue;
    auto found = std::find_if(result.begin(), result.end(), [&](const Named& n) { return n.first == interface.name; });
    if (found == result.end()) found = result.insert(result.end(), {interface.name, {}});
    found->second.push_back(static_cast<int>(i));
  }
  return result;
}

/// Looks for the least safety; of points that have it the one under the largest pressure.
class Search {
 public:
  void include(const assembly::Interface& interface, const latin::PairFields& fields, const latin::Safety& safety,
               const std::vector<double>& values, int step) {
    for (int p = 0; p < fields.pairs; ++p) {
      const std::size_t at = fields.at(step, p);
      if (!safety.counts[at]) continue;
      const double pressure = -fields.traction[at][0];
      const bool isSame = values[at] <= worst_.value * (1.0 + sameValue);
      const bool isLess = values[at] < worst_.value * (1.0 - sameValue);
      if (!isLess && !(isSame && pressure > pressure_ * (1.0 + sameValue))) continue;
      worst_ = {interface.name, values[at], interface.position[p]};
      pressure_ = pressure;
    }
  }
  const files::WorstPoint& worst() const { return worst_; }

 private:
  files::WorstPoint worst_{"", 2.0 * latin::largestSafety, {}};
  double pressure_ = 0.0;
};

void includeSafety(const Problem& problem, const InterfaceFields& all, const std::vector<int>& interfaces, int step,
                   files::InterfaceRecord& record) {
  latin::ContactKind kind;
  latin::ContactSums sums;
  for (int t = 0; t <= step; ++t) {
    sums = {0.0, 0.0, 0.0, sums.largestPressure};
    for (const int i : interfaces) latin::add(problem.assembly.interfaces[i], all.fields[i], t, sums);
    sums.largestPressure = std::max(sums.largestPressure, sums.pressure);
  }
  Search slip, gaping;
  for (const int i : interfaces) {
    const assembly::Interface& interface = problem.assembly.interfaces[i];
    kind = latin::ContactKind::of(interface, all.fields[i].times, step);
    slip.include(interface, all.fields[i], all.safety[i], all.safety[i].slip, step);
    gaping.include(interface, all.fields[i], all.safety[i], all.safety[i].gaping, step);
  }
  if (sums.largestPressure == 0.0) return;
  if (kind.gapes) record.gaping = files::SafetyRecord{sums.gaping(), gaping.worst()};
  if (kind.slips) record.slip = files::SafetyRecord{sums.slip(), slip.worst()};
}

files::InterfaceRecord describe(const Problem& problem, const InterfaceFields& all, const Named& named, int step) {
  const latin::Section section =
      latin::sectionOf(problem.assembly, named.second, elasticity::isAxisymmetric(problem.model.kinematics));
  files::InterfaceRecord record;
  latin::SectionForces forces;
  for (const int i : named.second) {
    const assembly::Interface& interface = problem.assembly.interfaces[i];
    const latin::PairFields& fields = all.fields[i];
    const latin::SectionForces mine = latin::forcesOf(interface, fields, step, section);
    forces.force = forces.force + mine.force;
    forces.moment = forces.moment + mine.moment;
    for (int p = 0; p < fields.pairs; ++p) {
      record.dissipated += interface.area[p] * all.law[i].lost[fields.at(step, p)];
      record.stored += interface.area[p] * all.law[i].stored[fields.at(step, p)];
    }
  }
  record.name = named.first;
  record.centre = section.centre;
  record.normal = section.normal;
  record.force = forces.force;
  record.moment = forces.moment;
  record.axial = forces.axial(section);
  record.shear = forces.shear(section);
  record.bending = forces.bending(section);
  record.torque = forces.torque(section);
  includeSafety(problem, all, named.second, step, record);
  return record;
}

/// What acts on one part.
class PartForces {
 public:
  PartForces(const Problem& problem, const PartPieces& part) : problem_(problem), part_(part) {
    section_.isAxisymmetric = elasticity::isAxisymmetric(problem.model.kinematics);
    for (const int node : part.piece.nodes) section_.centre = section_.centre + problem.mesh.nodes[node];
    section_.centre = (1.0 / static_cast<double>(part.piece.nodes.size())) * section_.centre;
    if (section_.isAxisymmetric) section_.centre[0] = 0.0;
  }

  void include(const std::vector<int>& interfaces, const InterfaceFields& all, int step) {
    double size = 0.0;
    for (const int i : interfaces) {
      const assembly::Interface& interface = problem_.assembly.interfaces[i];
      for (int side = 0; side < interface.sides(); ++side) {
        const int body = interface.body(side);
        if (std::count(part_.bodies.begin(), part_.bodies.end(), body) == 0) continue;
        const double sign = side == 0 ? 1.0 : -1.0;
        for (int p = 0; p < interface.pairs(); ++p) {
          const base::Vector3& t = all.fields[i].traction[all.fields[i].at(step, p)];
          const base::Vector3 f = sign * interface.area[p] * base::toGlobal(interface.frame[p], t);
          sum_.add(section_, interface.trace(side).at(p, problem_.assembly.bodies[body].nodes), f);
          size += base::norm(f);
        }
      }
    }
    largest_ = std::max(largest_, size);
  }

  void includeLoads(const latin::Iterate& state, int step) {
    latin::SectionForces loads;
    for (const int b : part_.bodies) {
      const substructure::Substructure& body = problem_.assembly.bodies[b];
      if (!state.layout().owns(b) || body.loads.numRows() == 0) continue;
      for (std::size_t node = 0; node < body.nodes.size(); ++node) {
        base::Vector3 f{};
        for (int c = 0; c < body.dimension; ++c) {
          f[c] = body.loads(body.dimension * static_cast<int>(node) + c, step);
        }
        loads.add(section_, body.nodes[node], f);
      }
    }
    std::vector<double> sums(loads.force.begin(), loads.force.end());
    sums.insert(sums.end(), loads.moment.begin(), loads.moment.end());
    state.metric().sum(sums);
    for (std::size_t c = 0; c < 3; ++c) {
      sum_.force[c] += sums[c];
      sum_.moment[c] += sums[3 + c];
    }
    largest_ = std::max(largest_, base::norm({sums[0], sums[1], sums[2]}));
  }

  files::PartRecord record() const { return {part_.name, section_.centre, sum_.force, sum_.moment, largest_}; }

 private:
  const Problem& problem_;
  const PartPieces& part_;
  latin::Section section_;
  latin::SectionForces sum_;
  double largest_ = 0.0;
};

void keepLeast(const std::optional<files::SafetyRecord>& candidate, std::optional<files::SafetyRecord>& least) {
  if (candidate && (!least || candidate->whole < least->whole * (1.0 - sameValue))) least = candidate;
}

}  // namespace

files::SolutionRecord summarise(const Problem& problem, const latin::Iterate& state, const InterfaceFields& fields,
                                int step) {
  files::SolutionRecord record;
  const std::vector<Named> named = interfacesByName(problem);
  for (const Named& each : named) {
    record.interfaces.push_back(describe(problem, fields, each, step));
    keepLeast(record.interfaces.back().slip, record.slip);
    keepLeast(record.interfaces.back().gaping, record.gaping);
  }
  for (const PartPieces& part : partPieces(problem.mesh, problem.bodies.pieces)) {
    PartForces forces(problem, part);
    for (const Named& each : named) forces.include(each.second, fields, step);
    forces.includeLoads(state, step);
    record.parts.push_back(forces.record());
  }
  return record;
}

}  // namespace harmos::scene
