#include <harmos/substructure/NestedDissection.hpp>

#include <algorithm>
#include <string>

#include <metis.h>

#include <harmos/base/Error.hpp>

namespace harmos::substructure {
namespace {

bool haveBlocksOf(int size, int rows, const std::size_t* rowPointers, const int* columns) {
  if (rows % size != 0) return false;
  for (int first = 0; first < rows; first += size) {
    const std::size_t length = rowPointers[first + 1] - rowPointers[first];
    if (length % static_cast<std::size_t>(size) != 0) return false;
    for (int row = first + 1; row < first + size; ++row) {
      if (rowPointers[row + 1] - rowPointers[row] != length ||
          !std::equal(columns + rowPointers[row], columns + rowPointers[row + 1], columns + rowPointers[first])) {
        return false;
      }
    }
    for (std::size_t k = rowPointers[first]; k < rowPointers[first + 1]; k += static_cast<std::size_t>(size)) {
      if (columns[k] % size != 0 || columns[k + static_cast<std::size_t>(size) - 1] != columns[k] + size - 1) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

NestedDissection::NestedDissection(int rows, const std::size_t* rowPointers, const int* columns) {
  if (haveBlocksOf(3, rows, rowPointers, columns)) {
    blockSize_ = 3;
  } else if (haveBlocksOf(2, rows, rowPointers, columns)) {
    blockSize_ = 2;
  }
  const int count = rows / blockSize_;
  pointers_.assign(1, 0);
  pointers_.reserve(static_cast<std::size_t>(count) + 1);
  neighbours_.reserve(rowPointers[rows] / static_cast<std::size_t>(blockSize_ * blockSize_));
  for (int block = 0; block < count; ++block) {
    const int row = block * blockSize_;
    for (std::size_t k = rowPointers[row]; k < rowPointers[row + 1]; k += static_cast<std::size_t>(blockSize_)) {
      const int neighbour = columns[k] / blockSize_;
      if (neighbour != block) neighbours_.push_back(neighbour);
    }
    pointers_.push_back(static_cast<int>(neighbours_.size()));
  }

  blocks_.old.resize(static_cast<std::size_t>(count));
  blocks_.position.resize(static_cast<std::size_t>(count));
  if (neighbours_.empty()) {  // METIS refuses graphs without edges
    for (int block = 0; block < count; ++block) {
      blocks_.old[static_cast<std::size_t>(block)] = blocks_.position[static_cast<std::size_t>(block)] = block;
    }
  } else {
    static_assert(sizeof(idx_t) == sizeof(int), "METIS must be built with 32-bit indices");
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 0;
    idx_t vertices = count;
    const int status = METIS_NodeND(&vertices, pointers_.data(), neighbours_.data(), nullptr, options,
                                    blocks_.old.data(), blocks_.position.data());
    if (status != METIS_OK) throw base::Error("METIS could not order a matrix of " + std::to_string(rows) + " rows.");
  }

  ordering_.old.resize(static_cast<std::size_t>(rows));
  ordering_.position.resize(static_cast<std::size_t>(rows));
  for (int position = 0; position < rows; ++position) {
    const int old = blocks_.old[static_cast<std::size_t>(position / blockSize_)] * blockSize_ + position % blockSize_;
    ordering_.old[static_cast<std::size_t>(position)] = old;
    ordering_.position[static_cast<std::size_t>(old)] = position;
  }
}

/// Column counts of L by walking the row subtrees of the elimination tree: Liu, SIAM J. Matrix Anal. Appl. 11 (1990).
FactorSize NestedDissection::factorSize() const {
  const std::size_t count = blocks_.old.size();
  std::vector<int> parent(count, -1), visited(count, -1), below(count, 0);
  for (int row = 0; row < static_cast<int>(count); ++row) {
    const auto old = static_cast<std::size_t>(blocks_.old[static_cast<std::size_t>(row)]);
    visited[static_cast<std::size_t>(row)] = row;
    for (int k = pointers_[old]; k < pointers_[old + 1]; ++k) {
      int column = blocks_.position[static_cast<std::size_t>(neighbours_[static_cast<std::size_t>(k)])];
      if (column > row) continue;
      for (; visited[static_cast<std::size_t>(column)] != row; column = parent[static_cast<std::size_t>(column)]) {
        visited[static_cast<std::size_t>(column)] = row;
        ++below[static_cast<std::size_t>(column)];
        if (parent[static_cast<std::size_t>(column)] < 0) parent[static_cast<std::size_t>(column)] = row;
      }
    }
  }
  FactorSize size;
  for (const int blocksBelow : below) {
    for (int within = 0; within < blockSize_; ++within) {
      const double length = double(blockSize_) * blocksBelow + blockSize_ - within;
      size.nonzeros += length;
      size.operations += length * length;
    }
  }
  size.bytes = size.nonzeros * sizeof(double);
  return size;
}

}  // namespace harmos::substructure
