#pragma once

#include <memory>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/input/Registry.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

namespace harmos::laws {

/// The laws that a scene may name; an object, so that a host can add its own.
using LawRegistry = input::Registry<InterfaceLaw>;

/// Adds a law whose entries that vary overSurface() may be fields, see FieldLaw. Throws base::Error when the name is
/// taken.
void addVarying(LawRegistry& laws, input::ParameterSpec spec, LawRegistry::Factory make, LawRegistry::Check check);

/// The same of a law that is asked pair by pair, so that all its numbers may.
void addPointwise(LawRegistry& laws, input::ParameterSpec spec, LawRegistry::Factory make, LawRegistry::Check check);

/// L::check() of a law that has one.
template <class L>
auto checkOf(int) -> decltype(LawRegistry::Check(&L::check)) {
  return &L::check;
}
/// None, of other laws.
template <class L>
LawRegistry::Check checkOf(long) {
  return {};
}

/// Declares the fields of L::outputs(), where they do not depend on parameters.
template <class L>
auto declareOutputs(input::ParameterSpec& spec, int) -> decltype(L::outputs(), void()) {
  for (const OutputField& field : L::outputs()) spec.output(field.name, field.unit, field.doc);
}
/// None, of other laws.
template <class L>
void declareOutputs(input::ParameterSpec& /*spec*/, long) {}

/// Adds the law written as struct L (see PointwiseLaw) under L::name. Throws base::Error when the name is taken.
template <class L>
void addLaw(LawRegistry& laws) {
  input::ParameterSpec spec(L::name);
  L::describe(spec);
  declareOutputs<L>(spec, 0);
  const auto make = [](const input::Parameters& p) -> std::unique_ptr<InterfaceLaw> {
    return std::make_unique<PointwiseLaw<L>>(p);
  };
  addPointwise(laws, std::move(spec), make, checkOf<L>(0));
}

/// A new registry of all laws that come with Harmos: the list in packages/laws/CMakeLists.txt.
LawRegistry builtInLaws();

}  // namespace harmos::laws
