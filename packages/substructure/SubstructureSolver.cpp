#include <harmos/substructure/SubstructureSolver.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Tpetra_CrsMatrix.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/detail/BoundedStiffness.hpp>
#include <harmos/substructure/detail/DifferenceProduct.hpp>
#include <harmos/substructure/detail/MultiVectorView.hpp>
#include <harmos/substructure/detail/OperatorPlanes.hpp>
#include <harmos/substructure/detail/RigidMotions.hpp>
#include <harmos/substructure/detail/TooLarge.hpp>
#include <harmos/substructure/detail/TrialSolution.hpp>

namespace harmos::substructure {
namespace {

// Of the diagonal: makes a singular matrix factorable, but no indefinite one.
constexpr double shift = 1e-8;
// Right-hand sides by which single precision is measured, and the error from which on it is of no use.
constexpr int trials = 3;
constexpr double worstSingle = 1e-3;
// Relative error of a solution from which on nothing is left of it.
constexpr double worstSolution = 0.5;

/// b - A x, one column.
base::Matrix residualOf(const CrsView& matrix, const base::Matrix& b, const base::Matrix& x) {
  base::Matrix residual(b);
  for (int row = 0; row < matrix.rows; ++row) {
    double product = 0.0;
    for (std::size_t k = matrix.rowPointers[row]; k < matrix.rowPointers[row + 1]; ++k) {
      product += matrix.values[k] * x(matrix.columns[k], 0);
    }
    residual(row, 0) -= product;
  }
  return residual;
}

std::string nodeOf(int dof, int dimension) {
  return "node " + std::to_string(dof / dimension + 1) + " of the part, component " + "xyz"[dof % dimension];
}

}  // namespace

SubstructureSolver::SubstructureSolver(int dimension, std::string partName)
    : part_(std::move(partName)), dimension_(dimension) {}

SubstructureSolver::SubstructureSolver(const Teuchos::RCP<const base::CrsMatrix>& stiffness,
                                       const BoundaryTerm& boundary, const SolverOptions& options, std::string partName,
                                       const std::vector<int>& trace, const std::vector<base::Vector3>& nodes,
                                       bool isKnownRegular)
    : SubstructureSolver(boundary.dimension, std::move(partName)) {
  mayPrepareSingle_ = options.allowsSingle;
  const Teuchos::RCP<base::CrsMatrix> sum = makeSum(*stiffness, boundary);
  planes_ = operatorPlanes(nodes, *stiffness, boundary, trace);
  isHeld_ = holdsRigidMotions(boundary, nodes);
  factor(sum, options, trace);
  checkSolution(*sum, isKnownRegular);
  if (!nodes.empty()) measureError(DifferenceProduct(stiffness, boundary), nodes, isKnownRegular);
}

void SubstructureSolver::measureError(const DifferenceProduct& product, const std::vector<base::Vector3>& nodes,
                                      bool isKnownRegular) {
  base::Matrix b = randomForces(dofs_, 1);
  removeRigidMotions(nodes, dimension_, b);
  base::Matrix x, correction;
  solve(b, x);
  solve(product.residual(b, x), correction);
  for (base::Matrix* vectors : {&x, &correction}) removeRigidMotions(nodes, dimension_, *vectors);
  const double size = x.normFrobenius();
  solutionError_ = size > 0.0 ? correction.normFrobenius() / size : 0.0;
  if (!(solutionError_ <= worstSolution) && !isKnownRegular) throwSingular();
}

SubstructureSolver SubstructureSolver::iterating(const Teuchos::RCP<const base::CrsMatrix>& stiffness,
                                                 const BoundaryTerm& boundary, const SolverOptions& options,
                                                 std::string partName, const std::vector<base::Vector3>& nodes) {
  SubstructureSolver result(boundary.dimension, std::move(partName));
  const Teuchos::RCP<base::CrsMatrix> sum = result.makeSum(*stiffness, boundary);
  base::Matrix motions = rigidMotions(nodes, boundary.dimension);
  const auto nearKernel = Teuchos::rcp(new base::MultiVector(viewOf(motions, sum->getRowMap()), Teuchos::Copy));
  result.iterative_ =
      std::make_unique<IterativeSolver>(sum, nearKernel, boundary.dimension, options.iterationTolerance);
  result.checkSolution(*sum);
  return result;
}

Teuchos::RCP<base::CrsMatrix> SubstructureSolver::makeSum(const base::CrsMatrix& stiffness,
                                                          const BoundaryTerm& boundary) {
  Teuchos::RCP<base::CrsMatrix> sum = sumOf(stiffness, boundary, part_);
  project(*sum, boundary);
  const CrsView view = viewOf(*sum, part_);
  dofs_ = view.rows;
  checkDiagonal(view);
  return sum;
}

SubstructureSolver::~SubstructureSolver() = default;
SubstructureSolver::SubstructureSolver(SubstructureSolver&&) noexcept = default;
SubstructureSolver& SubstructureSolver::operator=(SubstructureSolver&&) noexcept = default;

void SubstructureSolver::checkDiagonal(const CrsView& matrix) const {
  for (int row = 0; row < matrix.rows; ++row) {
    const std::size_t position = matrix.positionOf(row, row);
    const double value = position == matrix.rowPointers[matrix.rows] ? 0.0 : matrix.values[position];
    if (value > 0.0 && std::isfinite(value)) continue;
    throw base::Error("The operator of part \"" + part_ + "\" cannot be factored: its diagonal entry at " +
                      nodeOf(row, dimension_) + " is " + std::to_string(value) +
                      ", but must be positive. Check that every node belongs to an element and that the material "
                      "constants are positive.");
  }
}

void SubstructureSolver::factor(const Teuchos::RCP<base::CrsMatrix>& sum, const SolverOptions& options,
                                const std::vector<int>& trace, bool mayBeDense) {
  hasTrace_ = !trace.empty();
  tracePlanes_ = planes_.restrictedTo(trace);
  const std::vector<std::vector<int>> rows = planes_.blocks(), traceRows = tracePlanes_.blocks();
  blocks_.clear();
  int traces = 0, wanted = 0;
  for (std::size_t b = 0; b < rows.size(); ++b) {
    if (rows[b].empty()) continue;
    const std::vector<int> within = placesInBlock(rows[b], trace, traceRows[b]);
    const Teuchos::RCP<base::CrsMatrix> matrix =
        planes_.count() == 0 ? sum : planes_.blockOf(viewOf(*sum, part_), rows[b]);
    blocks_.push_back(
        {rows[b], traceRows[b], within, factorOf(matrix, options, mayBeDense ? within : std::vector<int>{})});
    if (!within.empty()) ++wanted;
    if (blocks_.back().factor.solvesTrace()) ++traces;
  }
  solvesTrace_ = traces > 0 && traces == wanted;
  if (traces > 0 && !solvesTrace_) factor(sum, options, trace, false);
}

DirectFactor SubstructureSolver::factorOf(const Teuchos::RCP<base::CrsMatrix>& matrix, const SolverOptions& options,
                                          const std::vector<int>& trace) const {
  try {
    return {matrix, options, trace};
  } catch (const std::bad_alloc&) {
    throw base::Error("Part \"" + part_ + "\" with " + std::to_string(dofs_) +
                      " unknowns is too large to be factored in the memory at hand. Cut it into pieces (\"Pieces\").");
  } catch (const TooLarge& error) {
    throw base::Error("Part \"" + part_ + "\" with " + std::to_string(dofs_) +
                      " unknowns is too large to be factored (" + error.what() + "). Cut it into pieces (\"Pieces\").");
  } catch (const base::Error&) {
    throw;
  } catch (const std::runtime_error&) {
    // Not positive definite: what follows finds out why.
  }
  // A singular matrix differs from an indefinite one in that a small shift makes it factorable.
  const CrsView view = viewOf(*matrix, part_);
  const auto local = matrix->getLocalMatrixHost();
  for (int row = 0; row < view.rows; ++row) local.values(view.positionOf(row, row)) *= 1.0 + shift;
  try {
    const DirectFactor shifted(matrix, options, trace);
  } catch (const std::exception&) {
    throwIndefinite();
  }
  throwSingular();
}

void SubstructureSolver::checkSolution(const base::CrsMatrix& sum, bool isKnownRegular) const {
  const base::Matrix b = randomForces(dofs_, 1);
  base::Matrix x(dofs_, 1);
  solve(b, x);
  const Definiteness found = judge(b, x, residualOf(viewOf(sum, part_), b, x));
  if (found == Definiteness::singular && !isKnownRegular) throwSingular();
  if (found == Definiteness::indefinite) throwIndefinite();
}

void SubstructureSolver::throwSingular() const {
  if (isHeld_) {
    throw base::Error(
        "The operator of part \"" + part_ +
        "\" is singular in double precision: the part is held, but hardly resists some motion, because it "
        "is too slender or because what holds it is far softer. Cut a slender part into pieces "
        "(\"Pieces\"), let stiffnesses differ less, and check that none of its elements hang together by a "
        "node or an edge only.");
  }
  throw base::Error("The operator of part \"" + part_ +
                    "\" is singular: the part can move or turn without deforming. Hold it by at least one interface or "
                    "boundary with nodes that do not lie on one line, and check that none of its elements hang "
                    "together by a node or an edge only.");
}

void SubstructureSolver::throwIndefinite() const {
  throw base::Error("The operator of part \"" + part_ +
                    "\" is indefinite: some deformation has negative energy. Check the material constants, the "
                    "orientation of the elements, and that no stiffness of its interfaces is negative.");
}

double SubstructureSolver::prepareSingle() {
  if (!mayPrepareSingle_) return singleError_;
  mayPrepareSingle_ = false;
  bool haveSingle = true;
  for (Block& block : blocks_) {
    block.factor.prepareSingle(block.within);
    haveSingle = haveSingle && block.factor.hasSingle();
  }
  if (!haveSingle) return singleError_;
  singleError_ = std::numeric_limits<double>::infinity();  // so that solves are in single precision
  std::size_t rows = 0;
  for (const Block& block : blocks_) rows += (solvesTrace_ ? block.traceRows : block.rows).size();
  const base::Matrix b = randomForces(static_cast<int>(rows), trials);
  base::Matrix exact(b.numRows(), trials), single(exact);
  for (const Precision precision : {Precision::exact, Precision::single}) {
    base::Matrix& x = precision == Precision::exact ? exact : single;
    if (solvesTrace_) {
      solveTrace(b, x, precision);
    } else {
      solve(b, x, precision);
    }
  }
  double largest = 0.0;
  for (int j = 0; j < trials; ++j) {
    double distance = 0.0, norm = 0.0;
    for (int row = 0; row < b.numRows(); ++row) {
      distance += (single(row, j) - exact(row, j)) * (single(row, j) - exact(row, j));
      norm += exact(row, j) * exact(row, j);
    }
    const double error = std::sqrt(distance / norm);
    if (!(error <= worstSingle)) {  // also when numbers of single precision do not reach so far
      for (Block& block : blocks_) block.factor.dropSingle();
      return singleError_ = 0.0;
    }
    largest = std::max(largest, error);
  }
  return singleError_ = largest;
}

std::vector<base::Matrix> SubstructureSolver::split(const MirrorPlanes& planes, std::vector<int> Block::*rows,
                                                    const base::Matrix& b) const {
  base::Matrix changed(Teuchos::Copy, b, b.numRows(), b.numCols());  // also of views, whose copies are views
  if (planes.count() == 0) return {changed};
  planes.change(changed);
  std::vector<base::Matrix> parts;
  parts.reserve(blocks_.size());  // matrices are copied when they are moved
  for (const Block& block : blocks_) {
    const std::vector<int>& own = block.*rows;
    parts.emplace_back();
    parts.back().shapeUninitialized(static_cast<int>(own.size()), b.numCols());
    for (int j = 0; j < b.numCols(); ++j) {
      for (std::size_t i = 0; i < own.size(); ++i) parts.back()[j][i] = changed[j][own[i]];
    }
  }
  return parts;
}

void SubstructureSolver::join(const MirrorPlanes& planes, std::vector<int> Block::*rows,
                              const std::vector<base::Matrix>& parts, base::Matrix& x) const {
  if (planes.count() == 0) {
    x = parts.front();
    return;
  }
  int count = 0;
  const int columns = parts.front().numCols();
  for (const base::Matrix& part : parts) count += part.numRows();
  if (x.numRows() != count || x.numCols() != columns) x.shapeUninitialized(count, columns);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const std::vector<int>& own = blocks_[b].*rows;
    for (int j = 0; j < columns; ++j) {
      for (std::size_t i = 0; i < own.size(); ++i) x[j][own[i]] = parts[b][j][i];
    }
  }
  planes.change(x);
}

