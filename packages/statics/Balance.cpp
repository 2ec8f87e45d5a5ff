#include <harmos/statics/Balance.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/statics/LinearProgramme.hpp>

namespace harmos::statics {
namespace {

// Closing over sliding beyond the cone, relative to the largest jump, that is round-off of the multipliers.
constexpr double onTheCone = 1e-7;
// Cuts of a cone by planes converge fast: each halves the angle between two rays or more.
constexpr int maximumRounds = 60;
// Loads left unbalanced, over their scale, that are round-off.
constexpr double enough = 1e-10;

constexpr double infinity = laws::AdmissibleTractions::unlimited;

/// The loads in the order of WorkTerm::index: forces over the scale, moments over scale and size.
std::vector<double> resultants(const RigidAssembly& assembly, const std::vector<Wrench>& loads, double scale) {
  std::vector<double> all;
  for (std::size_t b = 0; b < loads.size(); ++b) {
    const base::Vector3 force = (1.0 / scale) * loads[b].force;
    const base::Vector3 moment = (1.0 / (scale * assembly.bodies[b].size)) * loads[b].moment;
    if (assembly.dimension == 2) {
      all.insert(all.end(), {force[0], force[1], moment[2]});
    } else {
      all.insert(all.end(), force.begin(), force.end());
      all.insert(all.end(), moment.begin(), moment.end());
    }
  }
  return all;
}

std::vector<double> negative(std::vector<double> values) {
  for (double& value : values) value = -value;
  return values;
}

/// Tractions and, at a cost, what they leave unbalanced.
class Programme {
 public:
  Programme(const RigidAssembly& assembly, const std::vector<double>& loads, double scale, Friction friction)
      : assembly_(assembly),
        scale_(scale),
        rows_(static_cast<int>(loads.size())),
        programme_(negative(loads)),
        friction_(friction) {
    for (int row = 0; row < rows_; ++row) {
      const RigidBody& body = assembly.bodies[row / assembly.motions()];
      // What a body bears by itself costs nothing.
      const double cost = body.isHeld[row % assembly.motions()] ? 0.0 : 1.0;
      programme_.add({{row, -1.0}}, 0.0, infinity, cost);
      programme_.add({{row, 1.0}}, 0.0, infinity, cost);
    }
  }

  void addJoint(const Joint& joint) {
    const laws::AdmissibleTractions& tractions = joint.tractions;
    const bool slides = hasFriction(joint);
    for (int c = 0; c < assembly_.dimension; ++c) {
      const auto i = static_cast<std::size_t>(c);
      base::Vector3 direction = joint.frame[i];
      if (assembly_.dimension == 2) direction[2] = 0.0;
      if (tractions.lower[i] == 0.0 && tractions.upper[i] == 0.0) continue;
      if (slides && c == 0) {
        // Its pressure comes with the rays; tension, if it bears any, by itself.
        if (tractions.upper[0] > 0.0) add(joint, direction, 0.0, bound(tractions.upper[0], joint));
        continue;
      }
      add(joint, direction, bound(tractions.lower[i], joint), bound(tractions.upper[i], joint));
    }
    if (!slides) return;
    addRay(joint, 1.0, 0.0);
    addRay(joint, -1.0, 0.0);
    if (assembly_.dimension == 2) return;
    addRay(joint, 0.0, 1.0);
    addRay(joint, 0.0, -1.0);
  }

  void addCoupling(const Coupling& coupling) { add(workOf(assembly_, coupling), -infinity, infinity); }

  /// Whether the friction of all joints withstands the motion; where it does not, the ray that does is added.
  bool withstands(const std::vector<Motion>& motions) {
    std::vector<base::Vector3> jumps;
    double largest = 0.0;
    for (const Joint& joint : assembly_.joints) {
      jumps.push_back(jumpOf(joint, assembly_.bodies, motions));
      largest = std::max(largest, base::norm(jumps.back()));
    }
    bool all = true;
    for (std::size_t i = 0; i < jumps.size(); ++i) {
      const Joint& joint = assembly_.joints[i];
      const double slip = base::tangentialNorm(jumps[i]);
      if (!hasFriction(joint) || jumps[i][0] - joint.tractions.friction * slip >= -onTheCone * largest) continue;
      addRay(joint, jumps[i][1] / slip, jumps[i][2] / slip);
      all = false;
    }
    return all;
  }

