#include <harmos/statics/FreeMotions.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Matrix.hpp>

namespace harmos::statics {
namespace {

// Eigenvalues of the sum of squared jumps below this share of the largest are round-off: jumps of 1e-6 of the size.
// Coordinates of a mesh may have seven digits only.
constexpr double unheld = 1e-12;

/// Eigenvalues in ascending order; the columns of `matrix` become the eigenvectors.
std::vector<double> eigenvalues(base::Matrix& matrix) {
  const int n = matrix.numRows();
  std::vector<double> values(n), work(std::max(1, 34 * n));
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', n, matrix.values(), matrix.stride(), values.data(), work.data(),
                                      static_cast<int>(work.size()), &info);
  if (info != 0) throw base::Error("LAPACK dsyev failed with info = " + std::to_string(info));
  return values;
}

/// Reduced column echelon form of the first `count` columns, pivots by size: motions of single bodies along single axes
/// where the space has such.
void reduce(base::Matrix& vectors, int count) {
  std::vector<bool> isPivot(static_cast<std::size_t>(vectors.numRows()), false);
  for (int j = 0; j < count; ++j) {
    int pivot = -1;
    for (int row = 0; row < vectors.numRows(); ++row) {
      if (!isPivot[row] && (pivot < 0 || std::abs(vectors(row, j)) > std::abs(vectors(pivot, j)))) pivot = row;
    }
    isPivot[pivot] = true;
    const double scale = 1.0 / vectors(pivot, j);
    for (int row = 0; row < vectors.numRows(); ++row) vectors(row, j) *= scale;
    for (int other = 0; other < count; ++other) {
      const double share = vectors(pivot, other);
      if (other == j || share == 0.0) continue;
      for (int row = 0; row < vectors.numRows(); ++row) vectors(row, other) -= share * vectors(row, j);
    }
  }
}

/// Sum of squared jumps along the holds as a form of the unknowns, those of a hold given as work terms.
void addSquares(const std::vector<WorkTerm>& jump, base::Matrix& squares) {
  for (const WorkTerm& a : jump) {
    for (const WorkTerm& b : jump) squares(a.index, b.index) += a.value * b.value;
  }
}

/// The motions that a form does not feel, as the first columns of `squares`; returns how many.
int nullSpace(base::Matrix& squares, int motions) {
  const int unknowns = squares.numRows();
  // Bodies that one joint holds count as much as those that many do.
  std::vector<double> scale(static_cast<std::size_t>(unknowns));
  for (int first = 0; first < unknowns; first += motions) {
    double largest = 0.0;
    for (int i = first; i < first + motions; ++i) largest = std::max(largest, squares(i, i));
    for (int i = first; i < first + motions; ++i) scale[i] = largest > 0.0 ? 1.0 / std::sqrt(largest) : 1.0;
  }
  for (int j = 0; j < unknowns; ++j) {
    for (int i = 0; i < unknowns; ++i) squares(i, j) *= scale[i] * scale[j];
  }
  const std::vector<double> values = eigenvalues(squares);
  const double threshold = unheld * std::max(1.0, values.back());
  const auto count =
      static_cast<int>(std::count_if(values.begin(), values.end(), [&](double v) { return v <= threshold; }));
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < unknowns; ++i) squares(i, j) *= scale[i];
  }
  return count;
}

/// Which bodies are fixed to the ground, one after the other: what is left is small even in large assemblies.
std::vector<bool> findFixed(const RigidAssembly& assembly, const std::vector<std::vector<WorkTerm>>& jumps) {
  const int motions = assembly.motions();
  std::vector<bool> isFixed(assembly.bodies.size(), false);
  std::vector<base::Matrix> squares(assembly.bodies.size(), base::Matrix(motions, motions));
  for (bool goesOn = true; goesOn;) {
    goesOn = false;
    for (auto& form : squares) form.putScalar(0.0);
    for (const auto& jump : jumps) {
      int body = -1;
      bool isSingle = true;
      for (const WorkTerm& term : jump) {
        const int other = term.index / motions;
        if (isFixed[other]) continue;
        isSingle = isSingle && (body < 0 || body == other);
        body = other;
      }
      if (body < 0 || !isSingle) continue;
      std::vector<WorkTerm> mine;
      for (const WorkTerm& term : jump) {
        if (term.index / motions == body) mine.push_back({term.index % motions, term.value});
      }
      addSquares(mine, squares[body]);
    }
    for (std::size_t b = 0; b < squares.size(); ++b) {
      if (isFixed[b] || nullSpace(squares[b], motions) > 0) continue;
      isFixed[b] = goesOn = true;
    }
  }
  return isFixed;
}

}  // namespace

std::vector<std::vector<Motion>> findFreeMotions(const RigidAssembly& assembly, const std::vector<Hold>& holds) {
  const int motions = assembly.motions();
  std::vector<std::vector<WorkTerm>> jumps;
  for (const Hold& hold : holds) jumps.push_back(workOf(assembly, assembly.joints[hold.joint], hold.direction));
  for (const Coupling& coupling : assembly.couplings) jumps.push_back(workOf(assembly, coupling));
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    for (int i = 0; i < motions; ++i) {
      if (assembly.bodies[b].isHeld[i]) jumps.push_back({{motions * static_cast<int>(b) + i, 1.0}});
    }
  }
  const std::vector<bool> isFixed = findFixed(assembly, jumps);
  std::vector<int> first(assembly.bodies.size(), -1);
  int unknowns = 0;
  for (std::size_t b = 0; b < first.size(); ++b) {
    if (isFixed[b]) continue;
    first[b] = unknowns;
    unknowns += motions;
  }
  if (unknowns == 0) return {};
  base::Matrix squares(unknowns, unknowns);
  for (const auto& jump : jumps) {
    std::vector<WorkTerm> left;
    for (const WorkTerm& term : jump) {
      const int body = term.index / motions;
      if (!isFixed[body]) left.push_back({first[body] + term.index % motions, term.value});
    }
    addSquares(left, squares);
  }
  const int count = nullSpace(squares, motions);
  reduce(squares, count);
  std::vector<std::vector<Motion>> free;
  for (int j = 0; j < count; ++j) {
    std::vector<double> all(assembly.bodies.size() * static_cast<std::size_t>(motions), 0.0);
    for (std::size_t b = 0; b < first.size(); ++b) {
      for (int i = 0; first[b] >= 0 && i < motions; ++i) {
        const double value = squares(first[b] + i, j);
        if (std::abs(value) >= std::sqrt(unheld)) all[b * static_cast<std::size_t>(motions) + i] = value;
      }
    }
    free.push_back(motionsOf(assembly, all));
  }
  return free;
}

}  // namespace harmos::statics
