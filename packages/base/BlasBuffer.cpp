#include <harmos/base/BlasBuffer.hpp>

#include <cstddef>
#include <cstdlib>
#include <new>

#include <sys/resource.h>

#include <Teuchos_LAPACK.hpp>

// Present when the BLAS is OpenBLAS.
extern "C" __attribute__((weak)) char* openblas_get_corename();

namespace harmos::base {
namespace {

// What OpenBLAS asks for at once, and a little more [byte].
constexpr std::size_t wanted = std::size_t{129} << 20U;

}  // namespace

void reserveBlasBuffer() {
  rlimit limit{};
  if (!openblas_get_corename || getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  void* const trial = std::malloc(wanted);
  if (trial == nullptr) throw std::bad_alloc();
  std::free(trial);
  // A product with a symmetric matrix, as in the eigenvalues of this one, needs the buffer whatever its size.
  constexpr int n = 3;
  double matrix[n * n] = {2.0, 1.0, 0.0, 1.0, 2.0, 1.0, 0.0, 1.0, 2.0}, values[n], work[34 * n];
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('N', 'U', n, matrix, n, values, work, 34 * n, &info);
}

}  // namespace harmos::base
