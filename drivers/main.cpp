#include <iostream>

#include <unistd.h>
#include <Tpetra_Core.hpp>

#include <harmos/base/BlasKernels.hpp>
#include <harmos/base/OneThread.hpp>
#include <harmos/cli/CommandLine.hpp>

#include "Heap.hpp"
#include "Interrupt.hpp"
#include "OpenMpiSettings.hpp"

int main(int argc, char** argv) {
  harmos::base::useFittingBlas(argv);
  harmos::base::useOneThread();
  keepFreedMemory();
  useHugePages(OpenMpiSettings::processesHere());
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
