// A plugin with two laws, of which the second has a name that is taken: none of them is registered.
#include "SimpleGlue.hpp"

namespace {

struct NewGlue : SimpleGlue {
  static constexpr const char* name = "New Glue";
  using SimpleGlue::SimpleGlue;
};

}  // namespace

HARMOS_LAW_PLUGIN(NewGlue, SimpleGlue)
