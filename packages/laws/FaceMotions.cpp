#include <harmos/laws/FaceMotions.hpp>

#include <cmath>
#include <vector>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Matrix.hpp>

namespace harmos::laws {
namespace {

// Smallest over largest eigenvalue of G, with rotations in the radius of the face, below which a motion is not seen.
constexpr double unseen = 1e-10;

}  // namespace

std::optional<FaceMotions> FaceMotions::of(const std::vector<std::pair<base::Vector3, double>>& points, int dimension) {
  FaceMotions motions;
  double area = 0.0, squared = 0.0;
  for (const auto& [place, h] : points) {
    area += h;
    motions.centre_ = motions.centre_ + h * place;
  }
  if (!(area > 0.0)) return std::nullopt;
  motions.centre_ = (1.0 / area) * motions.centre_;
  for (const auto& [place, h] : points) squared += h * base::dot(place - motions.centre_, place - motions.centre_);
  if (!(squared > 0.0)) return std::nullopt;
  const double radius = std::sqrt(squared / area);
  const std::vector<std::size_t> used =
      dimension == 2 ? std::vector<std::size_t>{0, 1, 5} : std::vector<std::size_t>{0, 1, 2, 3, 4, 5};
  const auto scale = [&](std::size_t i) { return i < 3 ? 1.0 : radius; };
  const int size = static_cast<int>(used.size());
  base::Matrix gram(size, size);
  for (int j = 0; j < size; ++j) {
    Six unit{};
    unit[used[j]] = 1.0;
    Six sums{};
    for (const auto& [place, h] : points) motions.addProjection(place, h * motions.at(unit, place), sums);
    for (int i = 0; i < size; ++i) gram(i, j) = sums[used[i]] / (area * scale(used[i]) * scale(used[j]));
  }
  std::vector<double> values(size), work(static_cast<std::size_t>(8 * size));
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', size, gram.values(), gram.stride(), values.data(), work.data(),
                                      static_cast<int>(work.size()), &info);
  if (info != 0 || values.front() <= unseen * values.back()) return std::nullopt;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      double sum = 0.0;
      for (int k = 0; k < size; ++k) sum += gram(i, k) * gram(j, k) / values[k];
      motions.inverse_[used[i]][used[j]] = sum / (area * scale(used[i]) * scale(used[j]));
    }
  }
  return motions;
}

std::vector<int> FaceMotions::components() const {
  std::vector<int> result;
  for (std::size_t i = 0; i < 6; ++i) {
    if (inverse_[i][i] > 0.0) result.push_back(static_cast<int>(i));
  }
  return result;
}

base::Vector3 FaceMotions::at(const Six& motion, const base::Vector3& place) const {
  return base::Vector3{motion[0], motion[1], motion[2]} +
         base::cross({motion[3], motion[4], motion[5]}, place - centre_);
}

void FaceMotions::addProjection(const base::Vector3& place, const base::Vector3& v, Six& sums) const {
  const base::Vector3 moment = base::cross(place - centre_, v);
  for (std::size_t i = 0; i < 3; ++i) {
    sums[i] += v[i];
    sums[i + 3] += moment[i];
  }
}

FaceMotions::Six FaceMotions::divided(const Six& x) const {
  Six result{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) result[i] += inverse_[i][j] * x[j];
  }
  return result;
}

FaceMotions::Six FaceMotions::fromPoint(const base::Vector3& point, const Six& resultant) const {
  const base::Vector3 moment = base::cross(point - centre_, {resultant[0], resultant[1], resultant[2]});
  Six result(resultant);
  for (std::size_t i = 0; i < 3; ++i) result[i + 3] += moment[i];
  return result;
}

}  // namespace harmos::laws
