#include <harmos/substructure/SubstructureSolver.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Amesos2_Solver.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/TraceInverse.hpp>
#include <harmos/substructure/detail/BoundedStiffness.hpp>
#include <harmos/substructure/detail/TooLarge.hpp>
#include <harmos/substructure/detail/TrialSolution.hpp>

namespace harmos::substructure {
namespace {

// Of the diagonal: makes a singular matrix factorable, but no indefinite one.
constexpr double shift = 1e-8;
// Right-hand sides by which single precision is measured, and the error from which on it is of no use.
constexpr int trials = 3;
constexpr double worstSingle = 1e-3;

/// The matrix as a block of vectors, not copied. Amesos2 wants the right-hand side const but has no const view.
base::MultiVector vectorsOf(const base::Matrix& matrix, const Teuchos::RCP<const base::MultiVector::map_type>& map) {
  using Vectors = base::MultiVector::dual_view_type;
  const Vectors::t_dev view(matrix.values(), static_cast<std::size_t>(matrix.numRows()),
                            static_cast<std::size_t>(matrix.numCols()));
  return {map, Vectors(view, view)};
}

/// What the rows of a trace stand for; nothing without nodes.
std::vector<MirrorPlanes::Row> rowsOf(const std::vector<int>& trace, const std::vector<base::Vector3>& nodes,
                                      int dimension) {
  std::vector<MirrorPlanes::Row> rows;
  for (std::size_t i = 0; !nodes.empty() && i < trace.size(); ++i) {
    rows.push_back({nodes[trace[i] / dimension], trace[i] % dimension});
  }
  return rows;
}

/// Translations and small rotations, dofs x 3 or 6, about the first node and of about the same size.
base::Matrix rigidMotions(const std::vector<base::Vector3>& nodes, int dimension) {
  double extent = 0.0;
  for (const base::Vector3& node : nodes) {
    for (int c = 0; c < dimension; ++c) extent = std::max(extent, std::abs(node[c] - nodes.front()[c]));
  }
  const int rotations = dimension == 3 ? 3 : 1;
  base::Matrix motions(static_cast<int>(nodes.size()) * dimension, dimension + rotations);
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const int row = static_cast<int>(a) * dimension;
    for (int c = 0; c < dimension; ++c) motions(row + c, c) = 1.0;
    for (int r = 0; r < rotations; ++r) {
      const int from = r, to = (r + 1) % dimension;  // turns the first of these axes towards the second
      motions(row + from, dimension + r) = -(nodes[a][to] - nodes.front()[to]) / extent;
      motions(row + to, dimension + r) = (nodes[a][from] - nodes.front()[from]) / extent;
    }
  }
  return motions;
}

std::string nodeOf(int dof, int dimension) {
  return "node " + std::to_string(dof / dimension + 1) + " of the part, component " + "xyz"[dof % dimension];
}

}  // namespace

SubstructureSolver::SubstructureSolver(const Teuchos::RCP<const base::CrsMatrix>& stiffness, int dimension,
                                       std::string partName)
    : part_(std::move(partName)), dimension_(dimension), stiffness_(stiffness) {}

SubstructureSolver::SubstructureSolver(const Teuchos::RCP<const base::CrsMatrix>& stiffness,
                                       const BoundaryTerm& boundary, const SolverOptions& options, std::string partName,
                                       const std::vector<int>& trace, const std::vector<base::Vector3>& nodes)
    : SubstructureSolver(stiffness, boundary.dimension, std::move(partName)) {
  mayPrepareSingle_ = options.allowsSingle;
  const Teuchos::RCP<base::CrsMatrix> sum = makeSum(boundary);
  solver_ = makeSolver(options, sum, trace);
  factor(sum);
  checkSolution(*sum);
  trace_ = traceFactor(*solver_);
  if (trace_ && options.invertTrace) {
    inverse_ = std::make_unique<TraceInverse>(*trace_, rowsOf(trace, nodes, dimension_));
    trace_.reset();
  }
  // Frees the values of the sum where the solver is known to need its factors only.
  if (solver_->name() == "Cholmod" || solver_->name() == "Tacho") solver_->setA(stiffness_, Amesos2::NUMFACT);
}

SubstructureSolver SubstructureSolver::iterating(const Teuchos::RCP<const base::CrsMatrix>& stiffness,
                                                 const BoundaryTerm& boundary, const SolverOptions& options,
                                                 std::string partName, const std::vector<base::Vector3>& nodes) {
  SubstructureSolver result(stiffness, boundary.dimension, std::move(partName));
  const Teuchos::RCP<base::CrsMatrix> sum = result.makeSum(boundary);
  base::Matrix motions = rigidMotions(nodes, boundary.dimension);
  const auto nearKernel = Teuchos::rcp(new base::MultiVector(vectorsOf(motions, sum->getRowMap()), Teuchos::Copy));
  result.iterative_ =
      std::make_unique<IterativeSolver>(sum, nearKernel, boundary.dimension, options.iterationTolerance);
  result.checkSolution(*sum);
  return result;
}

