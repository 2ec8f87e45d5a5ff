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
  base::Vector3 sum{};                  // of normals
  std::vector<base::Vector3> traction;  // per column; empty: none
  bool jumps = false;
};

/// Of a face at one of its corners; empty: none.
std::vector<base::Vector3> tractionAt(const KnownFace& face, std::size_t corner, std::size_t columns) {
  if (face.traction.empty()) return {};
  const auto begin = face.traction.begin() + static_cast<std::ptrdiff_t>(corner * columns);
  return {begin, begin + static_cast<std::ptrdiff_t>(columns)};
}

bool differ(const std::vector<base::Vector3>& a, const std::vector<base::Vector3>& b) {
  for (std::size_t j = 0; j < std::max(a.size(), b.size()); ++j) {
    const base::Vector3 first = a.empty() ? base::Vector3{} : a[j], second = b.empty() ? base::Vector3{} : b[j];
    if (base::distance(first, second) > sameTraction * std::max(base::norm(first), base::norm(second))) return true;
  }
  return false;
}

void include(const KnownFace& face, std::size_t corner, std::size_t columns, std::vector<Condition>& conditions) {
  std::vector<base::Vector3> traction = tractionAt(face, corner, columns);
  for (Condition& condition : conditions) {
    if (base::dot(condition.sum, face.normal) < oneNormal * base::norm(condition.sum)) continue;
    condition.sum = condition.sum + face.normal;
    condition.jumps = condition.jumps || differ(traction, condition.traction);
    return;
  }
  conditions.push_back({face.normal, std::move(traction), false});
}

constexpr int component[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

/// t - sigma n of a node: components x columns.
base::Matrix missing(const Condition& condition, const base::Vector3& n, int dimension, int columns,
                     const double* stress) {
  base::Matrix result(columns, dimension);
  for (int i = 0; i < dimension; ++i) {
    for (int j = 0; j < columns && !condition.traction.empty(); ++j) result[i][j] = condition.traction[j][i];
    for (int k = 0; k < dimension; ++k) {
      const double* from = stress + static_cast<std::ptrdiff_t>(columns) * component[i][k];
      for (int j = 0; j < columns; ++j) result[i][j] -= n[k] * from[j];
    }
  }
  return result;
}

/// One condition: r n + n r - (r.n) n n, with r what is missing.
void correct(const Condition& condition, int dimension, int columns, double* stress) {
  const base::Vector3 n = (1.0 / base::norm(condition.sum)) * condition.sum;
  const base::Matrix r = missing(condition, n, dimension, columns, stress);
  for (int i = 0; i < dimension; ++i) {
    for (int k = i; k < dimension; ++k) {
      double* to = stress + static_cast<std::ptrdiff_t>(columns) * component[i][k];
      for (int j = 0; j < columns; ++j) {
        double along = 0.0;
        for (int l = 0; l < dimension; ++l) along += r[l][j] * n[l];
        to[j] += r[i][j] * n[k] + n[i] * r[k][j] - along * n[i] * n[k];
      }
    }
  }
}

/// Several: row by row sigma n for the scaled components, shear times the square root of 2.
void correct(const std::vector<Condition>& conditions, int dimension, int columns, double* stress) {
  const int rows = static_cast<int>(conditions.size()) * dimension, height = std::max(rows, 6);
  const double shear = std::sqrt(0.5);
  base::Matrix a(rows, 6), right(height, columns);
  int row = 0;
  for (const Condition& condition : conditions) {
    const base::Vector3 n = (1.0 / base::norm(condition.sum)) * condition.sum;
    const base::Matrix r = missing(condition, n, dimension, columns, stress);
    for (int i = 0; i < dimension; ++i, ++row) {
      for (int k = 0; k < dimension; ++k) a(row, component[i][k]) += (i == k ? 1.0 : shear) * n[k];
      for (int j = 0; j < columns; ++j) right(row, j) = r[i][j];
    }
  }
  std::vector<double> values(std::min(rows, 6)), work(64 * (height + columns));
  int rank = 0, info = 0;
  double unused = 0.0;
  Teuchos::LAPACK<int, double>().GELSS(rows, 6, columns, a.values(), a.stride(), right.values(), right.stride(),
                                       values.data(), contradiction, &rank, work.data(), static_cast<int>(work.size()),
                                       &unused, &info);
  if (info != 0) throw base::Error("LAPACK's GELSS failed with " + std::to_string(info) + " at a loaded node.");
  for (int m = 0; m < 6; ++m) {
    for (int j = 0; j < columns; ++j) stress[columns * m + j] += (m < 3 ? 1.0 : shear) * right(m, j);
  }
}

}  // namespace

std::vector<bool> correctTractions(const std::vector<KnownFace>& faces, const std::vector<bool>& skipped, int dimension,
                                   base::Matrix& stress) {
  const int columns = stress.numRows() / 6;
  std::vector<std::vector<Condition>> conditions(skipped.size());
  for (const KnownFace& face : faces) {
    for (std::size_t corner = 0; corner < face.node.size(); ++corner) {
      const int node = face.node[corner];
      if (!skipped[node]) include(face, corner, static_cast<std::size_t>(columns), conditions[node]);
    }
  }
  std::vector<bool> isCorrected(conditions.size(), false);
  for (std::size_t node = 0; node < conditions.size(); ++node) {
    std::vector<Condition>& of = conditions[node];
    of.erase(std::remove_if(of.begin(), of.end(), [](const Condition& condition) { return condition.jumps; }),
             of.end());
    if (of.empty()) continue;
    isCorrected[node] = true;
    double* here = stress[static_cast<int>(node)];
    if (of.size() == 1) {
      correct(of.front(), dimension, columns, here);
    } else {
      correct(of, dimension, columns, here);
    }
  }
  return isCorrected;
}

}  // namespace harmos::recovery
