#include <iostream>

#include <unistd.h>
#include <Tpetra_Core.hpp>

#include <harmos/base/BlasKernels.hpp>
#include <harmos/cli/CommandLine.hpp>

#include "Interrupt.hpp"
#include "OpenMpiSettings.hpp"

extern "C" {
// Present when the BLAS is OpenBLAS and when an OpenMP runtime is loaded.
__attribute__((weak)) void openblas_set_num_threads(int);
__attribute__((weak)) void omp_set_num_threads(int);
}

namespace {

// BLAS threads on the small blocks of a substructure cost more than they give; ranks are the way to use more cores.
void useOneThread() {
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  if (omp_set_num_threads) omp_set_num_threads(1);
}

}  // namespace

int main(int argc, char** argv) {
  harmos::base::useFittingBlasKernels(argv);
  useOneThread();
  OpenMpiSettings openMpi;
  catchInterrupts();
  // Kokkos and MPI get no arguments: Kokkos would answer --help itself.
  char* program[] = {argv[0], nullptr};
  char** programOnly = program;
  int one = 1;
  Tpetra::ScopeGuard scope(&one, &programOnly);
  openMpi.takeBack();
  const auto communicator = Tpetra::getDefaultComm();
  return harmos::cli::runCommandLine({argv + 1, argv + argc},
                                     {communicator, std::cout, std::cerr, isatty(STDERR_FILENO) != 0, wasInterrupted});
}
