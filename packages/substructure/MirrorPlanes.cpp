#include <harmos/substructure/MirrorPlanes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace harmos::substructure {
namespace {

// Of the extent of the nodes: how far apart mirror images may lie.
constexpr double coincide = 1e-14;
// Of an entry: what adding it up may have left of its symmetry.
constexpr double roundOff = 1e-12;
// Weights of the distances along the plane and from it, by which nodes are sorted: few others have the same sum.
constexpr double alongWeights[] = {0.7548776662466927, 0.5698402909980532}, heightWeight = 0.3247179572447460;

}  // namespace

MirrorPlanes::MirrorPlanes(const std::vector<base::Vector3>& nodes, int dimension)
    : rows_(static_cast<int>(nodes.size()) * dimension) {
  for (int axis = 0; axis < dimension && !nodes.empty(); ++axis) {
    Plane plane = across(axis, nodes, dimension);
    if (plane.image.empty()) continue;
    // Images of nodes that coincide are any of them, and may not be images of each other in two planes.
    const bool commutes = std::all_of(planes_.begin(), planes_.end(), [&](const Plane& other) {
      for (int row = 0; row < rows_; ++row) {
        if (plane.image[other.image[row]] != other.image[plane.image[row]]) return false;
      }
      return true;
    });
    if (commutes) planes_.push_back(std::move(plane));
  }
}

MirrorPlanes::Plane MirrorPlanes::across(int axis, const std::vector<base::Vector3>& nodes, int dimension) {
  base::Vector3 lower = nodes.front(), upper = nodes.front();
  for (const base::Vector3& node : nodes) {
    for (std::size_t c = 0; c < 3; ++c) {
      lower[c] = std::min(lower[c], node[c]);
      upper[c] = std::max(upper[c], node[c]);
    }
  }
  const auto across = static_cast<std::size_t>(axis), first = across == 0 ? std::size_t{1} : 0,
             second = 3 - across - first;
  const double near = coincide * base::distance(lower, upper), middle = 0.5 * (lower[across] + upper[across]);
  std::vector<std::pair<double, int>> order;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const double key = alongWeights[0] * (nodes[a][first] - lower[first]) +
                       alongWeights[1] * (nodes[a][second] - lower[second]) +
                       heightWeight * std::abs(nodes[a][across] - middle);
    order.emplace_back(key, static_cast<int>(a));
  }
  std::sort(order.begin(), order.end());
  std::vector<int> image(nodes.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int a = order[i].second;
    const double height = nodes[a][across] - middle;
    if (std::abs(height) <= near) image[a] = a;
    if (image[a] >= 0) continue;
    base::Vector3 mirrored = nodes[a];
    mirrored[across] = middle - height;
    for (std::size_t j = i + 1; j < order.size() && order[j].first <= order[i].first + 4.0 * near; ++j) {
      const int b = order[j].second;
      if (image[b] >= 0 || base::distance(nodes[b], mirrored) > near) continue;
      image[a] = b;
      image[b] = a;
      break;
    }
    if (image[a] < 0) return {};
  }
  Plane plane;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const bool isOn = image[a] == static_cast<int>(a);
    for (int c = 0; c < dimension; ++c) {
      plane.image.push_back(image[a] * dimension + c);
      plane.turns.push_back(c == axis);
      plane.isOdd.push_back(isOn ? c == axis : nodes[a][across] > middle);
    }
  }
  return plane;
}

bool MirrorPlanes::leaves(const Plane& plane, const CrsView& matrix) {
  std::vector<double> size, mirrored(static_cast<std::size_t>(matrix.rows), 0.0);
  for (int row = 0; row < matrix.rows; ++row) {
    const std::size_t at = matrix.positionOf(row, row);
    size.push_back(at == matrix.rowPointers[matrix.rows] ? 0.0 : std::sqrt(matrix.values[at]));
  }
  for (int row = 0; row < matrix.rows; ++row) {
    const int image = plane.image[row];
    if (image < row) continue;
    const std::size_t begin = matrix.rowPointers[image], end = matrix.rowPointers[image + 1];
    for (std::size_t k = begin; k < end; ++k) mirrored[matrix.columns[k]] = matrix.values[k];
    bool isSame = true;
    for (std::size_t k = matrix.rowPointers[row]; k < matrix.rowPointers[row + 1]; ++k) {
      const int column = matrix.columns[k];
      double& entry = mirrored[plane.image[column]];
      const double difference = plane.sign(row) * plane.sign(column) * entry - matrix.values[k];
      isSame = isSame && std::abs(difference) <= roundOff * size[row] * size[column];
      entry = 0.0;
    }
    for (std::size_t k = begin; k < end; ++k) {
      double& entry = mirrored[matrix.columns[k]];
      isSame = isSame && std::abs(entry) <= roundOff * size[image] * size[matrix.columns[k]];
      entry = 0.0;
    }
    if (!isSame) return false;
  }
  return true;
}

void MirrorPlanes::keepThoseOf(const CrsView& matrix) {
  planes_.erase(
      std::remove_if(planes_.begin(), planes_.end(), [&](const Plane& plane) { return !leaves(plane, matrix); }),
      planes_.end());
}

