#include <harmos/latin/Extrapolation.hpp>

#include <cstddef>

namespace harmos::latin {

void extrapolate(const base::Matrix& alpha, int step, const std::vector<double>& times, double* state) {
  const auto t = static_cast<std::size_t>(step);
  const double ratio = step < 2 ? 0.0 : (times[t] - times[t - 1]) / (times[t - 1] - times[t - 2]);
  for (int row = 0; row < alpha.numRows(); ++row) {
    const double last = step > 0 ? alpha[step - 1][row] : 0.0;
    state[row] = step < 2 ? last : last + ratio * (last - alpha[step - 2][row]);
  }
}

double growthAlong(const std::vector<double>& values, int step) {
  if (step == 0) return 0.0;
  const double last = values[step - 1] - (step > 1 ? values[step - 2] : 0.0);
  return last != 0.0 ? (values[step] - values[step - 1]) / last : 0.0;
}

void extrapolateAlong(const base::Matrix& alpha, int step, const std::vector<double>& values, double* state) {
  const double times = growthAlong(values, step);
  for (int row = 0; row < alpha.numRows(); ++row) {
    const double last = step > 0 ? alpha[step - 1][row] : 0.0, earlier = step > 1 ? alpha[step - 2][row] : 0.0;
    state[row] = last + times * (last - earlier);
  }
}

}  // namespace harmos::latin
