#include "OpenMpiSettings.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace {

// Set by mpirun, by launchers that speak PMIx or PMI, and by Slurm, for every process that they start.
constexpr std::array<const char*, 6> launched = {
    "OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMIX_NAMESPACE", "PMI_RANK", "PMI_FD", "SLURM_PROCID"};
constexpr const char* processesHereVariable = "OMPI_COMM_WORLD_LOCAL_SIZE";

// Without a daemon, or anything but itself to talk to, of which it wants no list of devices.
constexpr std::array<std::pair<const char*, const char*>, 5> alone = {{{"OMPI_MCA_ess_singleton_isolated", "1"},
                                                                       {"OMPI_MCA_pml", "ob1"},
                                                                       {"OMPI_MCA_btl", "self"},
                                                                       {"OMPI_MCA_coll", "self,basic,libnbc"},
                                                                       {"HWLOC_COMPONENTS", "-pci,-linuxio"}}};

bool isSet(const char* name) {
  return std::getenv(name) != nullptr;
}

/// Whether mpirun has started all processes on one machine.
bool areAllHere() {
  const char* const all = std::getenv("OMPI_COMM_WORLD_SIZE");
  const char* const here = std::getenv(processesHereVariable);
  return all != nullptr && here != nullptr && std::string(all) == here;
}

}  // namespace

OpenMpiSettings::OpenMpiSettings() {
  if (!isSet("OMPI_COMM_WORLD_SIZE")) ::setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  ::setenv("OMPI_MCA_opal_signal", "", 0);
  ::setenv("OMPI_MCA_mpi_warn_on_fork", "0", 0);
  if (!std::any_of(launched.begin(), launched.end(), isSet)) {
    for (const auto& [name, value] : alone) setForNow(name, value);
  } else if (areAllHere()) {
    setForNow("OMPI_MCA_pml", "ob1");
  }
}

int OpenMpiSettings::processesHere() {
  const char* const here = std::getenv(processesHereVariable);
  return here == nullptr ? 1 : std::max(1, std::atoi(here));
}

void OpenMpiSettings::setForNow(const char* name, const char* value) {
  if (isSet(name)) return;
  ::setenv(name, value, 0);
  own_.emplace_back(name);
}

void OpenMpiSettings::takeBack() {
  for (const std::string& name : own_) ::unsetenv(name.c_str());
  own_.clear();
}
