#include <harmos/base/OneThread.hpp>

extern "C" {
// Present when the BLAS is OpenBLAS and when an OpenMP runtime is loaded.
__attribute__((weak)) void openblas_set_num_threads(int);
__attribute__((weak)) void omp_set_num_threads(int);
__attribute__((weak)) void omp_set_max_active_levels(int);
}

namespace harmos::base {

void useOneThread() {
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  if (omp_set_num_threads) omp_set_num_threads(1);
  // CHOLMOD asks for four whatever is set; where no level is active, one thread does the work of all.
  if (omp_set_max_active_levels) omp_set_max_active_levels(0);
}

}  // namespace harmos::base