void MirrorPlanes::keepThoseOf(const std::vector<int>& rows) {
  const auto isAmong = [&rows](int row) { return std::binary_search(rows.begin(), rows.end(), row); };
  planes_.erase(std::remove_if(planes_.begin(), planes_.end(),
                               [&](const Plane& plane) {
                                 return !std::all_of(rows.begin(), rows.end(),
                                                     [&](int row) { return isAmong(plane.image[row]); });
                               }),
                planes_.end());
}

MirrorPlanes MirrorPlanes::restrictedTo(const std::vector<int>& rows) const {
  MirrorPlanes result(static_cast<int>(rows.size()));
  for (const Plane& plane : planes_) {
    Plane part;
    for (const int row : rows) {
      const auto image = std::lower_bound(rows.begin(), rows.end(), plane.image[row]);
      part.image.push_back(static_cast<int>(image - rows.begin()));
      part.turns.push_back(plane.turns[row]);
      part.isOdd.push_back(plane.isOdd[row]);
    }
    result.planes_.push_back(std::move(part));
  }
  return result;
}

void MirrorPlanes::change(base::Matrix& x) const {
  const double share = std::sqrt(0.5);
  for (const Plane& plane : planes_) {
    for (int j = 0; j < x.numCols(); ++j) {
      double* column = x[j];
      for (int row = 0; row < rows_; ++row) {
        if (plane.isOdd[row] || plane.isOn(row)) continue;
        double& other = column[plane.image[row]];
        const double sign = plane.sign(row), a = share * column[row], b = share * sign * other;
        column[row] = a + b;
        other = sign * (a - b);
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
  return blocks;
}

MirrorPlanes::Share MirrorPlanes::shareIn(int member, int row) const {
  Share share{row, 1.0};
  for (const Plane& plane : planes_) {
    const bool isOdd = plane.isOdd[member];
    if (plane.isOn(row)) {
      if (plane.isOdd[row] != isOdd) return {-1, 0.0};
      continue;
    }
    share.factor *= std::sqrt(0.5);
    if (plane.isOdd[row] != isOdd) {
      share.column = plane.image[share.column];
      share.factor *= plane.sign(row);
    } else if (isOdd) {
      share.factor = -share.factor;
    }
  }
  return share;
}

std::vector<int> MirrorPlanes::imagesOf(int row) const {
  std::vector<int> images{row};
  for (const Plane& plane : planes_) {
    const std::size_t known = plane.isOn(row) ? 0 : images.size();
    for (std::size_t i = 0; i < known; ++i) images.push_back(plane.image[images[i]]);
  }
  return images;
}

Teuchos::RCP<base::CrsMatrix> MirrorPlanes::blockOf(const CrsView& matrix, const std::vector<int>& block) const {
  const std::size_t count = block.size();
  std::vector<int> number(static_cast<std::size_t>(rows_), -1);
  for (std::size_t i = 0; i < count; ++i) number[block[i]] = static_cast<int>(i);
  std::vector<Share> shares;
  for (int row = 0; row < rows_; ++row) {
    shares.push_back(shareIn(block.front(), row));
    if (shares.back().column >= 0) shares.back().column = number[shares.back().column];
  }
  // Entries are sums over all images of a row. One of them would do for a matrix that is its own mirror image to the
  // last digit; of others the sum keeps the symmetry, and the rigid motions without forces. Columns are met in any
  // order: as the block is symmetric, its transpose has them ascending.
  std::vector<std::size_t> begin(count + 1, 0);
  std::vector<int> columns, place(count, -1);
  std::vector<double> values;
  const std::size_t room = (matrix.rowPointers[rows_] >> planes_.size()) * 5 / 4;  // about as many, and those at planes
  columns.reserve(room);
  values.reserve(room);
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = columns.size();
    for (const int row : imagesOf(block[i])) {
      for (std::size_t k = matrix.rowPointers[row]; k < matrix.rowPointers[row + 1]; ++k) {
        const Share& share = shares[matrix.columns[k]];
        if (share.column < 0) continue;
        int& at = place[share.column];
        if (at < static_cast<int>(first)) {
          at = static_cast<int>(columns.size());
          columns.push_back(share.column);
          values.push_back(0.0);
          ++begin[static_cast<std::size_t>(share.column) + 1];
        }
        values[at] += shares[row].factor * share.factor * matrix.values[k];
      }
    }
    ends.push_back(columns.size());
  }
  for (std::size_t i = 0; i < count; ++i) begin[i + 1] += begin[i];
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  CrsRows sorted(begin);
  int* const ascending = sorted.columns();
  double* const value = sorted.values();
  for (std::size_t i = 0, k = 0; i < count; ++i) {
    for (; k < ends[i]; ++k) {
      const std::size_t at = next[columns[k]]++;
      ascending[at] = static_cast<int>(i);
      value[at] = values[k];
    }
  }
  return makeCrsMatrix(std::move(sorted));
}

}  // namespace harmos::substructure
