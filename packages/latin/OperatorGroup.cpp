#include <harmos/latin/detail/OperatorGroup.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace harmos::latin {
namespace {

// Right-hand sides that solvers, which copy them, are given together: more of them read a factor hardly faster.
constexpr std::size_t columnsAtOnce = 128;

bool isZero(const base::Matrix& matrix) {
  for (int j = 0; j < matrix.numCols(); ++j) {
    if (!std::all_of(matrix[j], matrix[j] + matrix.numRows(), [](double value) { return value == 0.0; })) return false;
  }
  return true;
}

double largestOf(const double* values, int count) {
  double largest = 0.0;
  for (int row = 0; row < count; ++row) largest = std::max(largest, std::abs(values[row]));
  return largest;
}

double largestOf(const base::Matrix& matrix) {
  double largest = 0.0;
  for (int j = 0; j < matrix.numCols(); ++j) largest = std::max(largest, largestOf(matrix[j], matrix.numRows()));
  return largest;
}

}  // namespace

OperatorGroup::OperatorGroup(const substructure::Substructure& body, const substructure::Substructure& first,
                             substructure::BoundaryTerm term, const substructure::SolverOptions& options)
    : operator_(first.stiffness, std::move(term)),
      solver_(body.iterates ? substructure::SubstructureSolver::iterating(operator_.stiffness(), operator_.term(),
                                                                          options, body.partName(), first.nodes)
                            : substructure::SubstructureSolver(operator_.stiffness(), operator_.term(), options,
                                                               body.partName(), operator_.trace(), first.nodes)) {
  if (!options.invertTrace || !isTrace() || operator_.heldDofs().empty()) return;
  stencil_ = std::make_unique<HeldStencil>(substructure::viewOf(*operator_.stiffness(), "operator"), operator_.term(),
                                           operator_.trace());
  if (!stencil_->isWorthwhile()) stencil_.reset();
}

void OperatorGroup::setLoads(const base::Matrix& loads, const base::Matrix& held) {
  const int columns = loads.numCols();
  const bool areNone = isZero(loads);
  const bool areKnown =
      areLoaded_ && cases_ == columns && held_ == held && (areNone ? given().numCols() == 0 : given() == loads);
  if (areKnown) return;
  ++loadChanges_;
  areLoaded_ = false;
  cases_ = columns;
  held_ = held;
  const std::vector<int>& heldDofs = operator_.heldDofs();
  if (!heldDofs.empty()) {
    heldLoads_.shape(static_cast<int>(heldDofs.size()), columns);
    for (int j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < heldDofs.size(); ++i) heldLoads_[j][i] = loads[j][heldDofs[i]];
    }
  }
  loads_ = loaded_ = loadedTrace_ = givenLoads_ = base::Matrix();
  const bool isHeldAway = held_.numCols() > 0;
  if (!areNone && isHeld()) givenLoads_ = loads;
  areLoaded_ = areNone && !isHeldAway;
  if (areLoaded_) return;
  loads_ = loads;
  if (isHeldAway) {
    std::vector<int> all(dofs());
    std::iota(all.begin(), all.end(), 0);
    std::vector<double> product(all.size());
    for (int j = 0; j < columns; ++j) {
      operator_.multiply(held_[j], all, product.data());
      for (std::size_t i = 0; i < all.size(); ++i) loads_[j][i] -= product[i];
    }
  }
  operator_.project(loads_);
  if (isTrace()) {
    loaded_.shape(dofs(), columns);
    if (loads_.normInf() > 0.0) solver_.solve(loads_, loaded_);
    if (isHeldAway) loaded_ += held_;
  }
  areLoaded_ = true;
}

std::vector<OperatorGroup::Window> OperatorGroup::windows() const {
  std::vector<Window> result;
  for (int first = 0; first < columnsOfBody_; first += stepsAtOnce) {
    result.push_back({first, std::min(stepsAtOnce, columnsOfBody_ - first)});
  }
  return result;
}

std::vector<int> OperatorGroup::columnsOf(const Window& window) const {
  std::vector<int> result;
  for (int first = window.first; first < forces_.numCols(); first += columnsOfBody_) {
    for (int j = 0; j < window.count; ++j) result.push_back(first + j);
  }
  return result;
}

