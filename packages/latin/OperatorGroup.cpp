#include <harmos/latin/detail/OperatorGroup.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace harmos::latin {
namespace {

// Relative difference of the entries of two operators that is round-off.
constexpr double roundOff = 1e-10;
// Right-hand sides that solvers, which copy them, are given together: more of them read a factor hardly faster.
constexpr std::size_t columnsAtOnce = 128;

/// The degrees of freedom, ascending, of the nodes at which a boundary term has search directions.
std::vector<int> traceOf(const substructure::BoundaryTerm& term) {
  std::set<int> nodes;
  for (std::size_t dof = 0; dof < term.diagonal.size(); ++dof) {
    if (term.diagonal[dof] != 0.0) nodes.insert(static_cast<int>(dof) / term.dimension);
  }
  for (const substructure::BoundaryTerm::NodeEntry& entry : term.entries) nodes.insert(entry.row);
  std::vector<int> dofs;
  for (const int node : nodes) {
    for (int c = 0; c < term.dimension; ++c) dofs.push_back(node * term.dimension + c);
  }
  return dofs;
}

/// 1 or -1, the same for (row, column) and (column, row), else as if by chance.
double signOf(unsigned seed, int row, int column) {
  std::uint64_t x =
      (static_cast<std::uint64_t>(std::min(row, column)) << 32U) | static_cast<unsigned>(std::max(row, column));
  x += 0x9e3779b97f4a7c15U * (seed + std::uint64_t{1});
  // The finaliser of SplitMix64, Steele et al. (2014), doi:10.1145/2660193.2660195.
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return ((x ^ (x >> 31U)) & 1U) != 0U ? 1.0 : -1.0;
}

bool isZero(const base::Matrix& matrix) {
  for (int j = 0; j < matrix.numCols(); ++j) {
    if (!std::all_of(matrix[j], matrix[j] + matrix.numRows(), [](double value) { return value == 0.0; })) return false;
  }
  return true;
}

bool areEqual(const std::vector<substructure::BoundaryTerm::NodeTensor>& a,
              const std::vector<substructure::BoundaryTerm::NodeTensor>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double size = base::distance(a[i].value, {});
    if (a[i].node != b[i].node || base::distance(a[i].value, b[i].value) > roundOff * size) return false;
  }
  return true;
}

}  // namespace

OperatorGroup::OperatorGroup(const substructure::Substructure& body, const substructure::Substructure& first,
                             substructure::BoundaryTerm term, const substructure::SolverOptions& options)
    : stiffness_(first.stiffness),
      term_(std::move(term)),
      trace_(traceOf(term_)),
      solver_(body.iterates
                  ? substructure::SubstructureSolver::iterating(stiffness_, term_, options, body.name, first.nodes)
                  : substructure::SubstructureSolver(stiffness_, term_, options, body.name, trace_)) {
  if (!solver_.solvesTrace()) trace_.clear();
  for (const substructure::BoundaryTerm::NodeTensor& held : term_.free) {
    for (int c = 0; c < term_.dimension; ++c) heldDofs_.push_back(held.node * term_.dimension + c);
  }
  if (!options.invertTrace || !isTrace() || heldDofs_.empty()) return;
  stencil_ = std::make_unique<HeldStencil>(substructure::viewOf(*stiffness_, "operator"), term_, trace_);
  if (!stencil_->isWorthwhile()) stencil_.reset();
}

bool OperatorGroup::has(const substructure::BoundaryTerm& term, bool iterates) const {
  if (solver_.iterates() != iterates || term_.entries.size() != term.entries.size()) return false;
  for (std::size_t i = 0; i < term.entries.size(); ++i) {
    const auto &a = term_.entries[i], &b = term.entries[i];
    if (a.row != b.row || a.column != b.column || std::abs(a.value - b.value) > roundOff * std::abs(a.value)) {
      return false;
    }
  }
  for (std::size_t i = 0; i < term.diagonal.size(); ++i) {
    if (std::abs(term_.diagonal[i] - term.diagonal[i]) > roundOff * term_.diagonal[i]) return false;
  }
  return areEqual(term_.springs, term.springs) && areEqual(term_.free, term.free);
}

std::vector<double> OperatorGroup::diagonal() const {
  const substructure::CrsView view = substructure::viewOf(*stiffness_, "operator");
  std::vector<double> diagonal(term_.diagonal);
  diagonal.resize(static_cast<std::size_t>(view.rows), 0.0);
  for (int row = 0; row < view.rows; ++row) {
    const std::size_t at = view.positionOf(row, row);
    if (at != view.rowPointers[view.rows]) diagonal[row] += view.values[at];
  }
  return diagonal;
}

double OperatorGroup::stiffnessNorm() const {
  const std::vector<double> values = diagonal();
  return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0));
}

