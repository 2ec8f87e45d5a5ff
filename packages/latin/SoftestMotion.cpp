#include <harmos/latin/detail/SoftestMotion.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/latin/detail/BodyGroups.hpp>
#include <harmos/latin/detail/FixedPlaces.hpp>

namespace harmos::latin {
namespace {

// Negative eigenvalue, where P^T h k P = 1, beyond that of a motion that nothing holds.
constexpr double roundOff = 1e-10;
constexpr std::size_t mostNames = 4;
// Share in the floating motion from which on the parts of an interface are named.
constexpr double takesPart = 1e-3;

/// Where two bodies, or one and the ground (-1), are held together in all directions: where interfaces have a search
/// direction, or their boundaries are eliminated and bear every traction.
std::map<std::pair<int, int>, std::vector<base::Vector3>> placesBetween(const assembly::Assembly& assembly,
                                                                        const EliminatedBoundaries& eliminated) {
  std::map<std::pair<int, int>, std::vector<base::Vector3>> places;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (interface.law->prescribesTraction()) continue;
    const auto borne = interface.law->admissibleTractions(0);
    if (eliminated.contains(static_cast<int>(i)) && !(borne && borne->isAny())) continue;
    const int other = interface.sides() == 1 ? -1 : interface.body2;
    for (int p = 0; p < interface.pairs(); ++p) {
      places[std::minmax(interface.body1, other)].push_back(
          interface.trace1.at(p, assembly.bodies[interface.body1].nodes));
    }
  }
  return places;
}

std::string roughly(double eigenvalue) {
  std::ostringstream text;
  text << std::setprecision(3) << eigenvalue;
  return text.str();
}

}  // namespace

SoftestMotion::SoftestMotion(const assembly::Assembly& assembly, const EliminatedBoundaries& eliminated,
                             const std::vector<base::Matrix>& modes, const std::vector<int>& firstMode,
                             const MacroFactor::NotPositiveDefinite& failure)
    : assembly_(assembly), eigenvalue_(failure.eigenvalue), isIndefinite_(failure.eigenvalue < -roundOff) {
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    for (int m = 0; m < modes[i].numCols(); ++m) {
      if (std::abs(failure.motion[firstMode[i] + m]) < takesPart) continue;
      for (int side = 0; side < 2; ++side) moving_.insert(assembly.interfaces[i].body(side));
    }
  }
  BodyGroups groups(assembly.bodies.size());
  for (const auto& [bodies, places] : placesBetween(assembly, eliminated)) {
    if (areFixed(places, assembly.dimension)) groups.join(bodies.first, bodies.second);
  }
  for (const int body : moving_) {
    if (groups.rootOf(body) != groups.rootOf(-1)) loose_.insert(body);
  }
}

std::string SoftestMotion::namesOf(const std::set<int>& bodies) const {
  std::set<std::string> names;
  for (const int body : bodies) names.insert(base::quoted(assembly_.bodies[body].partName()));
  return base::joinNames({names.begin(), names.end()}, mostNames);
}

void SoftestMotion::refuse() const {
  if (isIndefinite_ || loose_.empty()) {
    throw base::Error("double precision does not suffice for the chain of part(s) " + namesOf(moving_) +
                          ": round-off has made the macro problem indefinite (smallest eigenvalue " +
                          roughly(eigenvalue_) +
                          "); make the stiffnesses of parts that are joined differ less, or the chain shorter",
                      base::ExitCode::notConverged);
  }
  throw base::Error("nothing holds part(s) " + namesOf(loose_) +
                        ": they can move as rigid bodies without deforming any part (smallest eigenvalue of the macro "
                        "problem " +
                        roughly(eigenvalue_) +
                        "); add a boundary with prescribed displacement, symmetry or foundation, or join them to a "
                        "held part",
                    base::ExitCode::noEquilibrium);
}

}  // namespace harmos::latin
