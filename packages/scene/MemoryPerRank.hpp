#pragma once

#include <Teuchos_Comm.hpp>

namespace harmos::scene {

/// Memory [byte] that one rank may have, the least of all, where ranks share a machine. Collective.
double memoryPerRank(const Teuchos::Comm<int>& comm);

/// What all ranks may have together [byte], each as much. Collective.
double memoryOfAllRanks(const Teuchos::Comm<int>& comm);

}  // namespace harmos::scene
