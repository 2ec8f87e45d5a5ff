#include <harmos/scene/detail/StaticsCost.hpp>

#include <algorithm>

#include <harmos/base/Timers.hpp>
#include <harmos/latin/LoadBalance.hpp>
#include <harmos/laws/FaceLaw.hpp>

namespace harmos::scene {
namespace {

// Seconds: of a column of a programme that a pivot is priced with; of a joint of a load step, which is made for the
// programme, and looked at once more when the states of the pairs are known.
constexpr double pivotSeconds = 1.5e-8, jointSeconds = 1e-6;
// Pivots of a programme: one for every row of a few, where each finds its place at once; as many more as there are rows
// of so many.
constexpr double rowsThatDouble = 150.0;
// Rays that stand for a cone of friction, in the plane and in space.
constexpr double raysOfCone[] = {2.0, 4.0};

/// What may be chosen at a pair.
double columnsOf(const laws::AdmissibleTractions& tractions, int dimension) {
  double columns = 0.0;
  const bool slides = tractions.friction > 0.0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension); ++c) {
    const bool isCone = slides && c == 0;
    if (isCone) columns += raysOfCone[dimension - 2];
    if (isCone ? tractions.upper[0] > 0.0 : tractions.lower[c] < 0.0 || tractions.upper[c] > 0.0) columns += 1.0;
  }
  return columns;
}

}  // namespace

double StaticsSize::seconds(double steps) const {
  const double pivots = rows * (1.0 + rows / rowsThatDouble);
  return jointSeconds * joints * steps + pivotSeconds * programmes * pivots * columns;
}

StaticsSize staticsOf(const assembly::Assembly& assembly, const Teuchos::Comm<int>& comm) {
  base::Timers timers;
  const latin::LoadBalance balance(assembly, comm, timers);
  const std::vector<int>& bodies = balance.rigidBodies();
  StaticsSize size;
  const int count = bodies.empty() ? 0 : 1 + *std::max_element(bodies.begin(), bodies.end());
  size.rows = static_cast<double>(count) * (assembly.dimension == 2 ? 3.0 : 6.0);
  if (count == 0) return size;
  for (const assembly::Interface& interface : assembly.interfaces) {
    const int first = bodies[interface.body1], second = interface.sides() == 2 ? bodies[interface.body2] : -1;
    const auto* ofFace = dynamic_cast<const laws::FaceLaw*>(interface.law.get());
    const bool isCoupling = ofFace != nullptr && ofFace->resultants(0);  // a few columns for all of the face
    if (interface.law->prescribesTraction() || isCoupling || first == second) continue;
    const auto tractions = interface.law->admissibleTractions(0).value_or(laws::AdmissibleTractions{});
    size.joints += interface.pairs();
    size.columns += interface.pairs() * columnsOf(tractions, assembly.dimension);
  }
  size.columns += 2.0 * size.rows;  // what is left over, of either sign
  for (int t = 0; t < assembly.steps(); ++t) size.programmes += balance.largestLike(t) == t ? 1.0 : 0.0;
  return size;
}

}  // namespace harmos::scene
