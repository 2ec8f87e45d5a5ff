#include <harmos/latin/ResistedMotions.hpp>

#include <algorithm>
#include <cmath>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/statics/RigidAssembly.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::latin {
namespace {

using assembly::Assembly;

// Forces of a rigid motion, over the terms that they are sums of, that are more than round-off.
constexpr double resists = 1e-10;

/// Whether |K r| is more than round-off for the rigid motions r about the first node. Rotations about another place
/// differ by translations, so that those that are resisted make all rotations resisted; but where both across an axis
/// of the coordinates are, the turn about that axis may be free, as that of a half plane with torsion is about y.
ResistedMotions resistedBy(const substructure::Substructure& body) {
  const substructure::CrsView k = substructure::viewOf(*body.stiffness, body.name);
  const int dimension = body.dimension;
  std::vector<double> displacement(static_cast<std::size_t>(k.rows));
  const auto isResisted = [&](const statics::Motion& motion, const base::Vector3& centre) {
    const statics::RigidBody rigid{centre, 1.0, {}};
    for (std::size_t node = 0; node < body.nodes.size(); ++node) {
      const base::Vector3 u = statics::displacementOf(rigid, motion, body.nodes[node]);
      std::copy_n(u.begin(), dimension, displacement.begin() + static_cast<std::ptrdiff_t>(node) * dimension);
    }
    double force = 0.0, terms = 0.0;
    for (int row = 0; row < k.rows; ++row) {
      double sum = 0.0, size = 0.0;
      for (std::size_t at = k.rowPointers[row]; at < k.rowPointers[row + 1]; ++at) {
        const double term = k.values[at] * displacement[k.columns[at]];
        sum += term;
        size += std::abs(term);
      }
      force = std::max(force, std::abs(sum));
      terms = std::max(terms, size);
    }
    return force > resists * terms;
  };
  ResistedMotions resisted{};
  bool anyTranslation = false;
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c) {
    statics::Motion motion;
    motion.translation[c] = 1.0;
    resisted[c] = isResisted(motion, body.nodes.front());
    anyTranslation = anyTranslation || resisted[c];
  }
  for (std::size_t c = dimension == 2 ? 2 : 0; c < 3; ++c) {
    statics::Motion motion;
    motion.rotation[c] = 1.0;
    const bool isAcross = dimension == 3 && resisted[(c + 1) % 3] && resisted[(c + 2) % 3];
    resisted[dimension == 2 ? 2 : 3 + c] =
        isAcross ? isResisted(motion, base::Vector3{}) : anyTranslation || isResisted(motion, body.nodes.front());
  }
  return resisted;
}

}  // namespace

std::vector<ResistedMotions> resistedMotions(const Assembly& assembly, const Teuchos::Comm<int>& comm) {
  constexpr std::size_t motions = 6;
  std::vector<int> mine(motions * assembly.bodies.size(), 0), all(mine);
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    if (assembly.ownerOf(static_cast<int>(b)) != comm.getRank()) continue;
    const auto& congruence = assembly.bodies[b].congruence;
    const ResistedMotions resisted =
        resistedBy(assembly.bodies[congruence ? static_cast<std::size_t>(congruence->representative) : b]);
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
