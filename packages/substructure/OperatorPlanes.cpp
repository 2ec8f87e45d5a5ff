#include <harmos/substructure/detail/OperatorPlanes.hpp>

#include <algorithm>

#include <Tpetra_CrsMatrix.hpp>

#include <harmos/substructure/detail/BoundedStiffness.hpp>

namespace harmos::substructure {
namespace {

// Operators with fewer rows are not cut into blocks: there is little to gain, and every factor costs something.
constexpr int fewRows = 300;

}  // namespace

MirrorPlanes operatorPlanes(const std::vector<base::Vector3>& nodes, const base::CrsMatrix& stiffness,
                            const BoundaryTerm& boundary, const std::vector<int>& trace) {
  const CrsView view = viewOf(stiffness, "stiffness");
  if (view.rows < fewRows || static_cast<int>(nodes.size()) * boundary.dimension != view.rows)
    return MirrorPlanes(view.rows);
  MirrorPlanes planes(nodes, boundary.dimension);
  planes.keepThoseOf(trace);
  // What is added may be far smaller than the stiffness and is compared with itself.
  if (planes.count() > 0) planes.keepThoseOf(viewOf(*addedMatrix(boundary, view.rows), "boundary term"));
  if (planes.count() > 0) planes.keepThoseOf(viewOf(*heldMatrix(boundary, view.rows), "boundary term"));
  planes.keepThoseOf(view);
  return planes;
}

std::vector<int> placesInBlock(const std::vector<int>& block, const std::vector<int>& trace,
                               const std::vector<int>& own) {
  std::vector<int> places;
  for (const int row : own)
    places.push_back(static_cast<int>(std::lower_bound(block.begin(), block.end(), trace[row]) - block.begin()));
  return places;
}

}  // namespace harmos::substructure
