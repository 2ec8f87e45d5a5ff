#pragma once

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Schedule.hpp>

namespace harmos::input {

/// Resolves history names: the multiplier of a named history at every load step.
class Histories {
 public:
  /// Without histories and times.
  Histories() = default;
  /// `times`: end of each load step [time].
  explicit Histories(std::vector<double> times) : times_(std::move(times)) {}
  /// End of each load step [time]; empty: not known.
  const std::vector<double>& times() const { return times_; }
  /// Adds a history, or replaces the one of this name. `perStep`: one multiplier [-] per load step.
  void add(const std::string& name, std::vector<double> perStep) { perStep_[name] = std::move(perStep); }
  /// The multipliers [-], one per load step, owned by this object; null when there is no such history.
  const std::vector<double>* find(const std::string& name) const;

 private:
  std::vector<double> times_;
  std::map<std::string, std::vector<double>> perStep_;
};

/// The checked values of one parameter list, defaults filled in. Immutable for its readers.
///
/// Asking for a name that the ParameterSpec does not declare, for an optional entry that was not given, or for another
/// type than the declared one is a programming error and throws base::Error. References returned are owned by the list
/// and valid until it changes. Numbers are in the units of their declarations.
class Parameters {
 public:
  /// What an entry holds, by the type of its declaration.
  using Value = std::variant<double, int, bool, std::string, std::vector<double>, std::vector<std::string>>;
  /// One value and where it was given.
  struct Entry {
    std::string name;                                             // as declared
    Value value;                                                  // in the declared unit
    std::string location;                                         // "file:line" or "--set", empty for a default
    std::shared_ptr<const ParameterEntry> declaration = nullptr;  // of a varying number
  };
  struct Sublist;

  /// A list without name, entries and place.
  Parameters() = default;
  /// `path` leads from the root to this list ("Interfaces / seal"), `location` is its "file:line"; both for messages.
  /// An empty path stands for the name.
  explicit Parameters(std::string name, std::string path = "", std::string location = "")
      : name_(std::move(name)), path_(path.empty() ? name_ : std::move(path)), location_(std::move(location)) {}

  /// The list's own name (the user's name for the children of a namedLists()).
  const std::string& name() const { return name_; }
  /// Value of the parameter "Type" of a list with alternatives.
  const std::string& type() const { return text("Type"); }
  /// "file:line" of this list, for messages; empty when it was not read.
  const std::string& location() const { return location_; }
  /// Where the entry `name`, or without a name this list, stands: "file:line: List / Sublist / Name". An entry that was
  /// not given is where its list is.
  std::string where(const std::string& name = "") const;

  /// Whether there is a value, given or by default.
  bool has(const std::string& name) const { return find(name) != nullptr; }
  /// A number, of a varying one that which the history multiplies.
  double number(const std::string& name) const;
  /// A whole number.
  int integer(const std::string& name) const;
  /// True or false.
  bool flag(const std::string& name) const;
  /// A text, one of the allowed ones if the declaration lists them.
  const std::string& text(const std::string& name) const;
  /// A list of numbers, of any length.
  const std::vector<double>& numbers(const std::string& name) const;
  /// A list of texts, of any length.
  const std::vector<std::string>& texts(const std::string& name) const;
  /// A varying() number times its history, if one is named, at every load step. Throws base::Error (input) when that
  /// leaves the declared range, or when no history of this name was attached.
  Schedule schedule(const std::string& name) const;
  /// End of each load step [time]; empty when no histories with times were attached.
  std::vector<double> times() const { return histories_ ? histories_->times() : std::vector<double>(); }
  /// The histories that were attached last; none when that has not happened.
  Histories histories() const { return histories_ ? *histories_ : Histories(); }

  /// The sublist of this fixed name. Throws base::Error when it is absent, or holds lists named by the user.
  const Parameters& list(const std::string& name) const;
  /// Whether there is a sublist of this name, given or by its defaults.
  bool hasList(const std::string& name) const { return findList(name) != nullptr; }
  /// The user-named children of the sublist `name`, in the order of the input; empty if the sublist is absent.
  const std::vector<Parameters>& lists(const std::string& name) const;

  /// Adds an entry, or replaces the value and place of the one of this name. Checks nothing. Returns the list itself,
  /// as setList() and addNamed() do.
  Parameters& set(const std::string& name, Value value, std::string location = "");
  /// Removes the entry of this name, if there is one.
  void remove(const std::string& name);
  /// Makes schedule() hold the number to its declaration; nothing happens when there is no entry of this name.
  void restrict(const std::string& name, std::shared_ptr<const ParameterEntry> declaration);
  /// Adds a sublist of fixed name, or replaces the one of this name.
  Parameters& setList(const std::string& name, Parameters list);
  /// Adds a child to the user-named lists of `listName`, which must not be a sublist of fixed name.
  Parameters& addNamed(const std::string& listName, Parameters child);
  /// Adds an entry, or replaces it, in the child of this name of the user-named lists of `listName`; nothing
  /// happens when there is none.
  Parameters& setInNamed(const std::string& listName, const std::string& child, const std::string& name, Value value);
  /// Gives this list and all below it the histories that schedule() looks up; shared, and replacing those before.
  void attach(const std::shared_ptr<const Histories>& histories);

  /// All entries in the order in which they were set; check() sets them in that of their declarations.
  const std::vector<Entry>& entries() const { return entries_; }
  /// All sublists in the same order; absent ones without defaults are left out.
  const std::vector<Sublist>& sublists() const { return sublists_; }

 private:
  /// The entry of this name; null when there is none.
  const Entry* find(const std::string& name) const;
  const Sublist* findList(const std::string& name) const;
  template <class T>
  const T& get(const std::string& name, const char* type) const;

  std::string name_, path_, location_;
  std::vector<Entry> entries_;
  std::unordered_map<std::string, std::size_t> places_;  // of the entries, by name
  std::vector<Sublist> sublists_;
  std::shared_ptr<const Histories> histories_;
};

/// A sublist of fixed name: either one list, or any number of lists named by the user.
struct Parameters::Sublist {
  std::string name;               // as declared
  bool isNamed = false;           // holds lists named by the user
  std::vector<Parameters> lists;  // exactly one when not isNamed
};

}  // namespace harmos::input
