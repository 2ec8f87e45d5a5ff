#pragma once

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include <Teuchos_SerialDenseMatrix.hpp>
#include <Teuchos_SerialSpdDenseSolver.hpp>

#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::substructure {

/// A symmetric positive definite matrix of a random graph: a random forest, so that rows have siblings in the
/// elimination tree, and some edges besides.
struct RandomSystem {
  explicit RandomSystem(unsigned seed) : random(seed) {
    size = 5 + draw(120);
    std::vector<std::set<int>> near(size);
    const auto join = [&](int a, int b) {
      if (a == b) return;
      near[a].insert(b);
      near[b].insert(a);
    };
    const int reach = 1 + draw(20);
    for (int i = 1; i < size; ++i) {
      if (draw(15) > 0) join(i, std::max(0, i - 1 - draw(reach)));
    }
    for (int extra = draw(size); extra > 0; --extra) join(draw(size), draw(size));

    std::vector<std::size_t> pointers{0};
    std::vector<int> columns;
    std::vector<double> values;
    dense.shape(size, size);
    for (int row = 0; row < size; ++row) {
      near[row].insert(row);
      for (const int column : near[row]) {
        // Diagonally dominant, and no two entries alike.
        const double value = row == column ? 1.0 + 2.0 * static_cast<double>(near[row].size())
                                           : -1.0 - 0.5 / (2.0 + std::min(row, column));
        columns.push_back(column);
        values.push_back(value);
        dense(row, column) = value;
      }
      pointers.push_back(columns.size());
    }
    matrix = makeCrsMatrix(pointers, columns, values);
    const int share = 1 + draw(6);
    for (int row = 0; row < size; ++row) {
      if (draw(share + 1) == 0) trace.push_back(row);
    }
    if (trace.empty()) trace.push_back(draw(size));
  }

  int draw(int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); }

  /// B A^-1 B^T for unit loads.
  base::Matrix inverseOnTrace() {
    const int count = static_cast<int>(trace.size());
    base::Matrix right(size, count), solution(size, count), result(count, count);
    for (int j = 0; j < count; ++j) right(trace[j], j) = 1.0;
    Teuchos::SerialSymDenseMatrix<int, double> symmetric(size);
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j <= i; ++j) symmetric(i, j) = dense(i, j);
    }
    Teuchos::SerialSpdDenseSolver<int, double> solver;
    solver.setMatrix(Teuchos::rcpFromRef(symmetric));
    solver.setVectors(Teuchos::rcpFromRef(solution), Teuchos::rcpFromRef(right));
    if (solver.factor() != 0 || solver.solve() != 0) throw std::runtime_error("the reference has no solution");
    for (int j = 0; j < count; ++j) {
      for (int i = 0; i < count; ++i) result(i, j) = solution(trace[i], j);
    }
    return result;
  }

  std::mt19937 random;
  int size = 0;
  base::Matrix dense;
  Teuchos::RCP<base::CrsMatrix> matrix;
  std::vector<int> trace;
};

}  // namespace harmos::substructure