base::Matrix OperatorGroup::roundOffForces(unsigned seed) const {
  const substructure::CrsView view = substructure::viewOf(*stiffness_, "operator");
  const base::Matrix& u = wholeSolution();
  std::vector<double> roots = diagonal();
  for (double& value : roots) value = std::sqrt(value);
  base::Matrix forces(dofs(), cases_);
  for (int row = 0; row < view.rows; ++row) {
    for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k) {
      const int column = view.columns[k];
      const double entry =
          signOf(seed, row, column) * std::numeric_limits<double>::epsilon() * roots[row] * roots[column];
      for (int j = 0; j < u.numCols(); ++j) forces[loadColumns_[j]][row] += entry * u[j][column];
    }
  }
  if (!solver_.iterates()) return forces;
  const base::Matrix left = residual();
  for (int j = 0; j < left.numCols(); ++j) {
    for (int row = 0; row < view.rows; ++row) forces[loadColumns_[j]][row] += left[j][row];
  }
  return forces;
}

base::Matrix OperatorGroup::residual() const {
  base::Matrix moved(solution_);
  for (int j = 0; j < moved.numCols() && held_.numCols() > 0; ++j) {
    std::vector<double> held(static_cast<std::size_t>(dofs()), 0.0);
    addLoad(held_, j, held.data());
    for (int row = 0; row < dofs(); ++row) moved[j][row] -= held[row];
  }
  return solver_.residual(wholeForces(), moved);
}

double OperatorGroup::squaredResidual() const {
  if (!solver_.iterates()) return 0.0;
  const double norm = residual().normFrobenius();
  return norm * norm;
}

int OperatorGroup::rowOf(int dof) const {
  if (!isTrace()) return dof;
  return static_cast<int>(std::lower_bound(trace_.begin(), trace_.end(), dof) - trace_.begin());
}

int OperatorGroup::heldPlace(int node) const {
  const auto at = std::lower_bound(term_.free.begin(), term_.free.end(), node,
                                   [](const auto& held, int wanted) { return held.node < wanted; });
  return at != term_.free.end() && at->node == node ? static_cast<int>(at - term_.free.begin()) : -1;
}

void OperatorGroup::project(base::Matrix& vectors, bool onTrace) const {
  for (const substructure::BoundaryTerm::NodeTensor& held : term_.free) {
    int row = held.node * term_.dimension;
    if (onTrace && isTrace()) {
      const auto at = std::lower_bound(trace_.begin(), trace_.end(), row);
      if (at == trace_.end() || *at != row) continue;
      row = static_cast<int>(at - trace_.begin());
    }
    for (int j = 0; j < vectors.numCols(); ++j) {
      base::Vector3 old{};
      std::copy_n(vectors[j] + row, term_.dimension, old.begin());
      const base::Vector3 now = base::product(held.value, old);
      std::copy_n(now.begin(), term_.dimension, vectors[j] + row);
    }
  }
}

void OperatorGroup::multiply(const double* u, const std::vector<int>& rows, double* result) const {
  const substructure::CrsView view = substructure::viewOf(*stiffness_, "operator");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int row = rows[i];
    double sum = term_.diagonal.empty() ? 0.0 : term_.diagonal[row] * u[row];
    for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k) {
      sum += view.values[k] * u[view.columns[k]];
    }
    result[i] = sum;
  }
  for (const substructure::BoundaryTerm::NodeEntry& entry : term_.entries) {
    const auto at = std::lower_bound(rows.begin(), rows.end(), entry.row * term_.dimension);
    if (at == rows.end() || *at != entry.row * term_.dimension) continue;
    for (int c = 0; c < term_.dimension; ++c) {
      result[at - rows.begin() + c] += entry.value * u[entry.column * term_.dimension + c];
    }
  }
  for (const substructure::BoundaryTerm::NodeTensor& spring : term_.springs) {
    const int first = spring.node * term_.dimension;
    const auto at = std::lower_bound(rows.begin(), rows.end(), first);
    if (at == rows.end() || *at != first) continue;
    base::Vector3 w{};
    std::copy_n(u + first, term_.dimension, w.begin());
    const base::Vector3 force = base::product(spring.value, w);
    for (int c = 0; c < term_.dimension; ++c) result[at - rows.begin() + c] += force[c];
  }
}