template <class Apply>
void SubstructureSolver::solveBlocks(const MirrorPlanes& planes, std::vector<int> Block::*rows, const base::Matrix& b,
                                     base::Matrix& x, const Apply& apply) const {
  if (planes.count() == 0) {
    apply(blocks_.front().factor, b, x);
    return;
  }
  std::vector<base::Matrix> parts = split(planes, rows, b);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].numRows() == 0) continue;
    base::Matrix product;
    product.shapeUninitialized(parts[i].numRows(), parts[i].numCols());
    apply(blocks_[i].factor, parts[i], product);
    parts[i].swap(product);
  }
  join(planes, rows, parts, x);
}

void SubstructureSolver::solve(const base::Matrix& b, base::Matrix& x, Precision precision) const {
  if (b.numRows() != dofs_ || (b.numCols() > 1 && b.stride() != dofs_)) {
    throw base::Error("Part \"" + part_ + "\" has " + std::to_string(dofs_) + " unknowns; a right-hand side of " +
                      std::to_string(b.numRows()) + " rows with stride " + std::to_string(b.stride()) + " was given.");
  }
  if (x.numRows() != b.numRows() || x.numCols() != b.numCols()) x.shapeUninitialized(b.numRows(), b.numCols());
  if (x.numCols() > 1 && x.stride() != dofs_) {
    throw base::Error("The solution for part \"" + part_ + "\" must be stored without gaps between its columns.");
  }
  if (b.numCols() == 0) return;
  if (iterative_) {
    try {
      iterative_->solve(b, x);
    } catch (const IterativeSolver::NotConverged& failure) {
      throw base::Error("The operator of part \"" + part_ + "\" cannot be solved iteratively (" + failure.what() +
                        "). Hold the part by interfaces or boundaries with nodes that do not lie on one line, take "
                        "elements that are less distorted, or factor it (\"Linear Solver\" = Direct), in \"Pieces\".");
    }
    return;
  }
  const bool roughly = precision == Precision::single && singleError_ > 0.0;
  solveBlocks(planes_, &Block::rows, b, x,
              [roughly](const DirectFactor& factor, const base::Matrix& from, base::Matrix& to) {
                factor.solve(from, to, roughly);
              });
}

