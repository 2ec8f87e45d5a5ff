#include <harmos/latin/TangentSpace.hpp>

#include <algorithm>

namespace harmos::latin {

void TangentSpace::append(int first) {
  const int count = space_.size() - first;
  if (count == 0) return;
  const int rows = space_.rows();
  base::Matrix y(rows, count), g(rows, count);
  for (int j = 0; j < count; ++j) std::copy_n(space_.image(first + j), rows, y[j]);
  tangents_.apply(y, g);
  for (int j = 0; j < count; ++j) {
    const double* v = space_.direction(first + j);
    for (int row = 0; row < rows; ++row) g[j][row] = (1.0 + shift_) * v[row] + y[j][row] - 2.0 * g[j][row];
  }
  fixedPoint_.linearStage().unfelt().remove(g);
  space_.append(g);
}

void TangentSpace::differentiate(int column, PointwiseLocalStage& local, double shift) {
  shift_ = shift;
  local.differentiateColumn(column, tangents_);
  space_.forgetTangent();
  append(0);
}

void TangentSpace::restore() {
  if (!space_.isReleased()) return;
  space_.forgetTangent();
  append(0);
}

void TangentSpace::add(const double* v, const double* y, bool isCurrent) {
  space_.add(v, y);
  if (isCurrent) append(space_.size() - 1);
}

bool TangentSpace::continueKrylov(std::vector<double>& v) const {
  if (space_.size() == 0) return false;
  const int rows = space_.rows();
  base::Matrix y(rows, 1), moved(rows, 1);
  std::copy_n(space_.image(space_.size() - 1), rows, y[0]);
  tangents_.apply(y, moved);
  for (int row = 0; row < rows; ++row) y[0][row] = 2.0 * moved[0][row] - y[0][row];
  fixedPoint_.linearStage().unfelt().remove(y);
  std::copy_n(y[0], rows, v.begin());
  return space_.makeIndependent(v.data());
}

void TangentSpace::subtract(const std::vector<double>& c, std::vector<double>& residual) const {
  const int rows = space_.rows();
  base::Matrix v(rows, 1), y(rows, 1), moved(rows, 1);
  space_.move(c, 1.0, v[0], y[0]);
  tangents_.apply(y, moved);
  for (int row = 0; row < rows; ++row) v[0][row] = (1.0 + shift_) * v[0][row] + (y[0][row] - 2.0 * moved[0][row]);
  fixedPoint_.linearStage().unfelt().remove(v);
  for (int row = 0; row < rows; ++row) residual[row] -= v[0][row];
}

}  // namespace harmos::latin
