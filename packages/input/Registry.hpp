#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::input {

/// The classes derived from T that an input may name: an object, so that a host can have its own and add to it.
/// `Context`: what else they are made of, besides their entries.
template <class T, class... Context>
class Registry {
 public:
  /// Makes an object from its checked parameters, which it must not refer to later; the caller owns it.
  using Factory = std::function<std::unique_ptr<T>(const Parameters&, Context...)>;
  /// Reports entries that do not go together.
  using Check = std::function<void(const Parameters&, ErrorList&)>;

  /// Adds a class under the name of its spec; `check` may be empty. Throws base::Error when the name is taken.
  /// Returns the registry itself.
  Registry& add(ParameterSpec spec, Factory factory, Check check = {}) {
    for (const ParameterSpec& form : forms_) {
      if (form.name() == spec.name()) throw base::Error("\"" + spec.name() + "\" is registered already.");
    }
    forms_.push_back(std::move(spec));
    factories_.push_back(std::move(factory));
    checks_.push_back(std::move(check));
    return *this;
  }

  /// Builds the class that parameters.type() names; the caller owns the object. Throws base::Error (input) when there
  /// is none of this name, and what the factory throws.
  std::unique_ptr<T> create(const Parameters& parameters, Context... context) const {
    return factories_[find(parameters)](parameters, context...);
  }

  /// Checks what the spec cannot say of the class that parameters.type() names. Throws base::Error (input) when there
  /// is none of this name.
  void check(const Parameters& parameters, ErrorList& errors) const {
    if (const Check& check = checks_[find(parameters)]) check(parameters, errors);
  }

  /// What each class may be given, in the order of registration; for ParameterSpec::alternatives().
  const std::vector<ParameterSpec>& forms() const { return forms_; }

 private:
  std::size_t find(const Parameters& parameters) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      if (forms_[i].name() == parameters.type()) return i;
      names.push_back(forms_[i].name());
    }
    throw base::Error(parameters.where("Type") + ": unknown type \"" + parameters.type() + "\".\n  " +
                          base::suggestName(parameters.type(), names, "Allowed"),
                      base::ExitCode::input);
  }

  std::vector<ParameterSpec> forms_;
  std::vector<Factory> factories_;
  std::vector<Check> checks_;
};

}  // namespace harmos::input
