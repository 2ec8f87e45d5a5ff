#include <harmos/latin/EquilibriumCheck.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/detail/RigidWork.hpp>

namespace harmos::latin {
namespace {

Imbalance worstOfAllRanks(const Imbalance& mine, const Teuchos::Comm<int>& comm) {
  if (comm.getSize() == 1) return mine;
  double largest = 0.0;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, mine.relative, Teuchos::outArg(largest));
  const int candidate = mine.relative == largest ? comm.getRank() : comm.getSize();
  int root = 0;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MIN, candidate, Teuchos::outArg(root));
  // Plain data, the same on every rank of a homogeneous machine.
  Imbalance worst = mine;
  Teuchos::broadcast(comm, root, static_cast<int>(sizeof(worst)), reinterpret_cast<char*>(&worst));
  return worst;
}

constexpr int motions = 6;

/// Sums over the interface rows of one body at one load step.
struct StepSums {
  std::array<double, motions> resultant{};  // P^T h (f - f^)
  double forces = 0.0;                      // sum of h max(|f|, |f^|)
};

}  // namespace

Imbalance largestImbalance(const Iterate& state, const std::vector<bool>& canMove, double leastShare) {
  const assembly::Assembly& assembly = state.assembly();
  const auto steps = static_cast<std::size_t>(state.traction().numCols());
  const auto dimension = static_cast<std::size_t>(state.layout().dimension());
  const HeldMotions& held = state.heldMotions();

  std::vector<StepSums> sums(assembly.bodies.size() * steps);
  for (const TraceLayout::Block& block : state.layout().blocks()) {
    const assembly::Interface& interface = assembly.interfaces[block.interface];
    const auto body = static_cast<std::size_t>(block.body);
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
          sum.forces += area * std::max(std::abs(hatted), std::abs(traction));
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
  // A body belongs to one rank, so its sums are complete there; the worst of all ranks is what counts.
  double least = 0.0;
  if (leastShare > 0.0) {
    double mine = 0.0;
    for (const StepSums& sum : sums) mine = std::max(mine, sum.forces);
    Teuchos::reduceAll(state.layout().comm(), Teuchos::REDUCE_MAX, leastShare * mine, Teuchos::outArg(least));
  }
  Imbalance worst;
  for (std::size_t body = 0; body < assembly.bodies.size(); ++body) {
    if (!canMove.empty() && !canMove[body]) continue;
    double scale = least;
    for (std::size_t t = 0; t < steps; ++t) scale = std::max(scale, sums[body * steps + t].forces);
    if (scale == 0.0) continue;
    for (std::size_t t = 0; t < steps; ++t) {
      const StepSums& sum = sums[body * steps + t];
      const auto r = held.freePart(static_cast<int>(body), sum.resultant);
      const base::Vector3 force{r[0], r[1], r[2]};
      const base::Vector3 moment{r[3], r[4], r[5]};
      const double relative =
          std::max(base::norm(force), base::norm(moment) / held.extent(static_cast<int>(body))) / scale;
      if (relative <= worst.relative) continue;
      worst = {static_cast<int>(body),
               static_cast<int>(t),
               force,
               moment,
               held.centre(static_cast<int>(body)),
               held.extent(static_cast<int>(body)),
               sum.forces,
               relative};
    }
  }
  return worstOfAllRanks(worst, state.layout().comm());
}

std::string describe(const Imbalance& imbalance, const assembly::Assembly& assembly) {
  std::ostringstream text;
  text.precision(4);
  text << "part \"" << assembly.bodies[imbalance.body].name << "\", load step " << imbalance.step + 1
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
