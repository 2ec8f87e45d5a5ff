#include <harmos/latin/ResistedMotions.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/statics/RigidAssembly.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::latin {
namespace {

using assembly::Assembly;

// Forces of a rigid motion, over the terms that they are sums of, that are more than round-off.
constexpr double resists = 1e-10;

/// Whether |K r| is more than round-off, for several rigid motions r about a centre: K is read once for all of them.
std::vector<bool> areResisted(const substructure::Substructure& body, const std::vector<statics::Motion>& motions,
                              const base::Vector3& centre) {
  const substructure::CrsView k = substructure::viewOf(*body.stiffness, body.partName());
  const std::size_t count = motions.size(), dimension = static_cast<std::size_t>(body.dimension);
  const statics::RigidBody rigid{centre, 1.0, {}};
  std::vector<double> displacement(static_cast<std::size_t>(k.rows) * count);  // those of a degree of freedom together
  for (std::size_t node = 0; node < body.nodes.size(); ++node) {
    for (std::size_t m = 0; m < count; ++m) {
      const base::Vector3 u = statics::displacementOf(rigid, motions[m], body.nodes[node]);
      for (std::size_t c = 0; c < dimension; ++c) displacement[(node * dimension + c) * count + m] = u[c];
    }
  }
  std::vector<double> force(count, 0.0), terms(count, 0.0), sum(count), size(count);
  for (int row = 0; row < k.rows; ++row) {
    std::fill(sum.begin(), sum.end(), 0.0);
    std::fill(size.begin(), size.end(), 0.0);
    for (std::size_t at = k.rowPointers[row]; at < k.rowPointers[row + 1]; ++at) {
      const double* u = displacement.data() + static_cast<std::size_t>(k.columns[at]) * count;
      for (std::size_t m = 0; m < count; ++m) {
        const double term = k.values[at] * u[m];
        sum[m] += term;
        size[m] += std::abs(term);
      }
    }
    for (std::size_t m = 0; m < count; ++m) {
      force[m] = std::max(force[m], std::abs(sum[m]));
      terms[m] = std::max(terms[m], size[m]);
    }
  }
  std::vector<bool> resisted(count);
  for (std::size_t m = 0; m < count; ++m) resisted[m] = force[m] > resists * terms[m];
  return resisted;
}

/// Rotations about another place differ by translations, so that those that are resisted make all rotations resisted;
/// but where both across an axis of the coordinates are, the turn about that axis may be free, as that of a half plane
/// with torsion is about y.
ResistedMotions resistedBy(const substructure::Substructure& body) {
  const auto dimension = static_cast<std::size_t>(body.dimension);
  const std::size_t firstTurn = dimension == 2 ? 2 : 0;
  std::vector<statics::Motion> motions(dimension), turns(3 - firstTurn);
  for (std::size_t c = 0; c < dimension; ++c) motions[c].translation[c] = 1.0;
  for (std::size_t c = firstTurn; c < 3; ++c) turns[c - firstTurn].rotation[c] = 1.0;
  motions.insert(motions.end(), turns.begin(), turns.end());
  const std::vector<bool> atFirstNode = areResisted(body, motions, body.nodes.front());
  ResistedMotions resisted{};
  std::copy(atFirstNode.begin(), atFirstNode.end(), resisted.begin());
  const bool anyTranslation =
      std::any_of(resisted.begin(), resisted.begin() + body.dimension, [](bool one) { return one; });
  if (!anyTranslation) return resisted;
  const std::vector<bool> atOrigin =
      dimension == 3 ? areResisted(body, turns, base::Vector3{}) : std::vector<bool>(turns.size(), true);
  for (std::size_t c = firstTurn; c < 3; ++c) {
    const bool isAcross = dimension == 3 && resisted[(c + 1) % 3] && resisted[(c + 2) % 3];
    resisted[dimension + c - firstTurn] = !isAcross || atOrigin[c - firstTurn];
  }
  return resisted;
}

}  // namespace

std::vector<ResistedMotions> resistedMotions(const Assembly& assembly, const Teuchos::Comm<int>& comm) {
  constexpr std::size_t motions = 6;
  std::vector<int> mine(motions * assembly.bodies.size(), 0), all(mine);
  std::vector<std::optional<ResistedMotions>> known(assembly.bodies.size());  // of representatives
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    if (assembly.ownerOf(static_cast<int>(b)) != comm.getRank()) continue;
    const auto& congruence = assembly.bodies[b].congruence;
    const std::size_t representative = congruence ? static_cast<std::size_t>(congruence->representative) : b;
    if (!known[representative]) known[representative] = resistedBy(assembly.bodies[representative]);
    const ResistedMotions& resisted = *known[representative];
    const bool any = std::any_of(resisted.begin(), resisted.end(), [](bool one) { return one; });
    // What turns with the body is not told apart: it claims less then.
    for (std::size_t i = 0; i < motions; ++i) mine[motions * b + i] = (congruence ? any : resisted[i]) ? 1 : 0;
  }
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, static_cast<int>(mine.size()), mine.data(), all.data());
  std::vector<ResistedMotions> result(assembly.bodies.size());
  for (std::size_t b = 0; b < result.size(); ++b) {
    for (std::size_t i = 0; i < motions; ++i) result[b][i] = all[motions * b + i] != 0;
  }
  return result;
}

std::vector<ResistedMotions> resistedInPlane(const Assembly& assembly, const Teuchos::Comm<int>& comm) {
  const double z = assembly.bodies.front().nodes.front()[2];
  const bool isPlane = std::all_of(assembly.bodies.begin(), assembly.bodies.end(), [&](const auto& body) {
    return std::all_of(body.nodes.begin(), body.nodes.end(), [&](const base::Vector3& x) { return x[2] == z; });
  });
  if (!isPlane) return std::vector<ResistedMotions>(assembly.bodies.size(), ResistedMotions{});
  std::vector<ResistedMotions> result = resistedMotions(assembly, comm);
  for (std::size_t b = 0; b < result.size(); ++b) {
    if (assembly.bodies[b].congruence) result[b] = {};  // not told apart
    if (assembly.dimension == 2) std::swap(result[b][2], result[b][5]);
  }
  return result;
}

base::Vector3 centreOfMotions(const ResistedMotions& resisted, base::Vector3 centre) {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
    if (!resisted[3 + c] && resisted[d] && resisted[e]) centre[d] = centre[e] = 0.0;
  }
  return centre;
}

}  // namespace harmos::latin
