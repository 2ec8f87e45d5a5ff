#include <harmos/files/Tolerances.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::files {

namespace {

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

/// One line of the file, for messages.
struct Place {
  std::string file;
  int line;
  [[noreturn]] void fail(const std::string& what) const {
    throw base::Error(file + ", line " + std::to_string(line) + ": " + what, base::ExitCode::input);
  }
};

double nonNegative(const std::string& word, const Place& place) {
  const auto number = base::parseNumber(word);
  if (!number || *number < 0.0) place.fail("\"" + word + "\" is not a number of at least 0.");
  return *number;
}

// Reads "[relative|absolute|combined|ignore] [number] [floor number]" and keeps what is not given.
Tolerance parseTolerance(Tolerance tolerance, std::vector<std::string> rest, const Place& place) {
  const std::vector<std::string> kinds{"relative", "absolute", "combined", "ignore"};
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const std::string word = lowerCase(rest[i]);
    const auto kind = std::find(kinds.begin(), kinds.end(), word);
    if (kind != kinds.end()) {
      tolerance.kind = static_cast<Tolerance::Kind>(kind - kinds.begin());
    } else if (word == "floor") {
      if (++i == rest.size()) place.fail("\"floor\" wants a number after it.");
      tolerance.floor = nonNegative(rest[i], place);
    } else if (base::parseNumber(word)) {
      tolerance.value = nonNegative(word, place);
    } else {
      auto allowed = kinds;
      allowed.push_back("floor");
      place.fail("unknown word \"" + rest[i] + "\". " + base::suggestName(rest[i], allowed, "A tolerance may hold"));
    }
  }
  return tolerance;
}

}  // namespace

double Tolerance::difference(double a, double b) const {
  if (kind == Kind::ignore) return 0.0;
  if (!std::isfinite(a) || !std::isfinite(b)) return std::numeric_limits<double>::infinity();
  const double larger = std::max(std::abs(a), std::abs(b));
  if (larger <= floor) return 0.0;
  const double distance = std::abs(a - b);
  if (kind == Kind::relative) return larger > 0.0 ? distance / larger : 0.0;
  if (kind == Kind::combined) return distance / std::max(larger, 1.0);
  return distance;
}

std::string Tolerance::text() const {
  static const char* const names[] = {"relative", "absolute", "combined", "ignore"};
  std::string result = names[static_cast<int>(kind)];
  if (kind == Kind::ignore) return result;
  result += " " + base::toText(value);
  if (floor > 0.0) result += " floor " + base::toText(floor);
  return result;
}

Tolerances::Tolerances() {
  for (auto& s : sections_) s.present = s.all = true;
}

Tolerances Tolerances::read(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw base::Error("Cannot read the tolerances in " + path + ".", base::ExitCode::input);
  std::ostringstream text;
  text << stream.rdbuf();
  return parse(text.str(), path);
}

Tolerances Tolerances::parse(const std::string& text, const std::string& nameInMessages) {
  Tolerances result;
  for (auto& s : result.sections_) s = Section{};
  Tolerance standard;
  Section* current = nullptr;
  bool comparesSomething = false;
  std::istringstream stream(text);
  Place place{nameInMessages, 0};
  for (std::string line; std::getline(stream, line);) {
    ++place.line;
    line.erase(std::min(line.find('#'), line.size()));
    auto rest = words(line);
    if (rest.empty()) continue;
    if (std::isspace(static_cast<unsigned char>(line[0]))) {
      if (!current) place.fail("an indented line names a variable and must follow a line such as NODAL VARIABLES.");
      Variable variable;
      variable.excluded = rest[0][0] == '!';
      variable.name = lowerCase(rest[0].substr(variable.excluded ? 1 : 0));
      rest.erase(rest.begin());
      variable.tolerance = parseTolerance(current->tolerance, rest, place);
      current->variables.push_back(variable);
      continue;
    }
    current = nullptr;
    const std::string first = lowerCase(rest[0]), second = rest.size() > 1 ? lowerCase(rest[1]) : "";
    const std::size_t keywords = first == "coordinates" ? 1 : 2;
    const auto after = [&] {
      return std::vector<std::string>(rest.begin() + static_cast<std::ptrdiff_t>(std::min(keywords, rest.size())),
                                      rest.end());
    };
    if (first == "coordinates") {
      result.coordinates_ = parseTolerance(standard, after(), place);
    } else if (first == "time" && second == "steps") {
      result.times_ = parseTolerance(standard, after(), place);
    } else if (first == "default" && second == "tolerance") {
      standard = parseTolerance(standard, after(), place);
      continue;
    } else if (second == "variables" && (first == "global" || first == "nodal" || first == "element")) {
      current = &result.section(first == "global"  ? VariableKind::global
                                : first == "nodal" ? VariableKind::nodal
                                                   : VariableKind::element);
      auto remaining = after();
      const auto all = std::find_if(remaining.begin(), remaining.end(),
                                    [](const std::string& word) { return lowerCase(word) == "(all)"; });
      current->present = true;
      current->all = all != remaining.end();
      if (current->all) remaining.erase(all);
      current->tolerance = parseTolerance(standard, remaining, place);
    } else {
      place.fail("unknown command \"" + rest[0] + (second.empty() ? "" : " " + rest[1]) +
                 "\". Known are DEFAULT TOLERANCE, COORDINATES, TIME STEPS, GLOBAL VARIABLES, NODAL VARIABLES, ELEMENT "
                 "VARIABLES; the lines of variables are indented.");
    }
    comparesSomething = true;
  }
  if (!comparesSomething) {
    throw base::Error(nameInMessages + " names nothing to compare.\n  Write for example NODAL VARIABLES relative 1e-6.",
                      base::ExitCode::input);
  }
  return result;
}

std::optional<Tolerance> Tolerances::find(VariableKind kind, const std::string& variable) const {
  const Section& s = section(kind);
  if (!s.present) return std::nullopt;
  const std::string name = lowerCase(variable);
  for (const auto& entry : s.variables)
    if (entry.name == name) return entry.excluded ? std::nullopt : std::optional<Tolerance>(entry.tolerance);
  const bool onlyExclusions =
      std::all_of(s.variables.begin(), s.variables.end(), [](const Variable& entry) { return entry.excluded; });
  return s.all || onlyExclusions ? std::optional<Tolerance>(s.tolerance) : std::nullopt;
}

std::vector<std::string> Tolerances::requested(VariableKind kind) const {
  std::vector<std::string> names;
  for (const auto& entry : section(kind).variables)
    if (!entry.excluded) names.push_back(entry.name);
  return names;
}

double Tolerances::distance(double size) const {
  return coordinates_.kind == Tolerance::Kind::absolute ? coordinates_.value : coordinates_.value * size;
}

}  // namespace harmos::files
