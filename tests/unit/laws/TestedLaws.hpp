#pragma once

#include <string>
#include <vector>

#include <harmos/laws/LawRegistry.hpp>

namespace harmos::laws {

/// The laws that the conformance suite runs on; each program of the suite has its own.
LawRegistry testedLaws();
/// Names of those among them that it leaves out: laws that are no matter of single points.
std::vector<std::string> untestedLaws();

}  // namespace harmos::laws
