#pragma once

#include <optional>
#include <string>
#include <vector>

namespace harmos::base {

/// Shortest decimal text that reads back as exactly `value`.
std::string toText(double value);
/// Without blanks and line breaks at either end.
std::string trimmed(const std::string& text);

/// The finite number that the whole of `text` denotes in decimal notation; nothing for "abc", "1e3x", "", "nan",
/// "1e999".
std::optional<double> parseNumber(const std::string& text);

/// The int that the whole of `text` denotes; nothing for "10.5", "1e3" or more than an int can hold.
std::optional<int> parseInteger(const std::string& text);

/// The items of "{a, b, c}", without surrounding blanks; nothing when a brace is missing or an item is empty.
std::optional<std::vector<std::string>> parseItems(const std::string& text);

}  // namespace harmos::base
