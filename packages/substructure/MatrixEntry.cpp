#include <harmos/substructure/MatrixEntry.hpp>

#include <algorithm>
#include <cstddef>

namespace harmos::substructure {

void addUp(std::vector<MatrixEntry>& entries) {
  const auto isBefore = [](const MatrixEntry& a, const MatrixEntry& b) {
    return a.row < b.row || (a.row == b.row && a.column < b.column);
  };
  std::stable_sort(entries.begin(), entries.end(), isBefore);
  std::size_t count = 0;
  for (const MatrixEntry& entry : entries) {
    if (count > 0 && !isBefore(entries[count - 1], entry)) {
      entries[count - 1].value += entry.value;
    } else {
      entries[count++] = entry;
    }
  }
  entries.resize(count);
}

}  // namespace harmos::substructure
