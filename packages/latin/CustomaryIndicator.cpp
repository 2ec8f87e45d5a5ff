#include <cmath>
#include <vector>

#include <harmos/latin/detail/CustomaryIndicator.hpp>

namespace harmos::latin {

double customaryIndicator(const Iterate& state) {
  const std::vector<double>& area = state.layout().area();
  const std::vector<double>& k = state.layout().stiffness();
  std::vector<double> sums(2, 0.0);
  for (int t = 0; t < state.assembly().steps(); ++t) {
    for (std::size_t row = 0; row < area.size(); ++row) {
      const double f = state.traction()[t][row];
      const double w = state.trace()[t][row];
      const double df = f - state.hattedTraction()[t][row];
      const double dw = state.relativeTrace()[t][row] - state.relativeHattedTrace(static_cast<int>(row), t);
      sums[0] += area[row] * (df * df / k[row] + k[row] * dw * dw);
      sums[1] += area[row] * (f * f / k[row] + k[row] * w * w);
    }
  }
  state.metric().sum(sums);
  return sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : 0.0;
}

}  // namespace harmos::latin
