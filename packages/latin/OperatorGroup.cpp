#include <harmos/latin/detail/OperatorGroup.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

#include <harmos/latin/StencilWorth.hpp>
#include <harmos/latin/detail/LargestOf.hpp>

namespace harmos::latin {
namespace {

// Right-hand sides that solvers, which copy them, are given together: more of them read a factor hardly faster.
constexpr std::size_t columnsAtOnce = 128;

}  // namespace

OperatorGroup::OperatorGroup(const substructure::Substructure& body, const substructure::Substructure& first,
                             substructure::BoundaryTerm term, const substructure::SolverOptions& options)
    : operator_(first.stiffness, std::move(term)),
      solver_(body.iterates ? substructure::SubstructureSolver::iterating(operator_.stiffness(), operator_.term(),
                                                                          options, body.partName(), first.nodes)
                            : substructure::SubstructureSolver(operator_.stiffness(), operator_.term(), options,
                                                               body.partName(), operator_.trace(), first.nodes)),
      loads_(operator_, solver_) {
  if (!options.invertTrace || !isTrace() || operator_.heldDofs().empty()) return;
  stencil_ = std::make_unique<HeldStencil>(operator_);
  if (!isStencilWorthwhile(options, stencil_->solves(), rows())) stencil_.reset();
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
  const int columns = static_cast<int>(loadColumns.size());
  loads_.select(std::move(loadColumns));
  columnsOfBody_ = columns / bodies;
  isTraceOnly_ = false;
  forces_.shape(rows(), columns);
  solution_.shape(rows(), columns);
  largest_.assign(isTrace() || keepsAll() ? 0 : static_cast<std::size_t>(columns), 0.0);
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
    for (const int column : together) loads_.forgetUnit(column);
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
  for (int j = 0; j < forces.numCols(); ++j) loads_.addForces(columns[j], forces[j]);
  return forces;
}

base::Matrix OperatorGroup::movedOf(const std::vector<int>& columns) const {
  base::Matrix moved(dofs(), static_cast<int>(columns.size()));
  for (int j = 0; j < moved.numCols(); ++j) {
    std::copy_n(all_[columns[j]], dofs(), moved[j]);
    loads_.addHeld(columns[j], moved[j], -1.0);
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
  for (const int column : columns) loads_.forgetUnit(column);
  isTraceOnly_ = true;
  return solver_.split(traceForces(columns));
}

void OperatorGroup::join(const std::vector<int>& columns, const std::vector<base::Matrix>& parts) {
  base::Matrix traces;
  solver_.join(parts, traces);
  keepTraces(columns, traces);
}

void OperatorGroup::keepTraces(const std::vector<int>& columns, const base::Matrix& traces) {
  loads_.prepareTraceMotions(columns);
  for (int j = 0; j < traces.numCols(); ++j) {
    double* const to = solution_[columns[j]];
    std::copy_n(traces[j], rows(), to);
    loads_.addTraceMotion(columns[j], to);
    if (!largest_.empty()) largest_[columns[j]] = largestOf(to, rows());
  }
}

void OperatorGroup::solveAll(const std::vector<int>& columns, substructure::Precision precision) {
  base::Matrix solution;
  if (solver_.iterates()) solution = movedOf(columns);
  solver_.solve(forcesOf(columns), solution, precision);
  const std::vector<int>& trace = operator_.trace();
  for (int j = 0; j < solution.numCols(); ++j) {
    loads_.addHeld(columns[j], solution[j]);
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
  base::Matrix forces(dofs(), loads_.count());
  for (const Window& window : windows()) {
    std::vector<const double*> u;
    std::vector<double*> to;
    for (const int j : columnsOf(window)) {
      u.push_back(whole(j));
      to.push_back(forces[loads_.of(j)]);
    }
    operator_.addRoundOff(seed, u, to);
  }
  if (!solver_.iterates()) return forces;
  const base::Matrix left = residual();
  for (int j = 0; j < left.numCols(); ++j) {
    for (int row = 0; row < left.numRows(); ++row) forces[loads_.of(j)][row] += left[j][row];
  }
  return forces;
}

void OperatorGroup::keepUnit() {
  loads_.keepUnit();
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
  loads_.addUnit(column, member, factor);
  forgetDerived();
}

void OperatorGroup::forgetDerived() {
  window_ = Window();
  for (base::Matrix* field : {&whole_, &reactions_, &atHeldDofs_}) *field = base::Matrix();
  isByStencil_ = hasReactions_ = false;
}

void OperatorGroup::solveWhole(const Window& window) const {
  const std::vector<int> columns = columnsOf(window);
  solver_.solve(forcesOf(columns), whole_,
                isTraceOnly_ ? substructure::Precision::single : substructure::Precision::exact);
  for (int j = 0; j < whole_.numCols(); ++j) loads_.addHeld(columns[j], whole_[j]);
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
  const int held = keepsHeld() ? operator_.heldRow(dof) : -1;
  if (held < 0) return whole(column) + dof;
  reactions();
  return atHeldDofs_[column] + held;
}

void OperatorGroup::solveLinearly(base::Matrix& forces, base::Matrix& solution) const {
  operator_.project(forces);
  solver_.solve(forces, solution);
}

double OperatorGroup::largestDisplacement(double share) const {
  if (isTrace() || isTraceOnly_) return std::max(largestOf(solution_), share * loads_.largestMotion());
  if (hasAll()) return largestOf(all_);
  return largest_.empty() ? 0.0 : *std::max_element(largest_.begin(), largest_.end());
}

void OperatorGroup::react(int column, const double* u) const {
  const std::vector<int>& held = operator_.heldDofs();
  double* const reaction = reactions_[column];
  operator_.multiply(u, held, reaction);
  loads_.subtractAtHeldDofs(column, reaction);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const int row = rowOf(held[i]);
    if (row >= 0) reaction[i] -= forces_[column][row];
    if (atHeldDofs_.numCols() > 0) atHeldDofs_[column][i] = u[held[i]];
  }
}

void OperatorGroup::reactByStencil() const {
  stencil_->prepare(solver_);
  std::vector<double> ofLoads(static_cast<std::size_t>(dofs()));
  for (int j = 0; j < forces_.numCols(); ++j) {
    std::fill(ofLoads.begin(), ofLoads.end(), 0.0);
    loads_.addMotion(j, ofLoads.data());
    react(j, ofLoads.data());
  }
  stencil_->add(forces_, reactions_, atHeldDofs_);
  isByStencil_ = true;
}

const base::Matrix& OperatorGroup::reactions() const {
  if (hasReactions_) return reactions_;
  const auto count = static_cast<int>(operator_.heldDofs().size());
  reactions_.shape(count, forces_.numCols());
  if (keepsHeld()) atHeldDofs_.shape(count, forces_.numCols());
  if (usesStencil()) {
    reactByStencil();
  } else {
    for (const Window& window : windows()) {
      for (const int j : columnsOf(window)) react(j, whole(j));
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
