#include <harmos/scene/MemoryPerRank.hpp>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <unistd.h>
#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/AvailableMemory.hpp>

namespace harmos::scene {
namespace {

/// How many ranks share the machine of this one. Collective.
int ranksHere(const Teuchos::Comm<int>& comm) {
  char name[256] = {};
  gethostname(name, sizeof(name) - 1);
  const int mine = static_cast<int>(std::hash<std::string>()(name) & 0x7fffffff);
  std::vector<int> all(comm.getSize());
  Teuchos::gatherAll(comm, 1, &mine, comm.getSize(), all.data());
  return static_cast<int>(std::count(all.begin(), all.end(), mine));
}

}  // namespace

double memoryPerRank(const Teuchos::Comm<int>& comm) {
  const double mine = base::availableMemory() / ranksHere(comm);
  double least = mine;
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MIN, mine, Teuchos::outArg(least));
  return least;
}

double memoryOfAllRanks(const Teuchos::Comm<int>& comm) {
  return comm.getSize() * memoryPerRank(comm);
}

}  // namespace harmos::scene
