#include <harmos/recovery/TractionCorrection.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::recovery {
namespace {

// Cosine of the angle between normals that count as one: 37 degrees.
constexpr double oneNormal = 0.8;
// Relative difference of two tractions that is none.
constexpr double sameTraction = 1e-6;
// Singular value of the conditions of a node, over the largest, below which they contradict each other.
constexpr double contradiction = 1e-6;

/// Faces at a node that turn their backs the same way.
struct Condition {
  base::Vector3 sum{};  // of normals
  std::vector<base::Vector3> traction;
  bool jumps = false;
};

void include(const KnownFace& face, std::size_t corner, std::size_t columns, std::vector<Condition>& conditions) {
  std::vector<base::Vector3> traction(columns, base::Vector3{});
  if (!face.traction.empty()) {
    const auto begin = face.traction.begin() + static_cast<std::ptrdiff_t>(corner * columns);
    std::copy(begin, begin + static_cast<std::ptrdiff_t>(columns), traction.begin());
  }
  for (Condition& condition : conditions) {
    if (base::dot(condition.sum, face.normal) < oneNormal * base::norm(condition.sum)) continue;
    condition.sum = condition.sum + face.normal;
    for (std::size_t j = 0; j < columns; ++j) {
      const double size = std::max(base::norm(traction[j]), base::norm(condition.traction[j]));
      condition.jumps = condition.jumps || base::distance(traction[j], condition.traction[j]) > sameTraction * size;
    }
    return;
  }
  conditions.push_back({face.normal, std::move(traction), false});
}

/// Row by row sigma n for the scaled components, shear times the square root of 2.
void correct(const std::vector<Condition>& conditions, int dimension, int node, base::Matrix& stress) {
  const int known = static_cast<int>(
      std::count_if(conditions.begin(), conditions.end(), [](const Condition& condition) { return !condition.jumps; }));
  if (known == 0) return;
  static constexpr int component[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  const int rows = known * dimension, columns = stress.numCols(), height = std::max(rows, 6);
  const double shear = std::sqrt(0.5);
  base::Matrix a(rows, 6), right(height, columns);
  int row = 0;
  for (const Condition& condition : conditions) {
    if (condition.jumps) continue;
    const base::Vector3 n = (1.0 / base::norm(condition.sum)) * condition.sum;
    for (int i = 0; i < dimension; ++i, ++row) {
      for (int k = 0; k < dimension; ++k) a(row, component[i][k]) += (i == k ? 1.0 : shear) * n[k];
      for (int j = 0; j < columns; ++j) {
        double missing = condition.traction[j][i];
        for (int k = 0; k < dimension; ++k) missing -= stress[j][6 * node + component[i][k]] * n[k];
        right(row, j) = missing;
      }
    }
  }
  std::vector<double> values(std::min(rows, 6)), work(64 * (height + columns));
  int rank = 0, info = 0;
  double unused = 0.0;
  Teuchos::LAPACK<int, double>().GELSS(rows, 6, columns, a.values(), a.stride(), right.values(), right.stride(),
                                       values.data(), contradiction, &rank, work.data(), static_cast<int>(work.size()),
                                       &unused, &info);
  if (info != 0) throw base::Error("LAPACK's GELSS failed with " + std::to_string(info) + " at a loaded node.");
  for (int j = 0; j < columns; ++j) {
    for (int m = 0; m < 6; ++m) stress[j][6 * node + m] += (m < 3 ? 1.0 : shear) * right(m, j);
  }
}

}  // namespace

void correctTractions(const std::vector<KnownFace>& faces, const std::vector<bool>& skipped, int dimension,
                      base::Matrix& stress) {
  std::vector<std::vector<Condition>> conditions(skipped.size());
  for (const KnownFace& face : faces) {
    for (std::size_t corner = 0; corner < face.node.size(); ++corner) {
      const int node = face.node[corner];
      if (!skipped[node]) include(face, corner, static_cast<std::size_t>(stress.numCols()), conditions[node]);
    }
  }
  for (std::size_t node = 0; node < conditions.size(); ++node) {
    correct(conditions[node], dimension, static_cast<int>(node), stress);
  }
}

}  // namespace harmos::recovery
