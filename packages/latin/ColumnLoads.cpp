#include <harmos/latin/detail/ColumnLoads.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/latin/detail/IsZero.hpp>
#include <harmos/latin/detail/LargestOf.hpp>

namespace harmos::latin {
void ColumnLoads::set(base::Matrix& loads, const base::Matrix& held) {
  const int columns = loads.numCols();
  const bool areNone = isZero(loads);
  const bool areSame =
      areKnown_ && count_ == columns && held_ == held && (areNone ? given().numCols() == 0 : given() == loads);
  if (areSame) return;
  ++changes_;
  areKnown_ = false;
  count_ = columns;
  held_ = held;
  const std::vector<int>& heldDofs = operator_.heldDofs();
  if (!heldDofs.empty()) {
    atHeldDofs_.shape(static_cast<int>(heldDofs.size()), columns);
    for (int j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < heldDofs.size(); ++i) atHeldDofs_[j][i] = loads[j][heldDofs[i]];
    }
  }
  for (base::Matrix* field : {&projected_, &motions_, &traceMotions_, &given_}) *field = base::Matrix();
  const bool isHeldAway = held_.numCols() > 0;
  if (!areNone && isHeld()) given_ = loads;
  areKnown_ = areNone && !isHeldAway;
  if (areKnown_) return;
  projected_.swap(loads);
  if (isHeldAway) subtractHeldForces();
  operator_.project(projected_);
  if (solver_.solvesTrace()) {
    motions_.shape(solver_.dofs(), columns);
    if (projected_.normInf() > 0.0) {
      solveInWindows([this](int first, const base::Matrix& solution) {
        std::copy_n(solution.values(), static_cast<std::size_t>(solution.numRows()) * solution.numCols(),
                    motions_[first]);
      });
    }
    if (isHeldAway) motions_ += held_;
  }
  areKnown_ = true;
}

void ColumnLoads::solveInWindows(const std::function<void(int, const base::Matrix&)>& keep) const {
  base::Matrix solution;
  for (int first = 0; first < count_; first += stepsAtOnce) {
    const int columns = std::min(stepsAtOnce, count_ - first);
    solver_.solve(base::Matrix(Teuchos::View, projected_, projected_.numRows(), columns, 0, first), solution);
    keep(first, solution);
  }
}

void ColumnLoads::subtractHeldForces() {
  std::vector<int> all(solver_.dofs());
  std::iota(all.begin(), all.end(), 0);
  std::vector<double> product(all.size());
  for (int j = 0; j < projected_.numCols(); ++j) {
    operator_.multiply(held_[j], all, product.data());
    for (std::size_t i = 0; i < all.size(); ++i) projected_[j][i] -= product[i];
  }
}

void ColumnLoads::select(std::vector<int> loadOf) {
  loadOf_ = std::move(loadOf);
  unitOf_.assign(loadOf_.size(), 0);
  factor_.assign(loadOf_.size(), 0.0);
}

void ColumnLoads::addUnit(int column, int member, double factor) {
  unitOf_[column] = member;
  factor_[column] = factor;
}

void ColumnLoads::add(const base::Matrix& field, int column, double* to, double times) const {
  if (field.numCols() == 0) return;
  const auto addColumn = [&](int load, double factor) {
    for (int row = 0; row < field.numRows(); ++row) to[row] += factor * field[load][row];
  };
  if (loadOf_[column] != none) addColumn(loadOf_[column], times);
  if (factor_[column] != 0.0) addColumn(unitLoadOf_[unitOf_[column]], times * factor_[column]);
}

void ColumnLoads::prepareTraceMotions(const std::vector<int>& columns) {
  const auto hasLoad = [this](int column) { return loadOf_[column] != none; };
  const bool areNeeded = projected_.numCols() > 0 && std::any_of(columns.begin(), columns.end(), hasLoad);
  if (!areNeeded || solver_.solvesTrace() || traceMotions_.numCols() > 0) return;
  const std::vector<int>& trace = operator_.trace();
  traceMotions_.shape(static_cast<int>(trace.size()), count_);
  solveInWindows([&](int first, const base::Matrix& solution) {
    for (int j = 0; j < solution.numCols(); ++j) {
      for (std::size_t row = 0; row < trace.size(); ++row) traceMotions_[first + j][row] = solution[j][trace[row]];
    }
  });
  for (int j = 0; j < held_.numCols(); ++j) {
    for (std::size_t row = 0; row < trace.size(); ++row) traceMotions_[j][row] += held_[j][trace[row]];
  }
}

void ColumnLoads::addTraceMotion(int column, double* to) const {
  const int load = loadOf_[column];
  if (load == none || projected_.numCols() == 0) return;
  const std::vector<int>& trace = operator_.trace();
  for (std::size_t row = 0; row < trace.size(); ++row)
    to[row] += solver_.solvesTrace() ? motions_[load][trace[row]] : traceMotions_[load][row];
}

double ColumnLoads::largestMotion() const {
  return solver_.solvesTrace() ? largestOf(motions_) : largestOf(traceMotions_);
}

}  // namespace harmos::latin
