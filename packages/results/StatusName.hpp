#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/results/ConfigurationResult.hpp>

namespace harmos::results {

/// The status as users read it in tables: certified, calibrated, reopened, not converged, no equilibrium, failed,
/// inadmissible; with ", not unique" after the first two where the problem does not determine all responses.
const char* statusName(Status status);

/// Nothing when there is no such status.
std::optional<Status> statusNamed(const std::string& name);

/// Whether the solution meets the accuracy asked for.
bool isSolved(Status status);

/// Whether a certificate of its own says so.
bool isCertified(Status status);

/// All of them, in the order of the enumeration.
const std::vector<Status>& allStatuses();

}  // namespace harmos::results
