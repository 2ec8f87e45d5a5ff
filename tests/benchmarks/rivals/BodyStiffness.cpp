#include "BodyStiffness.hpp"

#include <harmos/base/Error.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::benchmarks {

SparseMatrix stiffnessOf(const std::vector<substructure::Substructure>& bodies, std::size_t body) {
  const substructure::Congruence* congruence = bodies[body].congruence.get();
  const std::size_t own = congruence ? congruence->representative : body;
  const substructure::CrsView k = substructure::viewOf(*bodies[own].stiffness, bodies[own].name);
  SparseMatrix result;
  if (!congruence) {
    result.pointers.assign(k.rowPointers, k.rowPointers + k.rows + 1);
    result.columns.assign(k.columns, k.columns + result.pointers.back());
    result.values.assign(k.values, k.values + result.pointers.back());
    return result;
  }
  const int nodes = k.rows / 3;
  std::vector<int> from(nodes);  // node of the representative
  for (int a = 0; a < nodes; ++a) from[congruence->node[a]] = a;
  const base::Frame& q = congruence->rotation;
  for (int n = 0; n < nodes; ++n) {
    const std::size_t begin = k.rowPointers[3 * from[n]];
    const std::size_t width = k.rowPointers[3 * from[n] + 1] - begin;
    if (k.rowPointers[3 * from[n] + 3] - begin != 3 * width || width % 3 != 0)
      throw base::Error("the stiffness matrix of " + bodies[own].name + " is not made of whole nodes");
    for (int c = 0; c < 3; ++c) {
      for (std::size_t e = 0; e < width; e += 3) {
        // Row c of Q K Q^T, with K the 3 x 3 entries between two nodes.
        base::Vector3 row{};
        for (int i = 0; i < 3; ++i) {
          const double* entry = k.values + begin + i * width + e;
          row = row + q[c][i] * base::Vector3{entry[0], entry[1], entry[2]};
        }
        for (int d = 0; d < 3; ++d) {
          result.columns.push_back(3 * congruence->node[k.columns[begin + e] / 3] + d);
          result.values.push_back(base::dot(row, q[d]));
        }
      }
      result.pointers.push_back(result.columns.size());
    }
  }
  return result;
}

}  // namespace harmos::benchmarks