void OperatorGroup::select(std::vector<int> loadColumns, int bodies) {
  forgetDerived();
  loadColumns_ = std::move(loadColumns);
  const int columns = static_cast<int>(loadColumns_.size());
  columnsOfBody_ = columns / bodies;
  unitOf_.assign(columns, 0);
  unitFactors_.assign(columns, 0.0);
  isTraceOnly_ = false;
  forces_.shape(rows(), columns);
  solution_.shape(rows(), columns);
  largest_.assign(isTrace() || keepsAll() ? 0 : loadColumns_.size(), 0.0);
  if (keepsAll()) {
    all_.shape(dofs(), columns);
  } else {
    all_ = base::Matrix();
  }
}

void OperatorGroup::solve(const std::vector<int>& columns, substructure::Precision precision) {
  forgetDerived();
  const std::size_t count = columns.size();
  for (std::size_t first = 0; first < count; first += columnsAtOnce) {
    const auto begin = columns.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<int> together(begin, begin + static_cast<std::ptrdiff_t>(std::min(columnsAtOnce, count - first)));
    for (const int column : together) unitFactors_[column] = 0.0;
    isTraceOnly_ = precision == substructure::Precision::single && solver_.solvesTraceInSingle();
    if (isTrace() || isTraceOnly_) {
      solveTraces(together, precision);
    } else {
      solveAll(together, precision);
    }
  }
}

base::Matrix OperatorGroup::forcesOf(const std::vector<int>& columns) const {
  const std::vector<int>& trace = operator_.trace();
  base::Matrix forces(dofs(), static_cast<int>(columns.size()));
  for (int j = 0; j < forces.numCols(); ++j) {
    for (int row = 0; row < rows(); ++row) forces[j][trace[row]] = forces_[columns[j]][row];
  }
  operator_.project(forces);
  for (int j = 0; j < forces.numCols(); ++j) addLoad(loads_, columns[j], forces[j]);
  return forces;
}

base::Matrix OperatorGroup::movedOf(const std::vector<int>& columns) const {
  base::Matrix moved(dofs(), static_cast<int>(columns.size()));
  for (int j = 0; j < moved.numCols(); ++j) {
    std::copy_n(all_[columns[j]], dofs(), moved[j]);
    addLoad(held_, columns[j], moved[j], -1.0);
  }
  return moved;
}

base::Matrix OperatorGroup::traceForces(const std::vector<int>& columns) const {
  base::Matrix forces(rows(), static_cast<int>(columns.size()));
  for (int j = 0; j < forces.numCols(); ++j) std::copy_n(forces_[columns[j]], rows(), forces[j]);
  operator_.projectTrace(forces);
  return forces;
}

void OperatorGroup::solveTraces(const std::vector<int>& columns, substructure::Precision precision) {
  base::Matrix traces(rows(), static_cast<int>(columns.size()));
  solver_.solveTrace(traceForces(columns), traces, precision);
  keepTraces(columns, traces);
}

std::vector<base::Matrix> OperatorGroup::split(const std::vector<int>& columns) {
  forgetDerived();
  for (const int column : columns) unitFactors_[column] = 0.0;
  isTraceOnly_ = true;
  return solver_.split(traceForces(columns));
}

void OperatorGroup::join(const std::vector<int>& columns, const std::vector<base::Matrix>& parts) {
  base::Matrix traces;
  solver_.join(parts, traces);
  keepTraces(columns, traces);
}

void OperatorGroup::keepTraces(const std::vector<int>& columns, const base::Matrix& traces) {
  const std::vector<int>& trace = operator_.trace();
  const auto hasLoad = [this](int column) { return loadColumns_[column] != withoutLoads; };
  const bool areLoaded = loads_.numCols() > 0 && std::any_of(columns.begin(), columns.end(), hasLoad);
  if (areLoaded && !isTrace()) prepareLoadedTrace();
  for (int j = 0; j < traces.numCols(); ++j) {
    double* const to = solution_[columns[j]];
    std::copy_n(traces[j], rows(), to);
    const int ofLoad = loadColumns_[columns[j]];
    for (int row = 0; row < rows() && areLoaded && ofLoad != withoutLoads; ++row)
      to[row] += isTrace() ? loaded_[ofLoad][trace[row]] : loadedTrace_[ofLoad][row];
    if (!largest_.empty()) largest_[columns[j]] = largestOf(to, rows());
  }
}

