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

/// The same for a change from elsewhere; a path that does not exist is reported at `where`. Returns whether the entry
/// was changed.
bool applyChange(InputTree& input, const ParameterSpec& spec, const EntryChange& change, const std::string& where,
                 ErrorList& errors);

/// The type of the entry "List/Sublist/Name", which the input may omit. Nothing when there is no such path, which is
/// reported at `where`, or when the input writes a list on the way as a parameter, which check() reports.
std::optional<ParameterType> typeOf(const InputTree& input, const ParameterSpec& spec, const std::string& entry,
                                    const std::string& where, ErrorList& errors);

}  // namespace harmos::input