void OperatorGroup::setLoads(const base::Matrix& loads, const base::Matrix& held) {
  const int columns = loads.numCols();
  const bool areNone = isZero(loads);
  const bool areKnown =
      areLoaded_ && cases_ == columns && held_ == held && (areNone ? givenLoads_.numCols() == 0 : givenLoads_ == loads);
  if (areKnown) return;
  ++loadChanges_;
  areLoaded_ = false;
  cases_ = columns;
  givenLoads_ = areNone ? base::Matrix() : loads;
  held_ = held;
  if (!heldDofs_.empty()) {
    heldLoads_.shape(static_cast<int>(heldDofs_.size()), columns);
    for (int j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < heldDofs_.size(); ++i) heldLoads_[j][i] = loads[j][heldDofs_[i]];
    }
  }
  loads_ = loaded_ = base::Matrix();
  const bool isHeldAway = held_.numCols() > 0;
  areLoaded_ = areNone && !isHeldAway;
  if (areLoaded_) return;
  loads_ = loads;
  if (isHeldAway) {
    std::vector<int> all(dofs());
    std::iota(all.begin(), all.end(), 0);
    std::vector<double> product(all.size());
    for (int j = 0; j < columns; ++j) {
      multiply(held_[j], all, product.data());
      for (std::size_t i = 0; i < all.size(); ++i) loads_[j][i] -= product[i];
    }
  }
  project(loads_, false);
  if (isTrace()) {
    loaded_.shape(dofs(), columns);
    if (loads_.normInf() > 0.0) solver_.solve(loads_, loaded_);
    if (isHeldAway) loaded_ += held_;
  }
  areLoaded_ = true;
}

void OperatorGroup::select(std::vector<int> loadColumns) {
  loadColumns_ = std::move(loadColumns);
  const int columns = static_cast<int>(loadColumns_.size());
  unitOf_.assign(columns, 0);
  unitFactors_.assign(columns, 0.0);
  forces_.shape(rows(), columns);
  solution_.shape(rows(), columns);
}

void OperatorGroup::solve(const std::vector<int>& columns, substructure::Precision precision) {
  hasWhole_ = hasStencil_ = false;
  hasReactions_ = false;
  const std::size_t count = columns.size();
  for (std::size_t first = 0; first < count; first += columnsAtOnce) {
    const auto begin = columns.begin() + static_cast<std::ptrdiff_t>(first);
    solveTogether({begin, begin + static_cast<std::ptrdiff_t>(std::min(columnsAtOnce, count - first))}, precision);
  }
}

void OperatorGroup::solveTogether(const std::vector<int>& columns, substructure::Precision precision) {
  const int count = static_cast<int>(columns.size());
  const bool isAll = count == forces_.numCols();
  base::Matrix right(rows(), count), part;
  for (int j = 0; j < count; ++j) {
    std::copy_n(forces_[columns[j]], rows(), right[j]);
    unitFactors_[columns[j]] = 0.0;
  }
  project(right, true);
  const bool isLoaded = loads_.numCols() > 0;
  for (int j = 0; j < count && isLoaded && !isTrace(); ++j) {
    const double* loads = loads_[loadColumns_[columns[j]]];
    for (int row = 0; row < rows(); ++row) right[j][row] += loads[row];
  }
  base::Matrix& solution = isAll ? solution_ : part;
  if (!isAll) part.shape(rows(), count);
  if (solver_.iterates()) guess(columns, solution);
  if (isTrace()) {
    solver_.solveTrace(right, solution, precision);
  } else {
    solver_.solve(right, solution, precision);
  }
  for (int j = 0; j < count; ++j) {
    double* to = solution_[columns[j]];
    if (!isAll) std::copy_n(part[j], rows(), to);
    const int load = loadColumns_[columns[j]];
    if (isTrace()) {
      for (int row = 0; row < rows() && isLoaded; ++row) to[row] += loaded_[load][trace_[row]];
    } else if (held_.numCols() > 0) {
      for (int row = 0; row < rows(); ++row) to[row] += held_[load][row];
    }
  }
}

void OperatorGroup::guess(const std::vector<int>& columns, base::Matrix& solution) const {
  for (std::size_t j = 0; j < columns.size(); ++j) {
    double* const to = solution[static_cast<int>(j)];
    if (to != solution_[columns[j]]) std::copy_n(solution_[columns[j]], dofs(), to);
    for (int row = 0; row < dofs() && held_.numCols() > 0; ++row) to[row] -= held_[loadColumns_[columns[j]]][row];
  }
}

void OperatorGroup::keepUnit() {
  unitColumns_ = loadColumns_;
  unitForces_ = forces_;
  unit_ = solution_;
}

void OperatorGroup::addUnit(int column, int member, double factor) {
  for (int row = 0; row < rows(); ++row) {
    forces_[column][row] += factor * unitForces_[member][row];
    solution_[column][row] += factor * unit_[member][row];
  }
  unitOf_[column] = member;
  unitFactors_[column] = factor;
  hasWhole_ = hasStencil_ = false;
  hasReactions_ = false;
}

