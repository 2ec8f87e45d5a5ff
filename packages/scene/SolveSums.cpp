#include <harmos/scene/detail/SolveSums.hpp>

#include <vector>

#include <Teuchos_CommHelpers.hpp>

namespace harmos::scene {
namespace {

// Seconds per entry of a factor, through which a solve goes twice: of whole bodies, where each of their unknowns takes
// a time of its own besides; the same in single precision, also of a trace; of dense traces, per entry of their square;
// of inverted ones, per entry of a triangle.
constexpr SolveSeconds ofWhole{7.5e-10, 1.4e-9, 1.05e-10}, ofSingle{2.9e-10, 1e-9, 5.5e-11},
    ofDense{3.8e-10, 9e-10, 5.5e-11}, ofUnknown{8e-8, 8e-8, 0.0}, ofInverse{2.2e-10, 0.0, 2.2e-10};

}  // namespace

void SolveSums::add(Kind kind, double entries, double unknowns, bool isFirst) {
  Size& size = size_[kind];
  size.entries += entries;
  size.read += isFirst ? entries : 0.0;
  size.unknowns += unknowns;
}

void SolveSums::reduce(const Teuchos::Comm<int>& comm) {
  std::vector<double> mine;
  for (const Size& size : size_) mine.insert(mine.end(), {size.entries, size.read, size.unknowns});
  std::vector<double> all(mine.size(), 0.0);
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  auto from = all.begin();
  for (Size& size : size_) {
    for (double* to : {&size.entries, &size.read, &size.unknowns}) *to = *from++;
  }
}

SolveSeconds SolveSums::times(const Size& size, const SolveSeconds& rate) {
  return {size.entries * rate.alone, size.read * rate.first, size.entries * rate.further};
}

SolveSeconds SolveSums::ofBodies(Kind kind) const {
  return times(size_[kind], ofWhole) + size_[kind].unknowns * ofUnknown;
}

SolveSeconds SolveSums::ofBodiesInSingle(Kind kind) const {
  return ofTracesInSingle(kind) + size_[kind].unknowns * ofUnknown;
}

SolveSeconds SolveSums::ofTracesInSingle(Kind kind) const {
  return times(size_[kind], ofSingle);
}

SolveSeconds SolveSums::ofDenseTraces() const {
  return times(size_[traces], ofDense) + times(size_[inverses], ofInverse);
}

}  // namespace harmos::scene
