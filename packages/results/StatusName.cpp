#include <harmos/results/StatusName.hpp>

namespace harmos::results {

const char* statusName(Status status) {
  switch (status) {
    case Status::certified:
      return "certified";
    case Status::certifiedNotUnique:
      return "certified, not unique";
    case Status::calibrated:
      return "calibrated";
    case Status::calibratedNotUnique:
      return "calibrated, not unique";
    case Status::reopened:
      return "reopened";
    case Status::notConverged:
      return "not converged";
    case Status::noEquilibrium:
      return "no equilibrium";
    case Status::failed:
      return "failed";
    case Status::inadmissible:
      return "inadmissible";
  }
  return "";
}

std::optional<Status> statusNamed(const std::string& name) {
  for (const Status status : allStatuses()) {
    if (name == statusName(status)) return status;
  }
  return std::nullopt;
}

bool isSolved(Status status) {
  return isCertified(status) || status == Status::calibrated || status == Status::calibratedNotUnique;
}

bool isCertified(Status status) {
  return status == Status::certified || status == Status::certifiedNotUnique;
}

const std::vector<Status>& allStatuses() {
  static const std::vector<Status> all = {
      Status::certified,   Status::certifiedNotUnique, Status::calibrated,    Status::calibratedNotUnique,
      Status::reopened,    Status::notConverged,       Status::noEquilibrium, Status::failed,
      Status::inadmissible};
  return all;
}

}  // namespace harmos::results
