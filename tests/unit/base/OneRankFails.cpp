// One rank throws while the others wait for it: run on two ranks, the program must end with the exit code of the error.
#include <iostream>

#include <Tpetra_Core.hpp>

#include <harmos/base/AllRanks.hpp>
#include <harmos/base/Error.hpp>

int main(int argc, char** argv) {
  Tpetra::ScopeGuard scope(&argc, &argv);
  const auto comm = Tpetra::getDefaultComm();
  const bool isAlone = argc > 1 && std::string(argv[1]) == "alone";
  const auto program = [&] {
    if (comm->getRank() == 1 || !isAlone)
      throw harmos::base::Error("a law fails", harmos::base::ExitCode::notConverged);
    comm->barrier();
    return 0;
  };
  return harmos::base::runOnAllRanks(*comm, program, std::cerr);
}