void OperatorGroup::addLoad(const base::Matrix& field, int column, double* to) const {
  if (field.numCols() == 0) return;
  const double* own = field[loadColumns_[column]];
  for (int row = 0; row < field.numRows(); ++row) to[row] += own[row];
  const double factor = unitFactors_[column];
  if (factor == 0.0) return;
  const double* unit = field[unitColumns_[unitOf_[column]]];
  for (int row = 0; row < field.numRows(); ++row) to[row] += factor * unit[row];
}

base::Matrix OperatorGroup::wholeForces() const {
  base::Matrix right(dofs(), forces_.numCols());
  for (int j = 0; j < right.numCols(); ++j) {
    if (!isTrace()) std::copy_n(forces_[j], dofs(), right[j]);
    for (std::size_t row = 0; row < trace_.size(); ++row) right[j][trace_[row]] = forces_[j][row];
  }
  project(right, false);
  for (int j = 0; j < right.numCols(); ++j) addLoad(loads_, j, right[j]);
  return right;
}

const base::Matrix& OperatorGroup::wholeSolution() const {
  if (!isTrace()) return solution_;
  if (hasWhole_) return whole_;
  const base::Matrix right = wholeForces();
  solver_.solve(right, whole_);
  for (int j = 0; j < right.numCols() && held_.numCols() > 0; ++j) addLoad(held_, j, whole_[j]);
  hasWhole_ = true;
  return whole_;
}

const double* OperatorGroup::displacement(int dof, int column) const {
  const auto row = std::lower_bound(trace_.begin(), trace_.end(), dof);
  if (row != trace_.end() && *row == dof) return solution_[column] + (row - trace_.begin());
  const int place = stencilRow(dof);
  return place < 0 ? wholeSolution()[column] + dof : stencilSolution()[column] + place;
}

int OperatorGroup::stencilRow(int dof) const {
  return stencil_ && !hasWhole_ ? stencil_->rowOf(dof) : -1;
}

const base::Matrix& OperatorGroup::stencilSolution() const {
  if (hasStencil_) return onStencil_;
  stencil_->prepare(solver_, [this](base::Matrix& columns) { project(columns, false); });
  stencil_->move(forces_, onStencil_);
  std::vector<double> whole(static_cast<std::size_t>(dofs()));
  for (int j = 0; j < onStencil_.numCols(); ++j) {
    std::fill(whole.begin(), whole.end(), 0.0);
    addLoad(loaded_, j, whole.data());
    for (std::size_t i = 0; i < stencil_->dofs().size(); ++i) onStencil_[j][i] += whole[stencil_->dofs()[i]];
  }
  hasStencil_ = true;
  return onStencil_;
}

void OperatorGroup::solveLinearly(base::Matrix& forces, base::Matrix& solution) const {
  project(forces, false);
  solver_.solve(forces, solution);
}

double OperatorGroup::largestDisplacement(double share) const {
  const auto largestOf = [](const base::Matrix& matrix) {
    double largest = 0.0;
    for (int j = 0; j < matrix.numCols(); ++j) {
      for (int row = 0; row < matrix.numRows(); ++row) largest = std::max(largest, std::abs(matrix(row, j)));
    }
    return largest;
  };
  return isTrace() ? std::max(largestOf(solution_), share * largestOf(loaded_)) : largestOf(solution_);
}

const base::Matrix& OperatorGroup::reactions() const {
  if (hasReactions_) return reactions_;
  const bool isStencil = stencil_ && !hasWhole_;
  const base::Matrix& u = isStencil ? stencilSolution() : wholeSolution();
  std::vector<double> spread(isStencil ? static_cast<std::size_t>(dofs()) : 0, 0.0);
  reactions_.shape(static_cast<int>(heldDofs_.size()), u.numCols());
  for (int j = 0; j < u.numCols(); ++j) {
    for (int i = 0; isStencil && i < u.numRows(); ++i) spread[stencil_->dofs()[i]] = u[j][i];
    multiply(isStencil ? spread.data() : u[j], heldDofs_, reactions_[j]);
    std::vector<double> loads(heldDofs_.size(), 0.0);
    if (!heldDofs_.empty()) addLoad(heldLoads_, j, loads.data());
    for (std::size_t i = 0; i < heldDofs_.size(); ++i) reactions_[j][i] -= loads[i];
    for (std::size_t i = 0; i < heldDofs_.size(); ++i) {
      const int row = rowOf(heldDofs_[i]);
      const bool isLoaded = !isTrace() || (row < rows() && trace_[row] == heldDofs_[i]);
      if (isLoaded) reactions_[j][i] -= forces_[j][row];
    }
  }
  hasReactions_ = true;
  return reactions_;
}

base::Vector3 OperatorGroup::reaction(int place, int column) const {
  base::Vector3 residual{};
  std::copy_n(reactions()[column] + place * term_.dimension, term_.dimension, residual.begin());
  return residual - base::product(term_.free[place].value, residual);
}

}  // namespace harmos::latin
