#include <harmos/substructure/NestedDissection.hpp>

#include <algorithm>
#include <string>

#include <metis.h>

#include <harmos/base/Error.hpp>

namespace harmos::substructure {
namespace {

// Of a block: the components of a node in space.
constexpr int mostRows = 3;

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

/// Where blocks of equal structure begin, and the number of rows.
std::vector<int> blocksOf(int rows, const std::size_t* rowPointers, const int* columns) {
  std::vector<int> first;
  for (const int size : {3, 2}) {
    if (!haveBlocksOf(size, rows, rowPointers, columns)) continue;
    for (int row = 0; row <= rows; row += size) first.push_back(row);
    return first;
  }
  const auto isAsTheOneBefore = [&](int row) {
    const int *before = columns + rowPointers[row - 1], *here = columns + rowPointers[row];
    return std::equal(before, here, here, columns + rowPointers[row + 1]);
  };
  for (int row = 0; row < rows; ++row) {
    if (first.empty() || row - first.back() == mostRows || !isAsTheOneBefore(row)) first.push_back(row);
  }
  first.push_back(rows);
  return first;
}

}  // namespace

NestedDissection::NestedDissection(int rows, const std::size_t* rowPointers, const int* columns,
                                   const std::vector<int>& last) {
  firstRow_ = blocksOf(rows, rowPointers, columns);
  const int count = static_cast<int>(firstRow_.size()) - 1;
  std::vector<int> blockOf;
  for (int block = 0; block < count; ++block) blockOf.insert(blockOf.end(), sizeOf(block), block);
  pointers_.assign(1, 0);
  pointers_.reserve(static_cast<std::size_t>(count) + 1);
  neighbours_.reserve(rows == 0 ? 0 : rowPointers[rows] * static_cast<std::size_t>(count) / rows);
  for (int block = 0; block < count; ++block) {
    const int row = firstRow_[block];
    for (std::size_t k = rowPointers[row]; k < rowPointers[row + 1]; ++k) {
      const int neighbour = blockOf[columns[k]];
      const bool isKnown = static_cast<int>(neighbours_.size()) > pointers_.back() && neighbours_.back() == neighbour;
      if (neighbour != block && !isKnown) neighbours_.push_back(neighbour);
    }
    pointers_.push_back(static_cast<int>(neighbours_.size()));
  }

  std::vector<bool> isLast(count, false);
  for (const int row : last) isLast[blockOf[row]] = true;
  std::vector<int> first;
  for (int block = 0; block < count; ++block) {
    if (!isLast[block]) first.push_back(block);
  }
  order(first);
  for (int block = 0; block < count; ++block) {
    if (isLast[block]) blocks_.old.push_back(block);
  }
  blocks_.position.resize(count);
  for (int position = 0; position < count; ++position) {
    blocks_.position[blocks_.old[position]] = position;
  }

  const auto append = [&](int block, bool trailing) {
    for (int row = firstRow_[block]; row < firstRow_[block + 1]; ++row) {
      if (std::binary_search(last.begin(), last.end(), row) == trailing) ordering_.old.push_back(row);
    }
  };
  ordering_.old.reserve(rows);
  for (const int block : blocks_.old) append(block, false);
  for (const int block : blocks_.old) append(block, true);
  ordering_.position.resize(rows);
  for (int position = 0; position < rows; ++position) {
    ordering_.position[ordering_.old[position]] = position;
  }
}

/// Appends the blocks, in the order that METIS gives the graph between them.
void NestedDissection::order(const std::vector<int>& blocks) {
  static_assert(sizeof(idx_t) == sizeof(int), "METIS must be built with 32-bit indices");
  std::vector<int> number(pointers_.size() - 1, -1);
  for (std::size_t i = 0; i < blocks.size(); ++i) number[blocks[i]] = static_cast<int>(i);
  std::vector<int> pointers{0};
  std::vector<int> neighbours;
  neighbours.reserve(neighbours_.size());
  for (const int block : blocks) {
    const auto at = static_cast<std::size_t>(block);
    for (int k = pointers_[at]; k < pointers_[at + 1]; ++k) {
      const int other = number[neighbours_[k]];
      if (other >= 0) neighbours.push_back(other);
    }
    pointers.push_back(static_cast<int>(neighbours.size()));
  }
  if (neighbours.empty()) {  // METIS refuses graphs without edges
    blocks_.old = blocks;
    return;
  }
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 0;
  auto vertices = static_cast<idx_t>(blocks.size());
  std::vector<idx_t> weights;
  for (const int block : blocks) weights.push_back(sizeOf(block));
  const bool areAlike = std::all_of(weights.begin(), weights.end(), [&](idx_t w) { return w == weights.front(); });
  std::vector<int> old(blocks.size()), position(blocks.size());
  const int status = METIS_NodeND(&vertices, pointers.data(), neighbours.data(), areAlike ? nullptr : weights.data(),
                                  options, old.data(), position.data());
  if (status != METIS_OK) {
    throw base::Error("METIS could not order a matrix of " + std::to_string(firstRow_.back()) + " rows.");
  }
  for (const int at : old) blocks_.old.push_back(blocks[at]);
}

/// Column counts of L by walking the row subtrees of the elimination tree: Liu, SIAM J. Matrix Anal. Appl. 11 (1990).
FactorSize NestedDissection::factorSize() const {
  const std::size_t count = blocks_.old.size();
  std::vector<int> parent(count, -1), visited(count, -1), below(count, 0);
  for (int row = 0; row < static_cast<int>(count); ++row) {
    const auto old = static_cast<std::size_t>(blocks_.old[row]);
    visited[row] = row;
    for (int k = pointers_[old]; k < pointers_[old + 1]; ++k) {
      int column = blocks_.position[neighbours_[k]];
      if (column > row) continue;
      for (; visited[column] != row; column = parent[column]) {
        visited[column] = row;
        below[column] += sizeOf(blocks_.old[row]);
        if (parent[column] < 0) parent[column] = row;
      }
    }
  }
  FactorSize size;
  for (std::size_t position = 0; position < count; ++position) {
    for (int own = sizeOf(blocks_.old[position]); own > 0; --own) {
      const double length = double(below[position]) + own;
      size.nonzeros += length;
      size.operations += length * length;
    }
  }
  size.bytes = size.nonzeros * sizeof(double);
  return size;
}

}  // namespace harmos::substructure