void OperatorGroup::prepareLoadedTrace() {
  if (loadedTrace_.numCols() > 0) return;
  const std::vector<int>& trace = operator_.trace();
  loadedTrace_.shape(rows(), cases_);
  base::Matrix solution;
  for (int first = 0; first < cases_; first += stepsAtOnce) {
    const int count = std::min(stepsAtOnce, cases_ - first);
    solver_.solve(base::Matrix(Teuchos::View, loads_, loads_.numRows(), count, 0, first), solution);
    for (int j = 0; j < count; ++j) {
      for (int row = 0; row < rows(); ++row) loadedTrace_[first + j][row] = solution[j][trace[row]];
    }
  }
  for (int j = 0; j < held_.numCols(); ++j) {
    for (int row = 0; row < rows(); ++row) loadedTrace_[j][row] += held_[j][trace[row]];
  }
}

void OperatorGroup::solveAll(const std::vector<int>& columns, substructure::Precision precision) {
  base::Matrix solution;
  if (solver_.iterates()) solution = movedOf(columns);
  solver_.solve(forcesOf(columns), solution, precision);
  const std::vector<int>& trace = operator_.trace();
  for (int j = 0; j < solution.numCols(); ++j) {
    addLoad(held_, columns[j], solution[j]);
    double* to = solution_[columns[j]];
    for (int row = 0; row < rows(); ++row) to[row] = solution[j][trace[row]];
    if (keepsAll()) {
      std::copy_n(solution[j], dofs(), all_[columns[j]]);
    } else {
      largest_[columns[j]] = largestOf(solution[j], dofs());
    }
  }
}

base::Matrix OperatorGroup::residual() const {
  std::vector<int> columns(static_cast<std::size_t>(forces_.numCols()));
  std::iota(columns.begin(), columns.end(), 0);
  return solver_.residual(forcesOf(columns), movedOf(columns));
}

double OperatorGroup::squaredResidual() const {
  if (!solver_.iterates()) return 0.0;
  const double norm = residual().normFrobenius();
  return norm * norm;
}

base::Matrix OperatorGroup::roundOffForces(unsigned seed) const {
  base::Matrix forces(dofs(), cases_);
  for (const Window& window : windows()) {
    std::vector<const double*> u;
    std::vector<double*> to;
    for (const int j : columnsOf(window)) {
      u.push_back(whole(j));
      to.push_back(forces[loadColumns_[j]]);
    }
    operator_.addRoundOff(seed, u, to);
  }
  if (!solver_.iterates()) return forces;
  const base::Matrix left = residual();
  for (int j = 0; j < left.numCols(); ++j) {
    for (int row = 0; row < left.numRows(); ++row) forces[loadColumns_[j]][row] += left[j][row];
  }
  return forces;
}

void OperatorGroup::keepUnit() {
  unitColumns_ = loadColumns_;
  unitForces_ = forces_;
  unitSolution_ = solution_;
  unitAll_ = all_;
  unitLargest_.clear();
  for (int j = 0; j < all_.numCols(); ++j) unitLargest_.push_back(largestOf(all_[j], all_.numRows()));
}

void OperatorGroup::addUnit(int column, int member, double factor) {
  for (int row = 0; row < rows(); ++row) {
    forces_[column][row] += factor * unitForces_[member][row];
    solution_[column][row] += factor * unitSolution_[member][row];
  }
  for (int dof = 0; dof < all_.numRows(); ++dof) all_[column][dof] += factor * unitAll_[member][dof];
  if (!largest_.empty()) largest_[column] += std::abs(factor) * unitLargest_[member];
  unitOf_[column] = member;
  unitFactors_[column] = factor;
  forgetDerived();
}

void OperatorGroup::addLoad(const base::Matrix& field, int column, double* to, double times) const {
  if (field.numCols() == 0) return;
  const int ofLoad = loadColumns_[column];
  if (ofLoad != withoutLoads) {
    const double* own = field[ofLoad];
    for (int row = 0; row < field.numRows(); ++row) to[row] += times * own[row];
  }
  const double factor = times * unitFactors_[column];
  if (factor == 0.0) return;
  const double* unit = field[unitColumns_[unitOf_[column]]];
  for (int row = 0; row < field.numRows(); ++row) to[row] += factor * unit[row];
}

