#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace harmos::input {

enum class ParameterType { number, integer, flag, text, numbers, texts };

/// Name of the type in XML, for example "double" or "Array(double)".
const char* xmlType(ParameterType type);

/// One declared parameter: type, unit, range, default or required, doc. Built fluently; see ParameterSpec.
class ParameterEntry {
 public:
  ParameterEntry(std::string entryName, ParameterType entryType) : name(std::move(entryName)), type(entryType) {}

  ParameterEntry& unit(std::string u) {
    unitName = std::move(u);
    return *this;
  }
  ParameterEntry& doc(std::string d) {
    description = std::move(d);
    return *this;
  }
  /// The entry must be given. Without required(), defaultValue() or optional() the entry counts as required.
  ParameterEntry& required() { return *this; }
  /// The entry may be absent and then has no value; ask Parameters::has().
  ParameterEntry& optional() {
    isOptional = true;
    return *this;
  }
  ParameterEntry& defaultValue(double v);
  ParameterEntry& defaultValue(int v);
  ParameterEntry& defaultValue(bool v);
  ParameterEntry& defaultValue(const char* v);
  ParameterEntry& atLeast(double v) {
    minimum = v;
    return *this;
  }
  ParameterEntry& above(double v) {
    minimum = v;
    excludesMinimum = true;
    return *this;
  }
  ParameterEntry& atMost(double v) {
    maximum = v;
    return *this;
  }
  ParameterEntry& below(double v) {
    maximum = v;
    excludesMaximum = true;
    return *this;
  }
  /// Text only: the allowed values.
  ParameterEntry& oneOf(std::vector<std::string> values) {
    choices = std::move(values);
    return *this;
  }
  /// Number only: the value may vary over the load steps. Declares the companion text parameter "<name> History",
  /// which names an entry of the scene's list "Histories"; the value at a step is number times history.
  ParameterEntry& varying() {
    varies = true;
    return *this;
  }
  /// Neither optional nor with a default.
  bool isRequired() const { return !isOptional && !defaultText; }
  /// Whether the number lies in the allowed range.
  bool allows(double number) const;
  /// The allowed range in words and with the unit, for example "above 0 and at most 1 [length]"; empty: any value.
  std::string range() const;

  std::string name;
  ParameterType type;
  std::string unitName;
  std::string description;
  std::optional<std::string> defaultText;  // as it would be written in XML
  bool isOptional = false;
  bool varies = false;
  bool namesHistory = false;  // the companion of a varying number
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool excludesMinimum = false;
  bool excludesMaximum = false;
  std::vector<std::string> choices;
};

/// What one parameter list may hold, declared once next to the class that it configures.
///
/// From it come validation, error messages, the reference printed by `harmos doc` and the defaults. Kinds of sublists:
/// list() has a fixed name; namedLists() holds any number of lists named by the user, all of one form; namedNumbers()
/// holds any number of numbers named by the user; alternatives() is a list whose text parameter "Type" selects one of
/// several forms. A copy shares its entries with the original.
class ParameterSpec {
 public:
  explicit ParameterSpec(std::string name = "") : name_(std::move(name)) {}

  ParameterSpec& summary(std::string text) {
    summary_ = std::move(text);
    return *this;
  }
  ParameterSpec& source(std::string text) {
    source_ = std::move(text);
    return *this;
  }

  ParameterEntry& number(std::string name) { return add(std::move(name), ParameterType::number); }
  ParameterEntry& integer(std::string name) { return add(std::move(name), ParameterType::integer); }
  ParameterEntry& flag(std::string name) { return add(std::move(name), ParameterType::flag); }
  ParameterEntry& text(std::string name) { return add(std::move(name), ParameterType::text); }
  /// A list of numbers, XML type Array(double).
  ParameterEntry& numbers(std::string name) { return add(std::move(name), ParameterType::numbers); }
  /// A list of texts, XML type Array(string).
  ParameterEntry& texts(std::string name) { return add(std::move(name), ParameterType::texts); }

  /// Sublist of a fixed name. When absent from the input, its defaults apply, unless `required` or `optional`.
  ParameterSpec& list(std::string name, bool required = false, bool optional = false);
  /// Sublist of a fixed name whose children are lists named by the user, each described by the returned spec.
  ParameterSpec& namedLists(std::string name, bool required = false);
  /// Sublist of a fixed name whose entries are numbers named by the user; the returned spec holds only its summary.
  ParameterSpec& namedNumbers(std::string name);
  /// Sublist of a fixed name whose parameter "Type" chooses among `forms` (the forms' names are the allowed types).
  /// When it is absent from the input and not required, it has no defaults: ask Parameters::hasList().
  ParameterSpec& alternatives(std::string name, std::vector<ParameterSpec> forms, bool required = false);
  /// Makes this spec itself one with a "Type": its own entries are allowed for every type, the form's besides.
  ParameterSpec& choose(std::vector<ParameterSpec> forms);

  const std::string& name() const { return name_; }
  const std::string& summary() const { return summary_; }
  const std::string& source() const { return source_; }

  enum class ListKind { fixed, named, numbers };
  struct Sublist {
    std::string name;
    ListKind kind = ListKind::fixed;
    bool required = false;
    bool optional = false;
    std::shared_ptr<ParameterSpec> spec;  // fixed: the list itself; named: each child
  };
  const std::vector<std::shared_ptr<ParameterEntry>>& entries() const { return entries_; }
  const std::vector<Sublist>& sublists() const { return sublists_; }
  const std::vector<ParameterSpec>& forms() const { return forms_; }
  /// Null when there is no form of this name.
  const ParameterSpec* findForm(const std::string& type) const;

  /// All that a list may hold once its "Type" is known: "Type" itself, the own entries and those of `form` (may be
  /// null), each varying number followed by its companion "<name> History".
  std::vector<ParameterEntry> entriesWith(const ParameterSpec* form) const;
  std::vector<Sublist> sublistsWith(const ParameterSpec* form) const;

 private:
  ParameterEntry& add(std::string name, ParameterType type);
  ParameterSpec& addList(Sublist sublist);

  std::string name_, summary_, source_;
  std::vector<std::shared_ptr<ParameterEntry>> entries_;
  std::vector<Sublist> sublists_;
  std::vector<ParameterSpec> forms_;
};

}  // namespace harmos::input
