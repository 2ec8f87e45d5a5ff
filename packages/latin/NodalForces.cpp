#include <harmos/latin/NodalForces.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::latin {

base::Matrix nodalForces(const TraceLayout& layout, const base::Matrix& traction) {
  const int dimension = layout.dimension();
  std::vector<double> area(layout.nodes(), 0.0);
  const mesh::TraceOperator& trace = layout.trace();
  for (int p = 0; p < trace.points(); ++p) {
    for (const auto& [node, weight] : trace.row(p)) area[node] += std::abs(weight) * layout.area()[p * dimension];
  }
  base::Matrix forces(std::max(1, layout.nodes() * dimension), traction.numCols());
  for (int t = 0; t < traction.numCols(); ++t) {
    for (int p = 0; p < trace.points(); ++p) {
      for (const auto& [node, weight] : trace.row(p)) {
        const double scale = area[node] > 0.0 ? weight / std::sqrt(area[node]) : 0.0;
        for (int c = 0; c < dimension; ++c) {
          const int row = p * dimension + c;
          forces[t][node * dimension + c] += scale * layout.area()[row] * traction[t][row];
        }
      }
    }
  }
  return forces;
}

}  // namespace harmos::latin
