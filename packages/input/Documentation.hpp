#pragma once

#include <string>
#include <vector>

#include <harmos/input/ParameterSpec.hpp>

namespace harmos::input {

/// Reference of all that `spec` declares, in Markdown: name, type, unit, default or required, range, doc and source of
/// every parameter, and a snippet of XML for every list; a type that is allowed in several lists is described once.
/// `topic` restricts it to the lists and types of this name; empty: all. Throws base::Error (input), listing the
/// topics, when there is no such one.
std::string documentation(const ParameterSpec& spec, const std::string& topic = "");

/// What a reference says besides what inputs declare.
struct Page {
  std::string name;  // its topic and heading
  std::string text;  // in Markdown, ending with a line break
};

/// The same for several inputs, one after the other, and then for pages; `topic` need be in one of them only.
std::string documentation(const std::vector<ParameterSpec>& specs, const std::string& topic = "",
                          const std::vector<Page>& pages = {});

}  // namespace harmos::input
