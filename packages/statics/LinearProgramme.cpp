#include <harmos/statics/LinearProgramme.hpp>

#include <cmath>

#include <ClpSimplex.hpp>

namespace harmos::statics {
namespace {

// Rows and costs of the order of one; CLP's own 1e-7 would leave out columns that are to sharpen a solution.
constexpr double tolerance = 1e-10;

}  // namespace

struct LinearProgramme::Solver {
  ClpSimplex simplex;
  // Columns that wait: one call of CLP per column would copy its matrix every time.
  std::vector<double> lower, upper, cost, values;
  std::vector<int> rows;
  std::vector<CoinBigIndex> starts{0};

  void takeIn() {
    if (cost.empty()) return;
    simplex.addColumns(static_cast<int>(cost.size()), lower.data(), upper.data(), cost.data(), starts.data(),
                       rows.data(), values.data());
    for (auto* list : {&lower, &upper, &cost, &values}) list->clear();
    rows.clear();
    starts = {0};
  }
};

LinearProgramme::LinearProgramme(const std::vector<double>& right) : solver_(std::make_unique<Solver>()) {
  const int rows = static_cast<int>(right.size());
  solver_->simplex.setLogLevel(0);
  // CLP's scaling makes its tolerances looser than what new columns improve.
  solver_->simplex.scaling(0);
  solver_->simplex.setPrimalTolerance(tolerance);
  solver_->simplex.setDualTolerance(tolerance);
  solver_->simplex.resize(rows, 0);
  for (int row = 0; row < rows; ++row) solver_->simplex.setRowBounds(row, right[row], right[row]);
}

LinearProgramme::~LinearProgramme() = default;
LinearProgramme::LinearProgramme(LinearProgramme&&) noexcept = default;
LinearProgramme& LinearProgramme::operator=(LinearProgramme&&) noexcept = default;

void LinearProgramme::add(const std::vector<Entry>& column, double lower, double upper, double cost) {
  Solver& solver = *solver_;
  solver.lower.push_back(std::isinf(lower) ? -COIN_DBL_MAX : lower);
  solver.upper.push_back(std::isinf(upper) ? COIN_DBL_MAX : upper);
  solver.cost.push_back(cost);
  for (const Entry& entry : column) {
    if (entry.value == 0.0) continue;
    solver.rows.push_back(entry.row);
    solver.values.push_back(entry.value);
  }
  solver.starts.push_back(static_cast<CoinBigIndex>(solver.rows.size()));
}

int LinearProgramme::columns() const {
  return solver_->simplex.numberColumns() + static_cast<int>(solver_->cost.size());
}

bool LinearProgramme::solve() {
  solver_->takeIn();
  solver_->simplex.primal();
  return solver_->simplex.isProvenOptimal();
}

bool LinearProgramme::isUnbounded() const {
  return solver_->simplex.isProvenDualInfeasible();
}

double LinearProgramme::value() const {
  return solver_->simplex.objectiveValue();
}

std::vector<double> LinearProgramme::solution() const {
  const double* x = solver_->simplex.primalColumnSolution();
  return {x, x + solver_->simplex.numberColumns()};
}

std::vector<double> LinearProgramme::multipliers() const {
  const double* y = solver_->simplex.dualRowSolution();
  return {y, y + solver_->simplex.numberRows()};
}

}  // namespace harmos::statics
