#include <harmos/base/MachineSpeed.hpp>

#include <algorithm>
#include <array>
#include <ctime>
#include <vector>

#include <sys/resource.h>
#include <Teuchos_BLAS.hpp>

#include <harmos/base/Matrix.hpp>

namespace harmos::base {
namespace {

// CPU seconds of a round where a run of the bolted joint takes what its rates say.
constexpr double usualSeconds = 0.0033;
constexpr std::size_t rounds = 15;

/// What a round works on.
struct Work {
  Matrix factors, products, large;
  std::vector<double> x, y, keys;
};

/// A sum of results, so that no work can be left out.
double workOnce(Work& work) {
  constexpr int multiplications = 6, readings = 2;
  constexpr std::size_t cleared = 1 << 18;  // doubles
  const Teuchos::BLAS<int, double> blas;
  for (int i = 0; i < multiplications; ++i)
    work.products.multiply(Teuchos::NO_TRANS, Teuchos::TRANS, 1.0, work.factors, work.factors, 0.0);
  for (int i = 0; i < readings; ++i) {
    blas.GEMV(Teuchos::TRANS, work.large.numRows(), work.large.numCols(), 1.0, work.large.values(), work.large.stride(),
              work.x.data(), 1, 0.0, work.y.data(), 1);
  }
  unsigned state = 1;
  for (double& key : work.keys) key = state = 1664525U * state + 1013904223U;
  std::sort(work.keys.begin(), work.keys.end());
  const std::vector<double> clear(cleared, 0.0);
  return work.products(0, 0) + work.y.front() + work.keys.front() + clear.back();
}

double medianSeconds() {
  constexpr int size = 160, rows = 2000, columns = 1000, keys = 20000;
  Work work{Matrix(size, size), Matrix(size, size), Matrix(rows, columns), {}, {}, {}};
  work.factors.putScalar(1.0);
  work.large.putScalar(1.0);
  work.x.assign(rows, 1.0);
  work.y.assign(columns, 0.0);
  work.keys.assign(keys, 0.0);
  std::array<double, rounds> taken{};
  for (double& one : taken) {
    const std::clock_t begin = std::clock();
    volatile double result = workOnce(work);
    static_cast<void>(result);
    one = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  }
  std::sort(taken.begin(), taken.end());
  return taken[rounds / 2];
}

}  // namespace

double machineSlowness() {
  // Where addresses are limited OpenBLAS may try for ever to get its buffer.
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) return 1.0;
  return medianSeconds() / usualSeconds;
}

}  // namespace harmos::base
