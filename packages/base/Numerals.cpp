#include <harmos/base/Numerals.hpp>

#include <charconv>
#include <cmath>

namespace harmos::base {

namespace {

template <class T>
std::optional<T> parse(const std::string& text) {
  const std::string digits = trimmed(text);
  const char* begin = digits.data();
  const char* end = begin + digits.size();
  // std::from_chars refuses a leading plus.
  if (digits.size() > 1 && *begin == '+' && begin[1] != '-') ++begin;
  T value{};
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace

std::string trimmed(const std::string& text) {
  const char* blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string toText(double value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, result.ptr);
}

std::optional<double> parseNumber(const std::string& text) {
  const auto value = parse<double>(text);
  if (value && !std::isfinite(*value)) return std::nullopt;
  return value;
}

std::optional<int> parseInteger(const std::string& text) {
  return parse<int>(text);
}

std::optional<std::vector<std::string>> parseItems(const std::string& text) {
  const std::string inner = trimmed(text);
  if (inner.size() < 2 || inner.front() != '{' || inner.back() != '}') return std::nullopt;
  std::vector<std::string> items;
  const std::string body = trimmed(inner.substr(1, inner.size() - 2));
  if (body.empty()) return items;
  for (std::size_t begin = 0; begin <= body.size();) {
    const std::size_t end = std::min(body.find(',', begin), body.size());
    items.push_back(trimmed(body.substr(begin, end - begin)));
    if (items.back().empty()) return std::nullopt;
    begin = end + 1;
  }
  return items;
}

}  // namespace harmos::base
