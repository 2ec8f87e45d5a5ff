#include <harmos/base/Names.hpp>

#include <algorithm>
#include <cctype>

namespace harmos::base {

namespace {

std::string lowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::size_t difference(std::size_t a, std::size_t b) {
  return a < b ? b - a : a - b;
}

/// Damerau-Levenshtein distance, restricted to one swap per pair of letters.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before = last;
    last = now;
  }
  return last[b.size()];
}

}  // namespace

std::string nearestName(const std::string& given, const std::vector<std::string>& known) {
  std::string nearest;
  const std::string wanted = lowerCase(given);
  std::size_t least = 2 + given.size() / 4;
  for (const std::string& name : known) {
    if (difference(given.size(), name.size()) >= least) continue;  // no distance is less
    const std::size_t distance = editDistance(wanted, lowerCase(name));
    if (distance < least && distance < name.size()) {
      least = distance;
      nearest = name;
    }
  }
  if (!nearest.empty() || given.size() < 3) return nearest;
  for (const std::string& name : known) {
    if (lowerCase(name).find(wanted) == std::string::npos) continue;
    if (!nearest.empty()) return "";
    nearest = name;
  }
  return nearest;
}

std::string joinNames(const std::vector<std::string>& names, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) text += (i ? ", " : "") + names[i];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

std::string suggestName(const std::string& given, const std::vector<std::string>& known, const std::string& kind) {
  const std::string nearest = nearestName(given, known);
  return (nearest.empty() ? "" : "Did you mean \"" + nearest + "\"? ") + kind + ": " +
         (known.empty() ? "none" : joinNames(known)) + ".";
}

}  // namespace harmos::base
