// A plugin whose law cannot describe itself.
#include <stdexcept>

#include "SimpleGlue.hpp"

namespace {

struct Shy : SimpleGlue {
  static constexpr const char* name = "Shy";
  static void describe(harmos::input::ParameterSpec&) { throw std::logic_error("the table of constants is missing"); }
  using SimpleGlue::SimpleGlue;
};

}  // namespace

HARMOS_LAW_PLUGIN(Shy)
