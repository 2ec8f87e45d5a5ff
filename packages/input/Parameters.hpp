#pragma once

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Schedule.hpp>

namespace harmos::input {

/// Resolves history names: the multiplier of a named history at every load step.
class Histories {
 public:
  void add(const std::string& name, std::vector<double> perStep) { perStep_[name] = std::move(perStep); }
  /// Null when there is no such history.
  const std::vector<double>* find(const std::string& name) const;

 private:
  std::map<std::string, std::vector<double>> perStep_;
};

/// The checked values of one parameter list, defaults filled in. Immutable for its readers.
///
/// Asking for a name that the ParameterSpec does not declare is a programming error and throws base::Error.
class Parameters {
 public:
  using Value = std::variant<double, int, bool, std::string, std::vector<double>, std::vector<std::string>>;
  struct Entry {
    std::string name;
    Value value;
    std::string location;                                         // "file:line", empty for a default
    std::shared_ptr<const ParameterEntry> declaration = nullptr;  // of a varying number
  };
  struct Sublist;

  Parameters() = default;
  /// `path` leads from the root to this list ("Interfaces / seal"), `location` is its "file:line"; both for messages.
  explicit Parameters(std::string name, std::string path = "", std::string location = "")
      : name_(std::move(name)), path_(path.empty() ? name_ : std::move(path)), location_(std::move(location)) {}

  /// The list's own name (the user's name for the children of a namedLists()).
  const std::string& name() const { return name_; }
  /// Value of the parameter "Type" of a list with alternatives.
  const std::string& type() const { return text("Type"); }
  const std::string& location() const { return location_; }
  /// Where the entry `name`, or without a name this list, stands: "file:line: List / Sublist / Name". An entry that was
  /// not given is where its list is.
  std::string where(const std::string& name = "") const;

  bool has(const std::string& name) const { return find(name) != nullptr; }
  double number(const std::string& name) const;
  int integer(const std::string& name) const;
  bool flag(const std::string& name) const;
  const std::string& text(const std::string& name) const;
  const std::vector<double>& numbers(const std::string& name) const;
  const std::vector<std::string>& texts(const std::string& name) const;
  /// A varying() number times its history, if one is named, at every load step. Throws base::Error (input) when that
  /// leaves the declared range.
  Schedule schedule(const std::string& name) const;

  const Parameters& list(const std::string& name) const;
  bool hasList(const std::string& name) const { return findList(name) != nullptr; }
  /// The user-named children of the sublist `name`, in the order of the input; empty if the sublist is absent.
  const std::vector<Parameters>& lists(const std::string& name) const;

  Parameters& set(const std::string& name, Value value, std::string location = "");
  /// Makes schedule() hold the number to its declaration.
  void restrict(const std::string& name, std::shared_ptr<const ParameterEntry> declaration);
  Parameters& setList(const std::string& name, Parameters list);
  /// Adds a child to the user-named lists of `listName`.
  Parameters& addNamed(const std::string& listName, Parameters child);
  /// Gives this list and all below it the histories that schedule() looks up.
  void attach(const std::shared_ptr<const Histories>& histories);

  const std::vector<Entry>& entries() const { return entries_; }
  const std::vector<Sublist>& sublists() const { return sublists_; }

 private:
  const Entry* find(const std::string& name) const;
  const Sublist* findList(const std::string& name) const;
  template <class T>
  const T& get(const std::string& name, const char* type) const;

  std::string name_, path_, location_;
  std::vector<Entry> entries_;
  std::vector<Sublist> sublists_;
  std::shared_ptr<const Histories> histories_;
};

/// A sublist of fixed name: either one list, or any number of lists named by the user.
struct Parameters::Sublist {
  std::string name;
  bool isNamed = false;
  std::vector<Parameters> lists;  // exactly one when not isNamed
};

}  // namespace harmos::input
