#pragma once

#include <memory>

#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

namespace harmos::laws {

/// Adds the law L, which is an InterfaceLaw itself, under L::lawName; otherwise as addLaw().
template <class L>
void addWholeLaw(LawRegistry& laws) {
  input::ParameterSpec spec(L::lawName);
  L::describe(spec);
  const auto make = [](const input::Parameters& p) -> std::unique_ptr<InterfaceLaw> { return std::make_unique<L>(p); };
  addVarying(laws, std::move(spec), make, checkOf<L>(0));
}

}  // namespace harmos::laws

/// Ends the file of a built-in law: defines the function that the generated list of built-ins calls.
#define HARMOS_INTERFACE_LAW(Law)    \
  void add##Law(LawRegistry& laws) { \
    addLaw<Law>(laws);               \
  }

/// The same for a law that looks at all pairs at once.
#define HARMOS_WHOLE_LAW(Law)        \
  void add##Law(LawRegistry& laws) { \
    addWholeLaw<Law>(laws);          \
  }
