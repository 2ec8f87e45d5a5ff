#include <harmos/latin/EquilibriumCheck.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/detail/RigidWork.hpp>

namespace harmos::latin {
namespace {

constexpr int motions = 6;

/// Sums over the interface rows of one body, or of several that move as one, at one load step.
struct StepSums {
  std::array<double, motions> resultant{};  // P^T h (f - f^)
  double forces = 0.0;                      // sum of h max(|f|, |f^|)
};

/// Bodies that move as one, and those that move by themselves.
std::vector<std::vector<int>> groupsOf(const std::vector<int>& rigidBodies, std::size_t bodies) {
  std::vector<std::vector<int>> groups;
  std::map<int, std::size_t> groupOf;
  for (std::size_t b = 0; b < bodies; ++b) {
    if (!rigidBodies.empty() && rigidBodies[b] < 0) continue;
    const int number = rigidBodies.empty() ? static_cast<int>(b) : rigidBodies[b];
    const auto [at, isNew] = groupOf.try_emplace(number, groups.size());
    if (isNew) groups.emplace_back();
    groups[at->second].push_back(static_cast<int>(b));
  }
  return groups;
}

bool areOne(const std::vector<int>& rigidBodies, const assembly::Interface& interface) {
  return !rigidBodies.empty() && interface.sides() == 2 && rigidBodies[interface.body1] >= 0 &&
         rigidBodies[interface.body1] == rigidBodies[interface.body2];
}

/// A resultant about one centre, about another one.
HeldMotions::Sixfold moved(const HeldMotions::Sixfold& r, const base::Vector3& from, const base::Vector3& to) {
  const base::Vector3 moment = base::cross(from - to, {r[0], r[1], r[2]});
  return {r[0], r[1], r[2], r[3] + moment[0], r[4] + moment[1], r[5] + moment[2]};
}

/// Adds up over the ranks what each knows of its bodies.
void addRanks(std::vector<StepSums>& sums, const Teuchos::Comm<int>& comm) {
  if (comm.getSize() == 1) return;
  constexpr std::size_t count = motions + 1;
  std::vector<double> mine(count * sums.size()), all(mine);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    std::copy(sums[i].resultant.begin(), sums[i].resultant.end(),
              mine.begin() + static_cast<std::ptrdiff_t>(count * i));
    mine[count * i + motions] = sums[i].forces;
  }
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(count * i), motions, sums[i].resultant.begin());
    sums[i].forces = all[count * i + motions];
  }
}

}  // namespace

Imbalance largestImbalance(const Iterate& state, const std::vector<int>& rigidBodies, double leastShare) {
  const assembly::Assembly& assembly = state.assembly();
  const auto steps = static_cast<std::size_t>(state.traction().numCols());
  const auto dimension = static_cast<std::size_t>(state.layout().dimension());
  const HeldMotions& held = state.heldMotions();

  std::vector<StepSums> sums(assembly.bodies.size() * steps);
  for (const TraceLayout::Block& block : state.layout().blocks()) {
    const assembly::Interface& interface = assembly.interfaces[block.interface];
    const auto body = static_cast<std::size_t>(block.body);
    const bool isInside = areOne(rigidBodies, interface);
    for (std::size_t pair = 0; pair < static_cast<std::size_t>(block.pairs); ++pair) {
      const auto row = static_cast<std::size_t>(block.begin) + pair * dimension;
      const double area = interface.area[pair];
      const base::Vector3 x = interface.trace(block.side).at(static_cast<int>(pair), assembly.bodies[body].nodes);
      const base::Vector3 r = x - held.centre(block.body);
      for (std::size_t t = 0; t < steps; ++t) {
        StepSums& sum = sums[body * steps + t];
        base::Vector3 d{};
        for (std::size_t c = 0; c < dimension; ++c) {
          const double hatted = state.hattedTraction()[static_cast<int>(t)][row + c];
          const double traction = state.traction()[static_cast<int>(t)][row + c];
          d[c] = area * (traction - hatted);
          // A body that has lost every contact feels only f.
          if (!isInside) sum.forces += area * std::max(std::abs(hatted), std::abs(traction));
        }
        const auto worked = rigidWork(r, d);
        for (std::size_t i = 0; i < motions; ++i) sum.resultant[i] += worked[i];
      }
    }
  }
  const BoundaryFields& boundaries = state.boundaryFields();
  std::size_t first = 0;
  for (const int i : boundaries.interfaces) {
    const assembly::Interface& interface = assembly.interfaces[i];
    const std::size_t rows = static_cast<std::size_t>(interface.pairs()) * dimension;
    for (std::size_t t = 0; t < steps; ++t) {
      StepSums& sum = sums[static_cast<std::size_t>(interface.body1) * steps + t];
      for (std::size_t row = first; row < first + rows; ++row) {
        sum.forces += boundaries.area[row] * std::abs(boundaries.traction[static_cast<int>(t)][row]);
      }
    }
    first += rows;
  }
  addRanks(sums, state.layout().comm());  // of bodies that move as one each rank may have some
  double least = 0.0;
  for (const StepSums& sum : sums) least = std::max(least, leastShare * sum.forces);
  Imbalance worst;
  for (const std::vector<int>& group : groupsOf(rigidBodies, assembly.bodies.size())) {
    const int named = group.front();
    const base::Vector3& centre = held.centre(named);
    std::vector<StepSums> whole(steps);
    double scale = least, extent = 0.0;
    for (std::size_t t = 0; t < steps; ++t) {
      for (const int body : group) {
        const StepSums& sum = sums[static_cast<std::size_t>(body) * steps + t];
        const HeldMotions::Sixfold r = moved(sum.resultant, held.centre(body), centre);
        for (std::size_t i = 0; i < motions; ++i) whole[t].resultant[i] += r[i];
        whole[t].forces += sum.forces;
      }
      scale = std::max(scale, whole[t].forces);
    }
    for (const int body : group) extent = std::max(extent, held.extent(body));
    if (scale == 0.0) continue;
    for (std::size_t t = 0; t < steps; ++t) {
      HeldMotions::Sixfold r = whole[t].resultant;
      for (const int body : group)
        r = moved(held.freePart(body, moved(r, centre, held.centre(body))), held.centre(body), centre);
      const base::Vector3 force{r[0], r[1], r[2]};
      const base::Vector3 moment{r[3], r[4], r[5]};
      const double relative = std::max(base::norm(force), base::norm(moment) / extent) / scale;
      if (relative <= worst.relative) continue;
      worst = {named, static_cast<int>(t), force, moment, centre, extent, whole[t].forces, relative};
    }
  }
  return worst;
}

std::string describe(const Imbalance& imbalance, const assembly::Assembly& assembly) {
  std::ostringstream text;
  text.precision(4);
  text << "part \"" << assembly.bodies[imbalance.body].partName() << "\", load step " << imbalance.step + 1
       << ": unbalanced force (" << imbalance.force[0] << ", " << imbalance.force[1] << ", " << imbalance.force[2]
       << "), moment about its centre (" << imbalance.moment[0] << ", " << imbalance.moment[1] << ", "
       << imbalance.moment[2] << ")";
  return text.str();
}

std::string describeLack(const Imbalance& imbalance, const assembly::Assembly& assembly, bool hasForces) {
  const std::string why = hasForces
                              ? "forces within the friction of the interfaces would balance the loads, but no path "
                                "leads to pressures that are high enough; "
                              : "the interface laws cannot carry the loads; ";
  return why + describe(imbalance, assembly);
}

}  // namespace harmos::latin
