#pragma once

#include <string>
#include <vector>

#include <harmos/input/InputTree.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

/// Lists of parameters: declared next to what they configure, read from XML, checked, documented.
namespace harmos::input {

/// Checks a whole input against what `spec` declares and returns its values with all defaults filled in.
///
/// Each of `overrides` is "List/Sublist/Name=value" and replaces or adds one entry beforehand. A number may be written
/// "$name" and is then taken from the top-level list "Values"; a companion "<name> History" must name a child of the
/// top-level list "Histories". Throws one base::Error (input) that lists every error with file, line, list path, what
/// is allowed and how to repair it. Nothing of the arguments is kept. Histories are not attached: a varying number
/// whose history is named has no Parameters::schedule() before Parameters::attach(). Reads no file, and is not
/// collective.
Parameters check(InputTree input, const ParameterSpec& spec, const std::vector<std::string>& overrides = {});

}  // namespace harmos::input
