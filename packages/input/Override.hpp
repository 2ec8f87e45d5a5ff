#pragma once

#include <optional>
#include <string>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/InputTree.hpp>
#include <harmos/input/ParameterSpec.hpp>

namespace harmos::input {

/// Applies "List/Sublist/Name=value" to a tree that `spec` describes: replaces the entry, or adds it (and the lists of
/// fixed name above it) when the input omits it. Lists and values named by the user must be there. Reports a path that
/// does not exist, or an assignment without "=", to `errors`; the value itself is left to check(). Blanks around the
/// names and the value do not count.
void applyOverride(InputTree& input, const ParameterSpec& spec, const std::string& assignment, ErrorList& errors);

/// What replaces an entry, and on whose behalf.
struct EntryChange {
  std::string path;      // "List/Sublist/Name", without blanks around the slashes
  std::string value;     // as it would be written in XML; not checked
  std::string location;  // of the changed entry from then on, in messages about its value
};

/// The same for a change from elsewhere; a path that does not exist is reported at `where`. Returns the type of the
/// entry, nothing when it was not changed. A list on the way that the input writes as a parameter is left to check(),
/// which reports it; lists that were added on the way stay, even when the path leads nowhere.
std::optional<ParameterType> applyChange(InputTree& input, const ParameterSpec& spec, const EntryChange& change,
                                         const std::string& where, ErrorList& errors);

}  // namespace harmos::input
