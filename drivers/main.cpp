#include <cstdlib>
#include <iostream>

#include <unistd.h>
#include <Tpetra_Core.hpp>

#include <harmos/base/BlasKernels.hpp>
#include <harmos/cli/CommandLine.hpp>

#include "Interrupt.hpp"

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

/// What Open MPI must not do, unless the user wants it to: its own handlers of SIGSEGV and others print stacks and may
/// hang in a damaged heap for minutes, and it takes the short-lived processes that read files for a mistake. A process
/// that mpirun has not started needs no folder for its session either, which fails where many start at once.
void tameOpenMpi() {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr) ::setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  ::setenv("OMPI_MCA_opal_signal", "", 0);
  ::setenv("OMPI_MCA_mpi_warn_on_fork", "0", 0);
}

}  // namespace

int main(int argc, char** argv) {
  harmos::base::useFittingBlasKernels(argv);
  useOneThread();
  tameOpenMpi();
  catchInterrupts();
  // Kokkos and MPI get no arguments: Kokkos would answer --help itself.
  char* program[] = {argv[0], nullptr};
  char** programOnly = program;
  int one = 1;
  Tpetra::ScopeGuard scope(&one, &programOnly);
  const auto communicator = Tpetra::getDefaultComm();
  return harmos::cli::runCommandLine({argv + 1, argv + argc},
                                     {communicator, std::cout, std::cerr, isatty(STDERR_FILENO) != 0, wasInterrupted});
}
