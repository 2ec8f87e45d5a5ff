#pragma once

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <harmos/base/Schedule.hpp>

namespace harmos::base {

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
  using Value = std::variant<double, int, bool, std::string, std::vector<double>>;

  Parameters() = default;
  explicit Parameters(std::string name) : name_(std::move(name)) {}

  /// The list's own name (the user's name for the children of a namedLists()).
  const std::string& name() const { return name_; }
  /// Value of the parameter "Type" of a list with alternatives.
  const std::string& type() const { return text("Type"); }

  bool has(const std::string& name) const;
  double number(const std::string& name) const;
  int integer(const std::string& name) const;
  bool flag(const std::string& name) const;
  const std::string& text(const std::string& name) const;
  const std::vector<double>& numbers(const std::string& name) const;
  /// A varying() number times its history, if one is named, at every load step.
  Schedule schedule(const std::string& name) const;

  const Parameters& list(const std::string& name) const;
  bool hasList(const std::string& name) const;
  /// The user-named children of the sublist `name`, in the order of the input; empty if the sublist is absent.
  const std::vector<Parameters>& lists(const std::string& name) const;

  Parameters& set(const std::string& name, Value value);
  Parameters& setList(const std::string& name, Parameters list);
  Parameters& addNamed(const std::string& listName, Parameters child);
  /// Gives this list and all below it the histories that schedule() looks up.
  void attach(std::shared_ptr<const Histories> histories);

 private:
  std::string name_;
  std::map<std::string, Value> values_;
  std::map<std::string, Parameters> lists_;
  std::map<std::string, std::vector<Parameters>> named_;
  std::shared_ptr<const Histories> histories_;
};

}  // namespace harmos::base
