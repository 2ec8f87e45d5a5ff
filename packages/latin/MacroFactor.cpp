#include <harmos/latin/detail/MacroFactor.hpp>

#include <algorithm>
#include <iomanip>
#include <random>
#include <set>
#include <sstream>
#include <utility>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::latin {
namespace {

using base::Matrix;
using substructure::DistributedSolver;
using substructure::SymmetricEntries;

// Of an inverse iteration, whose result is wanted to a factor of two.
constexpr int softnessIterations = 8;
// What is added to the diagonal, where an interface alone has 1, until it makes a matrix definite.
constexpr double leastShift = 1e-8, mostShift = 1.0, growthOfShift = 100.0;

/// The mean of both triangles removes the round-off asymmetry.
double meanOf(const Matrix& values, std::size_t i, std::size_t j) {
  const int row = static_cast<int>(i), column = static_cast<int>(j);
  return 0.5 * (values(row, column) + values(column, row));
}

/// |A^-1 x| after some iterations x <- A^-1 x / |A^-1 x|; x becomes the eigenvector of the smallest eigenvalue, about.
template <class Solver>
double iterateInversely(const Solver& solver, Matrix& x) {
  std::mt19937 random;  // its sequence is fixed by the standard, that of the distributions is not
  for (int i = 0; i < x.numRows(); ++i) x(i, 0) = random() / 2147483648.0 - 1.0;
  double length = x.normFrobenius();
  Matrix y(x.numRows(), 1);
  for (int i = 0; i < softnessIterations; ++i) {
    x.scale(1.0 / length);
    solver.solve(x, y);
    length = y.normFrobenius();
    x.assign(y);
  }
  x.scale(1.0 / length);
  return length;
}

std::string inWords(double value) {
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

std::vector<double> firstColumn(const Matrix& matrix) {
  return {matrix[0], matrix[0] + matrix.numRows()};
}

}  // namespace

MacroFactor::MacroFactor(int unknowns, const std::vector<std::vector<int>>& coupled, const std::vector<Share>& shares,
                         const substructure::SolverOptions& options, const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : unknowns_(unknowns) {
  if (DistributedSolver::exists() && comm->getSize() > 1 && unknowns >= options.sharedFrom) {
    factorTogether(shares, comm);
  } else {
    factorAlone(coupled, shares, options, *comm);
  }
}

void MacroFactor::factorAlone(const std::vector<std::vector<int>>& coupled, const std::vector<Share>& shares,
                              const substructure::SolverOptions& options, const Teuchos::Comm<int>& comm) {
  std::vector<std::set<int>> row(unknowns_);
  for (const auto& list : coupled) {
    for (const int unknown : list) row[unknown].insert(list.begin(), list.end());
  }
  std::vector<std::size_t> rowPointers{0};
  std::vector<int> columns;
  for (const auto& entries : row) {
    columns.insert(columns.end(), entries.begin(), entries.end());
    rowPointers.push_back(columns.size());
  }
  std::vector<double> local(columns.size(), 0.0);
  for (const Share& share : shares) {
    for (std::size_t i = 0; i < share.unknowns.size(); ++i) {
      const auto begin = columns.begin() + static_cast<std::ptrdiff_t>(rowPointers[share.unknowns[i]]);
      const auto end = columns.begin() + static_cast<std::ptrdiff_t>(rowPointers[share.unknowns[i] + 1]);
      for (std::size_t j = 0; j < share.unknowns.size(); ++j) {
        const auto at = static_cast<std::size_t>(std::lower_bound(begin, end, share.unknowns[j]) - columns.begin());
        local[at] += meanOf(share.values, i, j);
      }
    }
  }
  std::vector<double> values(local.size());
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(local.size()), local.data(), values.data());
  try {
    const auto matrix = substructure::makeCrsMatrix(rowPointers, columns, values);
    own_ = std::make_unique<substructure::SubstructureSolver>(matrix, substructure::BoundaryTerm{}, options,
                                                              "macro problem");
  } catch (const base::Error&) {
    Matrix dense(unknowns_, unknowns_);
    for (int i = 0; i < unknowns_; ++i) {
      for (std::size_t at = rowPointers[i]; at < rowPointers[i + 1]; ++at) dense(i, columns[at]) = values[at];
    }
    const std::vector<double> eigenvalues = symmetricEigen(dense);
    throw NotPositiveDefinite(eigenvalues.front(),
                              inWords(eigenvalues.front()) + ", largest " + inWords(eigenvalues.back()),
                              firstColumn(dense));
  }
}

void MacroFactor::factorTogether(const std::vector<Share>& shares, const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  SymmetricEntries addends;
  for (const Share& share : shares) {
    for (std::size_t i = 0; i < share.unknowns.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        addends.rows.push_back(std::max(share.unknowns[i], share.unknowns[j]));
        addends.columns.push_back(std::min(share.unknowns[i], share.unknowns[j]));
        addends.values.push_back(meanOf(share.values, i, j));
      }
    }
  }
  try {
    shared_ = std::make_unique<DistributedSolver>(unknowns_, addends, comm);
    return;
  } catch (const DistributedSolver::NotPositiveDefinite&) {
    // What follows finds out why.
  }
  const std::size_t count = addends.values.size();
  for (double shift = leastShift; shift <= mostShift; shift *= growthOfShift) {
    for (std::vector<int>* numbers : {&addends.rows, &addends.columns}) numbers->resize(count);
    addends.values.resize(count);
    for (int row = 0; row < unknowns_ && comm->getRank() == 0; ++row) {
      addends.rows.push_back(row);
      addends.columns.push_back(row);
      addends.values.push_back(shift);
    }
    Matrix motion(unknowns_, 1);
    double length = 0.0;
    try {
      const DistributedSolver shifted(unknowns_, addends, comm);
      length = iterateInversely(shifted, motion);
    } catch (const DistributedSolver::NotPositiveDefinite&) {
      continue;
    }
    throw NotPositiveDefinite(1.0 / length - shift, inWords(1.0 / length - shift), firstColumn(motion));
  }
  throw base::Error("the macro problem is indefinite");
}

double MacroFactor::softness() const {
  Matrix x(unknowns_, 1);
  return std::max(1.0, iterateInversely(*this, x));
}

}  // namespace harmos::latin
