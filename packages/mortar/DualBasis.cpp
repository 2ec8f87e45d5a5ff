#include <harmos/mortar/detail/DualBasis.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Teuchos_LAPACK.hpp>

namespace harmos::mortar {
namespace {

constexpr double singular = 1e-13;  // reciprocal condition of the scaled mass

CornerMatrix sharesOf(int corners, const std::array<bool, FaceShape::mostCorners>& isKept) {
  CornerMatrix shares{};
  for (int q = 0; q < corners; ++q) {
    std::vector<int> heirs;
    if (isKept[q]) heirs = {q};
    for (const int neighbour : {(q + 1) % corners, (q + corners - 1) % corners}) {
      if (!isKept[q] && isKept[neighbour]) heirs.push_back(neighbour);
    }
    if (heirs.empty()) heirs = {(q + 2) % corners};
    for (const int p : heirs) shares[p][q] += 1.0 / static_cast<double>(heirs.size());
  }
  return shares;
}

}  // namespace

DualBasis::DualBasis(const FaceCoupling& face, std::array<bool, FaceShape::mostCorners> isKept) {
  if (solve(face, isKept)) return;
  const auto share = [&](int p) { return std::accumulate(face.mass[p].begin(), face.mass[p].end(), 0.0); };
  int best = -1;
  for (int p = 0; p < face.corners; ++p) {
    if (isKept[p] && (best < 0 || share(p) > share(best))) best = p;
  }
  isKept = {};
  isKept[best] = true;
  solve(face, isKept);
}

bool DualBasis::solve(const FaceCoupling& face, const std::array<bool, FaceShape::mostCorners>& isKept) {
  coefficients_ = {};
  areas_ = {};
  std::vector<int> kept;
  for (int p = 0; p < face.corners; ++p) {
    if (isKept[p]) kept.push_back(p);
  }
  const int n = static_cast<int>(kept.size());
  shares_ = sharesOf(face.corners, isKept);
  std::vector<double> mass(static_cast<std::size_t>(n * n)), scale(n), inverse(mass.size(), 0.0);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      double& sum = mass[i * n + j];
      for (int p = 0; p < face.corners; ++p) {
        for (int q = 0; q < face.corners; ++q) sum += shares_[kept[i]][p] * face.mass[p][q] * shares_[kept[j]][q];
      }
      areas_[kept[i]] += sum;
    }
    scale[i] = 1.0 / std::sqrt(mass[i * n + i]);
    if (!std::isfinite(scale[i])) return n == 1;
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) mass[i * n + j] *= scale[i] * scale[j];
    inverse[i * n + i] = 1.0;
  }
  const Teuchos::LAPACK<int, double> lapack;
  double ones = 0.0;
  for (int i = 0; i < n; ++i) {
    double column = 0.0;
    for (int j = 0; j < n; ++j) column += std::abs(mass[i * n + j]);
    ones = std::max(ones, column);
  }
  int info = 0;
  lapack.POTRF('U', n, mass.data(), n, &info);
  if (info != 0) return false;
  std::vector<double> work(static_cast<std::size_t>(3 * n));
  std::vector<int> integers(n);
  double condition = 0.0;
  lapack.POCON('U', n, mass.data(), n, ones, &condition, work.data(), integers.data(), &info);
  if (info != 0 || condition < singular) return false;
  lapack.POTRS('U', n, n, mass.data(), n, inverse.data(), n, &info);
  for (int i = 0; i < n; ++i) {
    for (int q = 0; q < face.corners; ++q) {
      for (int j = 0; j < n; ++j) {
        coefficients_[kept[i]][q] += areas_[kept[i]] * scale[i] * inverse[i * n + j] * scale[j] * shares_[kept[j]][q];
      }
    }
  }
  return true;
}

}  // namespace harmos::mortar
