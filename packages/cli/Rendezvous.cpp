#include <harmos/cli/detail/Rendezvous.hpp>

#include <chrono>
#include <thread>

#include <mpi.h>
#include <Teuchos_DefaultMpiComm.hpp>

namespace harmos::cli {

bool Rendezvous::allCome(double seconds) const {
  if (comm_->getSize() == 1) return true;
  const auto& mpi = dynamic_cast<const Teuchos::MpiComm<int>&>(*comm_);
  MPI_Request request;
  MPI_Ibarrier(*mpi.getRawMpiComm(), &request);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  int areHere = 0;
  while (true) {
    MPI_Test(&request, &areHere, MPI_STATUS_IGNORE);
    if (areHere != 0 || std::chrono::steady_clock::now() > end) return areHere != 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace harmos::cli
