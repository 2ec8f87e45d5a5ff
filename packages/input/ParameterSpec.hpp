#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace harmos::input {

/// What an entry holds: a double, an int, a bool, a string, a list of doubles or a list of strings.
enum class ParameterType { number, integer, flag, text, numbers, texts };

/// Name of the type in XML: "double", "int", "bool", "string", "Array(double)" or "Array(string)".
const char* xmlType(ParameterType type);

/// One declared parameter: type, unit, range, default or required, doc. Built fluently; see ParameterSpec.
///
/// Each setter returns the entry itself, and the last call of one counts. Nothing is checked before an input is:
/// a default outside of the range, or of another type, is an error of the input then.
class ParameterEntry {
 public:
  /// A required entry without unit, range and doc.
  ParameterEntry(std::string entryName, ParameterType entryType) : name(std::move(entryName)), type(entryType) {}

  /// Unit without brackets, such as "length", "stress/length" or, for pure numbers, "-".
  ParameterEntry& unit(std::string u) {
    unitName = std::move(u);
    return *this;
  }
  /// What it means, in complete sentences for the user.
  ParameterEntry& doc(std::string d) {
    description = std::move(d);
    return *this;
  }
  /// A value, as it would be written in XML, for the snippet of the reference, which then has the entry.
  ParameterEntry& example(std::string value) {
    exampleText = std::move(value);
    return *this;
  }
  /// The entry must be given. Without required(), defaultValue() or optional() the entry counts as required.
  ParameterEntry& required() { return *this; }
  /// The entry may be absent and then has no value; ask Parameters::has().
  ParameterEntry& optional() {
    isOptional = true;
    return *this;
  }
  /// The value, in the entry's unit, of an entry that is absent.
  ParameterEntry& defaultValue(double v);
  /// The same for an integer.
  ParameterEntry& defaultValue(int v);
  /// The same for a flag.
  ParameterEntry& defaultValue(bool v);
  /// The same for a text; for a list as it would be written in XML, "{a, b, c}".
  ParameterEntry& defaultValue(const char* v);
  /// Numbers, integers and each number of a list: the least that is allowed, in the entry's unit.
  ParameterEntry& atLeast(double v) {
    minimum = v;
    return *this;
  }
  /// The same, but it must be more than that.
  ParameterEntry& above(double v) {
    minimum = v;
    excludesMinimum = true;
    return *this;
  }
  /// Numbers, integers and each number of a list: the most that is allowed, in the entry's unit.
  ParameterEntry& atMost(double v) {
    maximum = v;
    return *this;
  }
  /// The same, but it must be less than that.
  ParameterEntry& below(double v) {
    maximum = v;
    excludesMaximum = true;
    return *this;
  }
  /// Text and each text of a list: the allowed values.
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
  /// Number, or list of numbers that all have one factor: the value may vary over a surface. Declares no companions:
  /// who lets it vary does, see Field::describe().
  ParameterEntry& overSurface() {
    variesOverSurface = true;
    return *this;
  }
  /// Neither optional nor with a default.
  bool isRequired() const { return !isOptional && !defaultText; }
  /// Whether the number, in the entry's unit, lies in the allowed range; NaN does so in none.
  bool allows(double number) const;
  /// The allowed range in words and with the unit, for example "above 0 and at most 1 [length]"; empty: any value.
  std::string range() const;

  std::string name;                                           // as written in XML
  ParameterType type;                                         // what it holds
  std::string unitName;                                       // of unit(); empty: none
  std::string description;                                    // of doc()
  std::string exampleText;                                    // of example(); empty: none
  std::optional<std::string> defaultText;                     // as it would be written in XML; nothing: no default
  bool isOptional = false;                                    // may be absent, then without a value
  bool varies = false;                                        // may be multiplied by a history
  bool variesOverSurface = false;                             // may be multiplied by formulas of the place and fields
  bool namesHistory = false;                                  // the companion of a varying number
  double minimum = -std::numeric_limits<double>::infinity();  // in the entry's unit
  double maximum = std::numeric_limits<double>::infinity();   // in the entry's unit
  bool excludesMinimum = false;                               // the value must be above the minimum
  bool excludesMaximum = false;                               // the value must be below the maximum
  std::vector<std::string> choices;                           // allowed texts; empty: any
};

/// What one parameter list may hold, declared once next to the class that it configures.
///
/// From it come validation, error messages, the reference printed by `harmos doc` and the defaults. Kinds of sublists:
/// list() has a fixed name; namedLists() holds any number of lists named by the user, all of one form; namedNumbers()
/// holds any number of numbers named by the user; alternatives() is a list whose text parameter "Type" selects one of
/// several forms. A copy shares its entries and sublists with the original. The references returned are valid as long
/// as the spec or a copy of it lives; forms are copied when given. Declaring two entries or two sublists of one name
/// throws base::Error.
class ParameterSpec {
 public:
  /// `name`: of the list, or of the form that "Type" may choose.
  explicit ParameterSpec(std::string name = "") : name_(std::move(name)) {}

