#include <harmos/substructure/BoundaryTerm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace harmos::substructure {
namespace {

// Relative difference of the entries of two operators that is round-off.
constexpr double roundOff = 1e-10;

bool areEqual(const std::vector<BoundaryTerm::NodeTensor>& a, const std::vector<BoundaryTerm::NodeTensor>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double size = base::distance(a[i].value, {});
    if (a[i].node != b[i].node || base::distance(a[i].value, b[i].value) > roundOff * size) return false;
  }
  return true;
}

}  // namespace

void arrange(BoundaryTerm& term) {
  std::sort(term.entries.begin(), term.entries.end(), [](const MatrixEntry& a, const MatrixEntry& b) {
    return std::tie(a.row, a.column, a.value) < std::tie(b.row, b.column, b.value);
  });
  addUp(term.entries);
  for (auto* tensors : {&term.springs, &term.free}) {
    std::sort(tensors->begin(), tensors->end(), [](const auto& a, const auto& b) { return a.node < b.node; });
  }
}

bool areEqual(const BoundaryTerm& first, const BoundaryTerm& second) {
  if (first.entries.size() != second.entries.size()) return false;
  for (std::size_t i = 0; i < second.entries.size(); ++i) {
    const MatrixEntry &a = first.entries[i], &b = second.entries[i];
    if (a.row != b.row || a.column != b.column || std::abs(a.value - b.value) > roundOff * std::abs(a.value)) {
      return false;
    }
  }
  for (std::size_t i = 0; i < second.diagonal.size(); ++i) {
    if (std::abs(first.diagonal[i] - second.diagonal[i]) > roundOff * first.diagonal[i]) return false;
  }
  return areEqual(first.springs, second.springs) && areEqual(first.free, second.free);
}

}  // namespace harmos::substructure