void OperatorGroup::forgetDerived() {
  window_ = Window();
  for (base::Matrix* field : {&whole_, &reactions_, &atHeldDofs_}) *field = base::Matrix();
  hasStencil_ = hasReactions_ = false;
}

void OperatorGroup::solveWhole(const Window& window) const {
  const std::vector<int> columns = columnsOf(window);
  solver_.solve(forcesOf(columns), whole_,
                isTraceOnly_ ? substructure::Precision::single : substructure::Precision::exact);
  for (int j = 0; j < whole_.numCols(); ++j) addLoad(held_, columns[j], whole_[j]);
  window_ = window;
}

const double* OperatorGroup::whole(int column) const {
  if (hasAll()) return all_[column];
  const int body = column / columnsOfBody_, ofBody = column % columnsOfBody_;
  if (ofBody < window_.first || ofBody >= window_.first + window_.count) {
    const int first = ofBody - ofBody % stepsAtOnce;
    solveWhole({first, std::min(stepsAtOnce, columnsOfBody_ - first)});
  }
  return whole_[body * window_.count + ofBody - window_.first];
}

const double* OperatorGroup::displacement(int dof, int column) const {
  if (hasAll()) return all_[column] + dof;
  const int row = operator_.traceRow(dof);
  if (row >= 0) return solution_[column] + row;
  const int place = usesStencil() ? stencil_->rowOf(dof) : -1;
  if (place >= 0) return stencilSolution()[column] + place;
  const int held = columnsOfBody_ > stepsAtOnce ? operator_.heldRow(dof) : -1;
  if (held < 0) return whole(column) + dof;
  reactions();
  return atHeldDofs_[column] + held;
}

const base::Matrix& OperatorGroup::stencilSolution() const {
  if (hasStencil_) return onStencil_;
  stencil_->prepare(solver_, [this](base::Matrix& columns) { operator_.project(columns); });
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
  operator_.project(forces);
  solver_.solve(forces, solution);
}

double OperatorGroup::largestDisplacement(double share) const {
  if (isTrace()) return std::max(largestOf(solution_), share * largestOf(loaded_));
  if (isTraceOnly_) return std::max(largestOf(solution_), share * largestOf(loadedTrace_));
  if (hasAll()) return largestOf(all_);
  return largest_.empty() ? 0.0 : *std::max_element(largest_.begin(), largest_.end());
}

void OperatorGroup::react(int column, const double* u) const {
  const std::vector<int>& held = operator_.heldDofs();
  double* const reaction = reactions_[column];
  operator_.multiply(u, held, reaction);
  addLoad(heldLoads_, column, reaction, -1.0);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const int row = rowOf(held[i]);
    if (row >= 0) reaction[i] -= forces_[column][row];
  }
}

const base::Matrix& OperatorGroup::reactions() const {
  if (hasReactions_) return reactions_;
  const std::vector<int>& held = operator_.heldDofs();
  const int columns = forces_.numCols(), count = static_cast<int>(held.size());
  reactions_.shape(count, columns);
  if (usesStencil()) {
    const base::Matrix& u = stencilSolution();
    std::vector<double> spread(static_cast<std::size_t>(dofs()), 0.0);
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < u.numRows(); ++i) spread[stencil_->dofs()[i]] = u[j][i];
      react(j, spread.data());
    }
    hasReactions_ = true;
    return reactions_;
  }
  const bool isKept = !keepsAll() && columnsOfBody_ > stepsAtOnce;
  if (isKept) atHeldDofs_.shape(count, columns);
  for (const Window& window : windows()) {
    for (const int j : columnsOf(window)) {
      const double* u = whole(j);
      react(j, u);
      for (int i = 0; isKept && i < count; ++i) atHeldDofs_[j][i] = u[held[i]];
    }
  }
  hasReactions_ = true;
  return reactions_;
}

base::Vector3 OperatorGroup::reaction(int place, int column) const {
  const int dimension = operator_.term().dimension;
  base::Vector3 residual{};
  std::copy_n(reactions()[column] + place * dimension, dimension, residual.begin());
  return residual - base::product(operator_.term().free[place].value, residual);
}

}  // namespace harmos::latin