  /// What the list is for, in complete sentences for the user. Returns the spec itself.
  ParameterSpec& summary(std::string text) {
    summary_ = std::move(text);
    return *this;
  }
  /// What it does in one line of mathematics. Returns the spec itself.
  ParameterSpec& equation(std::string text) {
    equation_ = std::move(text);
    return *this;
  }
  /// Adds a field that what it configures adds to the results: its name in files, its unit, and what it is. Returns the
  /// spec itself.
  ParameterSpec& output(std::string name, std::string unit, std::string text) {
    outputs_.push_back({std::move(name), std::move(unit), std::move(text)});
    return *this;
  }
  /// Where what it configures comes from: authors, year, equation. Returns the spec itself.
  ParameterSpec& source(std::string text) {
    source_ = std::move(text);
    return *this;
  }

  /// A finite number, XML type double or int.
  ParameterEntry& number(std::string name) { return add(std::move(name), ParameterType::number); }
  /// A whole number of 32 bits, XML type int.
  ParameterEntry& integer(std::string name) { return add(std::move(name), ParameterType::integer); }
  /// true or false, XML type bool.
  ParameterEntry& flag(std::string name) { return add(std::move(name), ParameterType::flag); }
  /// A text, XML type string.
  ParameterEntry& text(std::string name) { return add(std::move(name), ParameterType::text); }
  /// A list of finite numbers of any length, XML type Array(double) or Array(int).
  ParameterEntry& numbers(std::string name) { return add(std::move(name), ParameterType::numbers); }
  /// A list of texts of any length, XML type Array(string).
  ParameterEntry& texts(std::string name) { return add(std::move(name), ParameterType::texts); }

  /// Sublist of a fixed name, described by the returned spec. When absent from the input, its defaults apply, unless
  /// `required` (an error) or `optional` (there is no list then).
  ParameterSpec& list(std::string name, bool required = false, bool optional = false);
  /// Sublist of a fixed name whose children are lists named by the user, each described by the returned spec. If
  /// `required`, there must be at least one.
  ParameterSpec& namedLists(std::string name, bool required = false);
  /// Sublist of a fixed name whose entries are finite numbers named by the user, of any range; the returned spec holds
  /// only its summary. Never required.
  ParameterSpec& namedNumbers(std::string name);
  /// Sublist of a fixed name whose parameter "Type" chooses among `forms` (the forms' names are the allowed types).
  /// When it is absent from the input and not required, it has no defaults: ask Parameters::hasList().
  ParameterSpec& alternatives(std::string name, std::vector<ParameterSpec> forms, bool required = false);
  /// Makes this spec itself one with a "Type": its own entries are allowed for every type, the form's besides. Returns
  /// the spec itself.
  ParameterSpec& choose(std::vector<ParameterSpec> forms);

  /// Name of the list or form.
  const std::string& name() const { return name_; }
  /// What summary() was given; empty: nothing.
  const std::string& summary() const { return summary_; }
  /// What equation() was given; empty: nothing.
  const std::string& equation() const { return equation_; }
  /// A field of the results.
  struct Output {
    std::string name;  // in files
    std::string unit;  // such as "length" or "-"
    std::string doc;   // what it is, in a few words
  };
  /// What output() was given.
  const std::vector<Output>& outputs() const { return outputs_; }
  /// What source() was given; empty: nothing.
  const std::string& source() const { return source_; }

  /// What list(), namedLists() and namedNumbers() declare.
  enum class ListKind { fixed, named, numbers };
  /// One declared sublist.
  struct Sublist {
    std::string name;                     // as written in XML
    ListKind kind = ListKind::fixed;      // what its children are
    bool required = false;                // must be given; if named, with a child
    bool optional = false;                // fixed: without defaults when it is absent
    std::shared_ptr<ParameterSpec> spec;  // fixed: the list itself; named: each child; numbers: its summary
  };
  /// The own entries in the order of declaration, without "Type" and the companions of varying numbers.
  const std::vector<std::shared_ptr<ParameterEntry>>& entries() const { return entries_; }
  /// The own sublists in the order of declaration.
  const std::vector<Sublist>& sublists() const { return sublists_; }
  /// What "Type" chooses from; empty: the list has no "Type".
  const std::vector<ParameterSpec>& forms() const { return forms_; }
  /// The form of this name, owned by the spec; null when there is none.
  const ParameterSpec* findForm(const std::string& type) const;

  /// All that a list may hold once its "Type" is known: "Type" itself, the own entries and those of `form` (may be
  /// null), each varying number followed by its companion "<name> History".
  std::vector<ParameterEntry> entriesWith(const ParameterSpec* form) const;
  /// The own sublists and those of `form` (may be null).
  std::vector<Sublist> sublistsWith(const ParameterSpec* form) const;

 private:
  ParameterEntry& add(std::string name, ParameterType type);
  ParameterSpec& addList(Sublist sublist);

  std::string name_, summary_, equation_, source_;
  std::vector<Output> outputs_;
  std::vector<std::shared_ptr<ParameterEntry>> entries_;
  std::vector<Sublist> sublists_;
  std::vector<ParameterSpec> forms_;
};

}  // namespace harmos::input
