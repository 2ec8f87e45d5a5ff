#include <harmos/base/AvailableMemory.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

namespace harmos::base {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

double freeOnMachine() {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  double kilobytes = 0.0;
  while (file >> name >> kilobytes) {
    if (name == "MemAvailable:") return 1024.0 * kilobytes;
    std::getline(file, unit);
  }
  return unlimited;
}

/// The first number of a file; infinite when there is none, such as "max".
double numberIn(const std::string& path) {
  std::ifstream file(path);
  double value = 0.0;
  return file >> value ? value : unlimited;
}

/// Of what a group uses, files that were read can be dropped.
double droppable(const std::string& group) {
  std::ifstream file(group + "memory.stat");
  std::string name;
  double bytes = 0.0;
  while (file >> name >> bytes) {
    if (name == "inactive_file" || name == "total_inactive_file") return bytes;
  }
  return 0.0;
}

double leftBy(const std::string& group, const char* limit, const char* used) {
  const double most = numberIn(group + limit), now = numberIn(group + used);
  return std::isfinite(most) && std::isfinite(now) ? std::max(0.0, most - now + droppable(group)) : unlimited;
}

/// By the process's own group and all that hold it: of version 2, and of version 1 as a container sees it.
double leftByControlGroups() {
  const std::string root = "/sys/fs/cgroup";
  double left = leftBy(root + "/memory/", "memory.limit_in_bytes", "memory.usage_in_bytes");
  std::ifstream groups("/proc/self/cgroup");
  std::string line;
  while (std::getline(groups, line)) {
    if (line.compare(0, 3, "0::") != 0) continue;
    for (std::string path = line.substr(3);; path.erase(path.find_last_of('/'))) {
      left = std::min(left, leftBy(root + path + "/", "memory.max", "memory.current"));
      if (path.find('/') == std::string::npos) break;
    }
  }
  return left;
}

double leftByOwnLimit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  const double used = numberIn("/proc/self/statm") * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - used);
}

}  // namespace

double availableMemory() {
  return std::min({freeOnMachine(), leftByControlGroups(), leftByOwnLimit()});
}

}  // namespace harmos::base
