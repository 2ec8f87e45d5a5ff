#pragma once

#include <string>

#include <harmos/base/ErrorList.hpp>
#include <harmos/base/InputTree.hpp>
#include <harmos/base/ParameterSpec.hpp>

namespace harmos::base {

/// Applies "List/Sublist/Name=value" to a tree that `spec` describes: replaces the entry, or adds it (and the lists of
/// fixed name above it) when the input omits it. Lists and values named by the user must be there. Reports a path that
/// does not exist to `errors`; the value itself is left to check().
void applyOverride(InputTree& input, const ParameterSpec& spec, const std::string& assignment, ErrorList& errors);

}  // namespace harmos::base
