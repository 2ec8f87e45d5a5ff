#include <harmos/latin/NodalForces.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::latin {

base::Matrix nodalForces(const TraceLayout& layout, const base::Matrix& traction) {
  const int dimension = layout.dimension();
  std::vector<double> area(layout.nodes(), 0.0);
  for (std::size_t i = 0; i < layout.nodeOf().size(); ++i) {
    area[layout.nodeOf()[i]] += layout.area()[i * static_cast<std::size_t>(dimension)];
  }
  base::Matrix forces(std::max(1, layout.nodes() * dimension), traction.numCols());
  for (int t = 0; t < traction.numCols(); ++t) {
    for (std::size_t i = 0; i < layout.nodeOf().size(); ++i) {
      const int node = layout.nodeOf()[i];
      const double scale = 1.0 / std::sqrt(area[node]);
      for (int c = 0; c < dimension; ++c) {
        const int row = static_cast<int>(i) * dimension + c;
        forces[t][node * dimension + c] += scale * layout.area()[row] * traction[t][row];
      }
    }
  }
  return forces;
}

}  // namespace harmos::latin