Teuchos::RCP<base::CrsMatrix> SubstructureSolver::makeSum(const BoundaryTerm& boundary) {
  Teuchos::RCP<base::CrsMatrix> sum = sumOf(*stiffness_, boundary, part_);
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

void SubstructureSolver::factor(const Teuchos::RCP<base::CrsMatrix>& sum) {
  try {
    solver_->numericFactorization();
    return;
  } catch (const std::bad_alloc&) {
    throw base::Error("Part \"" + part_ + "\" with " + std::to_string(dofs_) +
                      " unknowns is too large to be factored in the memory at hand. Cut it into pieces (\"Pieces\").");
  } catch (const TooLarge& error) {
    throw base::Error("Part \"" + part_ + "\" with " + std::to_string(dofs_) +
                      " unknowns is too large to be factored (" + error.what() + "). Cut it into pieces (\"Pieces\").");
  } catch (const std::runtime_error&) {
    // Not positive definite: what follows finds out why.
  }
  // A singular matrix differs from an indefinite one in that a small shift makes it factorable.
  const CrsView view = viewOf(*sum, part_);
  const auto local = sum->getLocalMatrixHost();
  for (int row = 0; row < dofs_; ++row) local.values(view.positionOf(row, row)) *= 1.0 + shift;
  try {
    solver_->numericFactorization();
  } catch (const std::exception&) {
    throwIndefinite();
  }
  throwSingular();
}

void SubstructureSolver::checkSolution(const base::CrsMatrix& sum) const {
  const CrsView view = viewOf(sum, part_);
  const base::Matrix b = randomForces(dofs_, 1);
  base::Matrix x(dofs_, 1);
  solve(b, x);
  std::vector<double> product(dofs_, 0.0);
  for (int row = 0; row < dofs_; ++row) {
    for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k) {
      product[row] += view.values[k] * x(view.columns[k], 0);
    }
  }
  const Definiteness found = judge(b, x, product);
  if (found == Definiteness::singular) throwSingular();
  if (found == Definiteness::indefinite) throwIndefinite();
}

void SubstructureSolver::throwSingular() const {
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
  if (!solvesTrace()) single_ = singleFactor(*solver_);
  if (!single_ && !inverse_) return singleError_;
  const base::Matrix b = randomForces(inverse_ ? inverse_->rows() : dofs_, trials);
  base::Matrix exact(b.numRows(), trials), single(exact);
  if (inverse_) {
    inverse_->solve(b, exact);
    inverse_->solveRoughly(b, single);
  } else {
    solve(b, exact);
    single_->solve(b, single);
  }
  for (int j = 0; j < trials; ++j) {
    double distance = 0.0, norm = 0.0;
    for (int row = 0; row < b.numRows(); ++row) {
      distance += (single(row, j) - exact(row, j)) * (single(row, j) - exact(row, j));
      norm += exact(row, j) * exact(row, j);
    }
    const double error = std::sqrt(distance / norm);
    if (!(error <= worstSingle)) {  // also when numbers of single precision do not reach so far
      single_.reset();
      return singleError_ = 0.0;
    }
    singleError_ = std::max(singleError_, error);
  }
  return singleError_;
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
  if (single_ && precision == Precision::single) {
    single_->solve(b, x);
    return;
  }
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
  const auto map = stiffness_->getRowMap();
  const base::MultiVector right = vectorsOf(b, map);
  base::MultiVector left = vectorsOf(x, map);
  solver_->solve(&left, &right);
}

void SubstructureSolver::solveTrace(const base::Matrix& b, base::Matrix& x, Precision precision) const {
  if (!inverse_) {
    trace_->solve(b, x);
  } else if (precision == Precision::single && singleError_ > 0.0) {
    inverse_->solveRoughly(b, x);
  } else {
    inverse_->solve(b, x);
  }
}

std::size_t SubstructureSolver::factorNonzeros() const {
  return solver_.is_null() ? 0 : solver_->getStatus().getNnzLU();
}

FactorSize SubstructureSolver::predict(const base::CrsMatrix& stiffness, const BoundaryTerm& boundary) {
  Teuchos::RCP<const base::CrsMatrix> sum = Teuchos::rcpFromRef(stiffness);
  if (!boundary.entries.empty()) sum = sumOf(stiffness, boundary, "stiffness");
  const CrsView view = viewOf(*sum, "stiffness");
  return NestedDissection(view.rows, view.rowPointers, view.columns).factorSize();
}

}  // namespace harmos::substructure
