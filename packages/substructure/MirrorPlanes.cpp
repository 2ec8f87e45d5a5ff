#include <harmos/substructure/MirrorPlanes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace harmos::substructure {
namespace {

// Of the extent of the points: how far apart mirror images may lie.
constexpr double coincide = 1e-9;
// Of the norm of the matrix: what factoring it may have left of its symmetry.
constexpr double roundOff = 1e-12;

}  // namespace

MirrorPlanes::MirrorPlanes(const std::vector<Row>& rows, const base::Matrix& matrix) : rows_(matrix.numRows()) {
  for (int axis = 0; axis < 3; ++axis) {
    Plane plane = across(axis, rows);
    if (!plane.pairs.empty() && leaves(plane, matrix)) planes_.push_back(std::move(plane));
  }
}

MirrorPlanes::Plane MirrorPlanes::across(int axis, const std::vector<Row>& rows) {
  base::Vector3 lower, upper;
  lower.fill(std::numeric_limits<double>::infinity());
  upper.fill(-std::numeric_limits<double>::infinity());
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < 3; ++c) {
      lower[c] = std::min(lower[c], row.position[c]);
      upper[c] = std::max(upper[c], row.position[c]);
    }
  }
  const auto across = static_cast<std::size_t>(axis);
  const double near = coincide * base::distance(lower, upper), twice = lower[across] + upper[across];
  // Along the first axis that lies in the plane, so that images are looked for among few.
  const std::size_t along = axis == 0 ? 1 : 0;
  std::vector<int> order(rows.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return rows[a].position[along] < rows[b].position[along]; });
  Plane plane;
  plane.isOdd.assign(rows.size(), false);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    base::Vector3 image = row.position;
    image[across] = twice - image[across];
    const double sign = row.component == axis ? -1.0 : 1.0, height = 2.0 * row.position[across] - twice;
    if (std::abs(height) <= near) {
      plane.isOdd[i] = sign < 0.0;
      continue;
    }
    auto other = std::lower_bound(order.begin(), order.end(), image[along] - near,
                                  [&](int a, double value) { return rows[a].position[along] < value; });
    const auto isImage = [&](int a) {
      return rows[a].component == row.component && base::distance(rows[a].position, image) <= near;
    };
    while (other != order.end() && rows[*other].position[along] <= image[along] + near && !isImage(*other)) ++other;
    if (other == order.end() || !isImage(*other)) return {};
    plane.isOdd[i] = height > 0.0;
    if (height < 0.0) plane.pairs.push_back({static_cast<int>(i), *other, sign});
  }
  return plane;
}

bool MirrorPlanes::leaves(const Plane& plane, const base::Matrix& matrix) {
  const int rows = matrix.numRows();
  std::vector<int> image(static_cast<std::size_t>(rows));
  std::vector<double> sign(image.size());
  for (int row = 0; row < rows; ++row) {
    image[row] = row;
    sign[row] = plane.isOdd[row] ? -1.0 : 1.0;
  }
  for (const Pair& pair : plane.pairs) {
    image[pair.first] = pair.second;
    image[pair.second] = pair.first;
    sign[pair.first] = sign[pair.second] = pair.sign;
  }
  double difference = 0.0, norm = 0.0;
  for (int j = 0; j < rows; ++j) {
    const double* mirrored = matrix[image[j]];
    for (int i = 0; i < rows; ++i) {
      const double entry = matrix[j][i], change = sign[i] * sign[j] * mirrored[image[i]] - entry;
      difference += change * change;
      norm += entry * entry;
    }
  }
  return difference <= roundOff * roundOff * norm;
}

void MirrorPlanes::change(base::Matrix& x) const {
  const double share = std::sqrt(0.5);
  for (const Plane& plane : planes_) {
    for (int j = 0; j < x.numCols(); ++j) {
      double* column = x[j];
      for (const Pair& pair : plane.pairs) {
        const double a = share * column[pair.first], b = share * pair.sign * column[pair.second];
        column[pair.first] = a + b;
        column[pair.second] = pair.sign * (a - b);
      }
    }
  }
}

std::vector<std::vector<int>> MirrorPlanes::blocks() const {
  std::vector<std::vector<int>> blocks(std::size_t{1} << planes_.size());
  for (int row = 0; row < rows_; ++row) {
    std::size_t block = 0;
    for (const Plane& plane : planes_) block = 2 * block + (plane.isOdd[row] ? 1 : 0);
    blocks[block].push_back(row);
  }
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(), [](const auto& block) { return block.empty(); }),
               blocks.end());
  return blocks;
}

}  // namespace harmos::substructure