void SubstructureSolver::solveTrace(const base::Matrix& b, base::Matrix& x, Precision precision) const {
  if (x.numRows() != b.numRows() || x.numCols() != b.numCols()) x.shapeUninitialized(b.numRows(), b.numCols());
  const bool roughly = precision == Precision::single && singleError_ > 0.0;
  solveBlocks(tracePlanes_, &Block::traceRows, b, x,
              [roughly](const DirectFactor& factor, const base::Matrix& from, base::Matrix& to) {
                factor.solvesTrace() ? factor.solveTrace(from, to, roughly) : factor.single()->solveTrace(from, to);
              });
}

std::vector<const SingleFactor*> SubstructureSolver::singleFactors() const {
  std::vector<const SingleFactor*> factors;
  if (!solvesTraceInSingle()) return factors;
  for (const Block& block : blocks_) factors.push_back(block.factor.single());
  return factors;
}

std::size_t SubstructureSolver::factorNonzeros() const {
  std::size_t sum = 0;
  for (const Block& block : blocks_) sum += block.factor.nonzeros();
  return sum;
}

std::size_t SubstructureSolver::entriesMet() const {
  if (!solvesTrace_) return factorNonzeros();
  std::size_t sum = 0;
  for (const Block& block : blocks_) sum += block.traceRows.size() * block.traceRows.size();
  return sum;
}

}  // namespace harmos::substructure
