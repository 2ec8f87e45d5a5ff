#include <harmos/input/detail/ValueReader.hpp>

#include <algorithm>

#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::input {

namespace {

using Names = std::vector<std::string>;

/// The XML types in which a parameter may be given, the usual one first.
Names acceptedTypes(ParameterType type) {
  switch (type) {
    case ParameterType::number:
      return {"double", "int"};
    case ParameterType::numbers:
      return {"Array(double)", "Array(int)"};
    default:
      return {xmlType(type)};
  }
}

}  // namespace

std::string parameterExample(const ParameterEntry& entry) {
  return "<Parameter name=" + base::quoted(entry.name) + " type=" + base::quoted(xmlType(entry.type)) +
         " value=\"...\"/>";
}

ValueReader::ValueReader(const InputNode& root, ErrorList& errors) : errors_(errors) {
  if (const InputNode* values = root.child("Values")) {
    for (const InputNode& value : values->children) {
      const std::string* text = value.attribute("value");
      values_.emplace(value.name(), text ? base::parseNumber(*text) : std::nullopt);
    }
  }
  if (const InputNode* histories = root.child("Histories")) {
    for (const InputNode& history : histories->children) {
      histories_.push_back(history.name());
      isHistory_.insert(history.name());
    }
  }
}

std::optional<Parameters::Value> ValueReader::read(const InputNode& node, const ParameterEntry& entry,
                                                   const std::string& path) {
  const std::string where = node.location + ": " + path;
  const std::string* type = node.attribute("type");
  const std::string* given = node.attribute("value");
  if (!type || !given) return std::nullopt;  // reported by the caller
  const Names accepted = acceptedTypes(entry.type);
  if (std::find(accepted.begin(), accepted.end(), *type) == accepted.end()) {
    errors_.add(where,
                "type " + base::quoted(*type) + " is given, but the type is " + base::quoted(accepted.front()) + ".",
                "Write " + parameterExample(entry) + ".");
    return std::nullopt;
  }
  const bool isArray = entry.type == ParameterType::numbers || entry.type == ParameterType::texts;
  const auto items = isArray ? base::parseItems(*given) : std::optional<Names>(Names{*given});
  if (!items) {
    errors_.add(where, base::quoted(*given) + " is not a list of values.", "Write value=\"{a, b, c}\".");
    return std::nullopt;
  }
  std::vector<double> numbers;
  Names texts;
  for (const std::string& item : *items) {
    switch (entry.type) {
      case ParameterType::number:
      case ParameterType::numbers:
        if ((*type == "int" || *type == "Array(int)") && base::parseNumber(item) && !base::parseInteger(item)) {
          errors_.add(where, base::quoted(item) + " is not an integer, but the type is " + base::quoted(*type) + ".",
                      "Write type=" + base::quoted(accepted.front()) + ".");
          return std::nullopt;
        }
        if (const auto read = number(item, entry, where)) numbers.push_back(*read);
        break;
      case ParameterType::integer:
        if (const auto read = integer(item, entry, where)) return *read;
        break;
      case ParameterType::flag:
        if (item == "true" || item == "false") return item == "true";
        errors_.add(where, base::quoted(item) + " is not allowed.", "Allowed: true, false.");
        break;
      case ParameterType::text:
      case ParameterType::texts:
        if (auto read = text(item, entry, where)) texts.push_back(std::move(*read));
        break;
    }
  }
  if (numbers.size() + texts.size() != items->size()) return std::nullopt;
  if (entry.type == ParameterType::number) return numbers.front();
  if (entry.type == ParameterType::text) return texts.front();
  if (entry.type == ParameterType::numbers) return numbers;
  return texts;
}

std::optional<double> ValueReader::number(const std::string& text, const ParameterEntry& entry,
                                          const std::string& where) {
  if (!text.empty() && text.front() == '$') {
    const auto found = values_.find(text.substr(1));
    if (found == values_.end()) {
      Names known;
      for (const auto& value : values_) known.push_back(value.first);
      errors_.add(where, base::quoted(text) + " names no entry of the list Values.",
                  base::suggestName(text.substr(1), known, "Values has"));
      return std::nullopt;
    }
    // A value that is not a number is reported where it stands.
    if (found->second && !inRange(*found->second, text + " = " + base::toText(*found->second), entry, where))
      return std::nullopt;
    return found->second;
  }
  const auto number = base::parseNumber(text);
  if (!number) {
    errors_.add(where, base::quoted(text) + " is not a finite number.",
                "Write a number such as 0.5 or 2e5" + (entry.unitName.empty() ? "" : " [" + entry.unitName + "]") +
                    ", or \"$name\" for an entry of the list Values.");
    return std::nullopt;
  }
  if (!inRange(*number, text, entry, where)) return std::nullopt;
  return number;
}

std::optional<int> ValueReader::integer(const std::string& text, const ParameterEntry& entry,
                                        const std::string& where) {
  const auto number = base::parseInteger(text);
  if (!number) {
    errors_.add(where, base::quoted(text) + " is not an integer.",
                "Write a whole number between -2147483648 and 2147483647, without point or exponent.");
    return std::nullopt;
  }
  if (!inRange(*number, text, entry, where)) return std::nullopt;
  return number;
}

std::optional<std::string> ValueReader::text(const std::string& text, const ParameterEntry& entry,
                                             const std::string& where) {
  if (!entry.choices.empty() && std::find(entry.choices.begin(), entry.choices.end(), text) == entry.choices.end()) {
    errors_.add(where, base::quoted(text) + " is not allowed.", base::suggestName(text, entry.choices, "Allowed"));
    return std::nullopt;
  }
  if (entry.namesHistory && isHistory_.count(text) == 0) {
    errors_.add(where, base::quoted(text) + " names no history.", base::suggestName(text, histories_, "Histories has"));
    return std::nullopt;
  }
  return text;
}

bool ValueReader::inRange(double number, const std::string& text, const ParameterEntry& entry,
                          const std::string& where) {
  if (entry.allows(number)) return true;
  errors_.add(where, text + " is out of range.", "Allowed: " + entry.range() + ".");
  return false;
}

}  // namespace harmos::input
