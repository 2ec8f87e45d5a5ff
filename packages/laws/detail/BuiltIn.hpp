#pragma once

#include <memory>

#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

/// Ends the file of a built-in law: defines the function that the generated list of built-ins calls.
#define HARMOS_INTERFACE_LAW(Law)    \
  void add##Law(LawRegistry& laws) { \
    addLaw<Law>(laws);               \
  }
