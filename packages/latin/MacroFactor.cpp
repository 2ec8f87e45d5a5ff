#include <harmos/latin/detail/MacroFactor.hpp>

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <utility>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::latin {
namespace {

using base::Matrix;
using substructure::DistributedSolver;
using substructure::SubstructureSolver;
using substructure::SymmetricEntries;

/// A matrix by rows, columns ascending.
struct CompressedRows {
  std::vector<std::size_t> rowPointers{0};
  std::vector<int> columns;
  std::vector<double> values;

  /// Where an entry of the pattern lies.
  std::size_t at(int row, int column) const {
    const auto begin = columns.begin() + static_cast<std::ptrdiff_t>(rowPointers[row]);
    const auto end = columns.begin() + static_cast<std::ptrdiff_t>(rowPointers[row + 1]);
    return static_cast<std::size_t>(std::lower_bound(begin, end, column) - columns.begin());
  }
};

// Of an inverse iteration, whose result is wanted to a factor of two.
constexpr int softnessIterations = 8;
// What is added to the diagonal, where an interface alone has 1, until it makes a matrix definite.
constexpr double leastShift = 1e-8, mostShift = 1.0, growthOfShift = 10.0;
// An eigenvalue as small as the round-off of one that is zero, whatever its sign.
constexpr double noStiffness = 1e-13;

/// The mean of both triangles removes the round-off asymmetry.
double meanOf(const Matrix& values, std::size_t i, std::size_t j) {
  const int row = static_cast<int>(i), column = static_cast<int>(j);
  return 0.5 * (values(row, column) + values(column, row));
}

/// |G^-1 x| after some iterations x <- G^-1 x / |G^-1 x|; x becomes the eigenvector of the smallest eigenvalue, about.
double iterateInversely(const MacroFactor& factor, Matrix& x) {
  std::mt19937 random;  // its sequence is fixed by the standard, that of the distributions is not
  for (int i = 0; i < x.numRows(); ++i) x(i, 0) = random() / 2147483648.0 - 1.0;
  double length = x.normFrobenius();
  Matrix y(x.numRows(), 1);
  for (int i = 0; i < softnessIterations; ++i) {
    x.scale(1.0 / length);
    factor.solve(x, y);
    length = y.normFrobenius();
    x.assign(y);
  }
  x.scale(1.0 / length);
  return length;
}

/// Collective. What the bodies of all ranks add up to.
CompressedRows sumOf(int unknowns, const std::vector<std::vector<int>>& coupled,
                     const std::vector<MacroFactor::Share>& shares, const Teuchos::Comm<int>& comm) {
  std::vector<std::set<int>> row(unknowns);
  for (const auto& list : coupled) {
    for (const int unknown : list) row[unknown].insert(list.begin(), list.end());
  }
  CompressedRows sum;
  for (int unknown = 0; unknown < unknowns; ++unknown) {
    row[unknown].insert(unknown);
    sum.columns.insert(sum.columns.end(), row[unknown].begin(), row[unknown].end());
    sum.rowPointers.push_back(sum.columns.size());
  }
  std::vector<double> local(sum.columns.size(), 0.0);
  for (const MacroFactor::Share& share : shares) {
    for (std::size_t i = 0; i < share.unknowns.size(); ++i) {
      for (std::size_t j = 0; j < share.unknowns.size(); ++j) {
        local[sum.at(share.unknowns[i], share.unknowns[j])] += meanOf(share.values, i, j);
      }
    }
  }
  sum.values.resize(local.size());
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(local.size()), local.data(), sum.values.data());
  return sum;
}

/// What the bodies of this rank add.
SymmetricEntries addendsOf(const std::vector<MacroFactor::Share>& shares) {
  SymmetricEntries addends;
  for (const MacroFactor::Share& share : shares) {
    for (std::size_t i = 0; i < share.unknowns.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        addends.rows.push_back(std::max(share.unknowns[i], share.unknowns[j]));
        addends.columns.push_back(std::min(share.unknowns[i], share.unknowns[j]));
        addends.values.push_back(meanOf(share.values, i, j));
      }
    }
  }
  return addends;
}

}  // namespace

MacroFactor::MacroFactor(int unknowns, const std::vector<std::vector<int>>& coupled, const std::vector<Share>& shares,
                         const substructure::SolverOptions& options, const Teuchos::RCP<const Teuchos::Comm<int>>& comm,
                         bool isKnownRegular)
    : unknowns_(unknowns) {
  const bool isShared = DistributedSolver::exists() && comm->getSize() > 1 && unknowns >= options.sharedFrom;
  std::function<void(double)> factorShifted;
  if (isShared) {
    factorShifted = [this, &comm, addends = addendsOf(shares)](double shift) {
      SymmetricEntries shifted(addends);
      for (int row = 0; row < unknowns_ && shift > 0.0 && comm->getRank() == 0; ++row) {
        shifted.rows.push_back(row);
        shifted.columns.push_back(row);
        shifted.values.push_back(shift);
      }
      shared_ = std::make_unique<DistributedSolver>(unknowns_, std::move(shifted), comm);
    };
  } else {
    factorShifted = [this, &options, isKnownRegular, sum = sumOf(unknowns, coupled, shares, *comm)](double shift) {
      std::vector<double> shifted(sum.values);
      for (int row = 0; row < unknowns_; ++row) shifted[sum.at(row, row)] += shift;
      const auto matrix = substructure::makeCrsMatrix(sum.rowPointers, sum.columns, shifted);
      own_ = std::make_unique<SubstructureSolver>(matrix, substructure::BoundaryTerm{}, options, "macro problem",
                                                  std::vector<int>{}, std::vector<base::Vector3>{}, isKnownRegular);
    };
  }
  // All ranks free a shared factor here, which none does where it throws.
  const auto release = [this] {
    own_.reset();
    shared_.reset();
  };
  double tooLittle = 0.0;  // a shift with which it is not definite: the smallest eigenvalue is below -tooLittle
  for (double shift = 0.0;; shift = std::max(leastShift, growthOfShift * shift)) {
    release();
    try {
      factorShifted(shift);
    } catch (const base::Error& error) {
      const bool lacksMemory =
          isShared && dynamic_cast<const DistributedSolver::NotPositiveDefinite*>(&error) == nullptr;
      if (lacksMemory || growthOfShift * shift > mostShift) throw;
      tooLittle = shift;
      continue;
    }
    Matrix motion(unknowns_, 1);
    const double length = iterateInversely(*this, motion);
    if (shift > 0.0) {
      release();
      const double smallest = 1.0 / length - shift;
      throw NotPositiveDefinite(tooLittle > 0.0 ? std::min(smallest, -tooLittle) : smallest,
                                {motion[0], motion[0] + motion.numRows()});
    }
    if (isKnownRegular || noStiffness * length < 1.0) {
      softness_ = std::max(1.0, length);
      return;
    }
  }
}

}  // namespace harmos::latin
