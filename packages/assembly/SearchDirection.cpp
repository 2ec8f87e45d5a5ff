#include <harmos/assembly/SearchDirection.hpp>

#include <algorithm>
#include <cmath>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::assembly {
namespace {

// Where nothing can part, a stiffer one carries information faster: it matters where METIS has cut a part.
constexpr double factorOfBonds = 3.0;
// A consistent mass of bilinear faces has eigenvalues from a ninth of the lumped one to the same, a third in the mean:
// k h is so much too soft on short waves, which bodies resist most. On edges of plane bodies (a third) nothing is
// gained.
constexpr double factorOfConsistentMass = 3.0;

// Of the automatic k: where softening asks for more, the stiffness of the parts is lost in the round-off of k.
constexpr double mostOfSoftening = 1e12;

/// Mean diagonal stiffness [force/length] of every node of every body, known on all ranks.
std::vector<std::vector<double>> nodalDiagonals(const Assembly& assembly, const Teuchos::Comm<int>& comm) {
  std::vector<int> offset{0};
  for (const auto& body : assembly.bodies) offset.push_back(offset.back() + static_cast<int>(body.nodes.size()));
  std::vector<double> local(offset.back(), 0.0);
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const auto& body = assembly.bodies[b];
    if (body.stiffness.is_null() || assembly.ownerOf(static_cast<int>(b)) != comm.getRank()) continue;
    const std::vector<double> diagonal = substructure::nodalStiffnessDiagonal(*body.stiffness, body.dimension);
    std::copy(diagonal.begin(), diagonal.end(), local.begin() + offset[b]);
  }
  std::vector<double> all(local.size());
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(local.size()), local.data(), all.data());

  std::vector<std::vector<double>> result(assembly.bodies.size());
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const auto& body = assembly.bodies[b];
    result[b].assign(all.begin() + offset[b], all.begin() + offset[b + 1]);
    if (!body.congruence) continue;
    // The trace of a node's diagonal block does not change under a rigid motion.
    const int from = offset[body.congruence->representative];
    for (std::size_t a = 0; a < body.congruence->node.size(); ++a) {
      result[b][body.congruence->node[a]] = all[static_cast<std::size_t>(from) + a];
    }
  }
  return result;
}

void makeConstant(const std::vector<double>& area, std::vector<double>& k) {
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t p = 0; p < k.size(); ++p) {
    sum += area[p] * std::log(k[p]);
    total += area[p];
  }
  std::fill(k.begin(), k.end(), std::exp(sum / total));
}

/// What k must not fall below, or 0. Of a law that falls at a jump no k is steep enough.
double leastOf(const Interface& interface) {
  const double fall = -interface.law->lowestSlope();
  return fall > 0.0 && std::isfinite(fall) ? SearchDirection::marginOfSoftening * interface.sides() * fall : 0.0;
}

/// Whether any value was less.
bool raise(std::vector<double>& k, double least) {
  bool isRaised = false;
  for (double& value : k) {
    if (value >= least) continue;
    value = least;
    isRaised = true;
  }
  return isRaised;
}

}  // namespace

SearchDirection::SearchDirection(const Assembly& assembly, double scale, const Teuchos::Comm<int>& comm) {
  const auto diagonals = nodalDiagonals(assembly, comm);
  for (const Interface& interface : assembly.interfaces) {
    const bool isConsistentInSpace = assembly.dimension == 3 && !interface.mass.empty();
    const double weight = scale * factor * (interface.law->bonds() ? factorOfBonds : 1.0) *
                          (isConsistentInSpace ? factorOfConsistentMass : 1.0);
    std::vector<double> k(interface.pairs());
    for (std::size_t p = 0; p < k.size(); ++p) {
      double softness = 0.0;
      for (int side = 0; side < interface.sides(); ++side) {
        const auto body = static_cast<std::size_t>(interface.body(side));
        for (const mesh::TraceOperator::Entry& entry : interface.trace(side).row(static_cast<int>(p))) {
          const double stiffness = diagonals[body][entry.node];
          if (!(stiffness > 0.0)) {
            throw base::Error("part \"" + assembly.bodies[body].partName() +
                              "\": the stiffness matrix has the diagonal entry " + std::to_string(stiffness) +
                              " at a node of interface \"" + interface.name +
                              "\"; elastic bodies have positive diagonals");
          }
          softness += entry.weight * entry.weight * interface.area[p] / stiffness;
        }
      }
      k[p] = weight * interface.sides() / softness;
    }
    if (!interface.mass.empty()) makeConstant(interface.area, k);
    const double least = leastOf(interface);
    if (least > 0.0 && !k.empty() && !(scale * least <= mostOfSoftening * *std::max_element(k.begin(), k.end()))) {
      throw base::Error("interface \"" + interface.name + "\": the law \"" + interface.law->name() + "\" falls by " +
                            base::toText(-interface.law->lowestSlope()) +
                            " [stress/length], so much more than the stiffness of the parts that double precision "
                            "loses them; lower its strength, or let it fall over a longer way",
                        base::ExitCode::notConverged);
    }
    if (raise(k, least)) heldBySoftening_.push_back(static_cast<int>(k_.size()));
    k_.push_back(std::move(k));
  }
}

}  // namespace harmos::assembly
