#pragma once

#include <optional>
#include <string>
#include <vector>

namespace harmos::base {

/// Shortest decimal text that reads back as exactly `value`; "inf" and "nan" for what is not finite.
std::string toText(double value);

/// The text without blanks, tabs and line breaks at either end.
std::string trimmed(const std::string& text);

/// The finite number that the whole of `text` denotes in decimal notation; nothing for "abc", "1e3x", "", "nan",
/// "1e999". Blanks at either end and a leading plus are allowed; the decimal sign is a point in every locale.
std::optional<double> parseNumber(const std::string& text);

/// The int that the whole of `text` denotes; nothing for "10.5", "1e3" or more than an int can hold. Blanks at either
/// end and a leading plus are allowed.
std::optional<int> parseInteger(const std::string& text);

/// The items of "{a, b, c}", without surrounding blanks; none of "{}"; nothing when a brace is missing or an item is
/// empty.
std::optional<std::vector<std::string>> parseItems(const std::string& text);

}  // namespace harmos::base
