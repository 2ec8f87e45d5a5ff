#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::input {

/// The classes derived from T that an input may name: an object, so that a host can have its own and add to it.
template <class T>
class Registry {
 public:
  /// Makes an object from its checked parameters, which it must not refer to later; the caller owns it.
  using Factory = std::function<std::unique_ptr<T>(const Parameters&)>;

  /// Adds a class under the name of its spec. Throws base::Error when the name is taken. Returns the registry itself.
  Registry& add(ParameterSpec spec, Factory factory) {
    for (const ParameterSpec& form : forms_) {
      if (form.name() == spec.name()) throw base::Error("\"" + spec.name() + "\" is registered already.");
    }
    forms_.push_back(std::move(spec));
    factories_.push_back(std::move(factory));
    return *this;
  }

  /// Builds the class that parameters.type() names; the caller owns the object. Throws base::Error (input) when there
  /// is none of this name, and what the factory throws.
  std::unique_ptr<T> create(const Parameters& parameters) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < forms_.size(); ++i) {
      if (forms_[i].name() == parameters.type()) return factories_[i](parameters);
      names.push_back(forms_[i].name());
    }
    throw base::Error(parameters.where("Type") + ": unknown type \"" + parameters.type() + "\".\n  " +
                          base::suggestName(parameters.type(), names, "Allowed"),
                      base::ExitCode::input);
  }

  /// What each class may be given, in the order of registration; for ParameterSpec::alternatives().
  const std::vector<ParameterSpec>& forms() const { return forms_; }

 private:
  std::vector<ParameterSpec> forms_;
  std::vector<Factory> factories_;
};

}  // namespace harmos::input