  /// With the cones of friction in space exactly met. False when that did not come about.
  bool solve() {
    for (int round = 0; round < maximumRounds; ++round) {
      if (!programme_.solve()) return false;
      if (programme_.value() <= enough || assembly_.dimension == 2 || withstands(motions())) return true;
    }
    return false;
  }

  double residual() const { return programme_.value(); }

  /// In the order of WorkTerm::index: what tractions leave of the loads.
  std::vector<double> unbalanced() const {
    const std::vector<double> solution = programme_.solution();
    std::vector<double> left;
    for (int row = 0; row < rows_; ++row) {
      const bool isHeld = assembly_.bodies[row / assembly_.motions()].isHeld[row % assembly_.motions()];
      left.push_back(isHeld ? 0.0 : solution[2 * row] - solution[2 * row + 1]);
    }
    return left;
  }

  /// Along which the loads work the residual and joints nothing against them: minus the multipliers.
  std::vector<Motion> motions() const { return motionsOf(assembly_, negative(programme_.multipliers())); }

 private:
  bool hasFriction(const Joint& joint) const { return friction_ == Friction::full && joint.tractions.friction > 0.0; }

  double bound(double traction, const Joint& joint) const {
    return std::isinf(traction) || traction == 0.0 ? traction : traction * joint.area / scale_;
  }

  void add(const std::vector<WorkTerm>& work, double lower, double upper) {
    std::vector<LinearProgramme::Entry> column;
    for (const WorkTerm& term : work) column.push_back({term.index, term.value});
    programme_.add(column, lower, upper, 0.0);
  }

  void add(const Joint& joint, const base::Vector3& direction, double lower, double upper) {
    add(workOf(assembly_, joint, direction), lower, upper);
  }

  /// The pressure 1 with the friction that it allows along t1, t2.
  void addRay(const Joint& joint, double t1, double t2) {
    const double mu = joint.tractions.friction;
    add(joint, base::toGlobal(joint.frame, {-1.0, mu * t1, mu * t2}), 0.0, infinity);
  }

  const RigidAssembly& assembly_;
  double scale_;
  int rows_;
  LinearProgramme programme_;
  Friction friction_;
};

/// The largest displacement becomes 1, and 0 what is round-off beside it.
void normalise(const RigidAssembly& assembly, std::vector<Motion>& motions) {
  constexpr double roundOff = 1e-9;
  double largest = 0.0;
  for (std::size_t b = 0; b < motions.size(); ++b) {
    largest = std::max(
        {largest, base::norm(motions[b].translation), assembly.bodies[b].size * base::norm(motions[b].rotation)});
  }
  if (largest == 0.0) return;
  for (std::size_t b = 0; b < motions.size(); ++b) {
    for (std::size_t c = 0; c < 3; ++c) {
      double& u = motions[b].translation[c];
      double& r = motions[b].rotation[c];
      u = std::abs(u) <= roundOff * largest ? 0.0 : u / largest;
      r = std::abs(r) * assembly.bodies[b].size <= roundOff * largest ? 0.0 : r / largest;
    }
  }
}

}  // namespace

Balance findBalance(const RigidAssembly& assembly, const std::vector<Wrench>& loads, double scale, Friction friction) {
  Balance balance;
  balance.isKnown = true;
  if (assembly.bodies.empty() || scale == 0.0) return balance;
  Programme programme(assembly, resultants(assembly, loads, scale), scale, friction);
  for (const Joint& joint : assembly.joints) programme.addJoint(joint);
  for (const Coupling& coupling : assembly.couplings) programme.addCoupling(coupling);
  balance.isKnown = programme.solve();
  if (!balance.isKnown) return balance;
  balance.residual = programme.residual();
  balance.motions = programme.motions();
  normalise(assembly, balance.motions);
  const std::vector<Motion> left = motionsOf(assembly, programme.unbalanced());
  for (std::size_t b = 0; b < left.size(); ++b) {
    // A moment over its size is a rotation times the size.
    const double size = assembly.bodies[b].size;
    balance.unbalanced.push_back({scale * left[b].translation, scale * size * size * left[b].rotation});
  }
  return balance;
}

}  // namespace harmos::statics
