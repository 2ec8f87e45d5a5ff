#include <harmos/base/detail/Rendezvous.hpp>

#include <chrono>
#include <thread>

#include <mpi.h>
#include <Teuchos_DefaultMpiComm.hpp>

namespace harmos::base {

std::optional<std::vector<int>> Rendezvous::meet(int word, double seconds) const {
  if (comm_->getSize() == 1) return std::vector<int>{word};
  const auto& mpi = dynamic_cast<const Teuchos::MpiComm<int>&>(*comm_);
  std::vector<int> words(static_cast<std::size_t>(comm_->getSize()));
  MPI_Request request;
  MPI_Iallgather(&word, 1, MPI_INT, words.data(), 1, MPI_INT, *mpi.getRawMpiComm(), &request);
  const auto begin = std::chrono::steady_clock::now();
  int areHere = 0;
  while (true) {
    MPI_Test(&request, &areHere, MPI_STATUS_IGNORE);
    if (areHere != 0) return words;
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > seconds) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace harmos::base
