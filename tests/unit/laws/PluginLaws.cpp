// The laws that a plugin brings, for the conformance suite: harmos_add_law_conformance() says which.
#include <harmos/plugins/LoadPlugin.hpp>

#include "TestedLaws.hpp"

namespace harmos::laws {

LawRegistry testedLaws() {
  LawRegistry laws;
  plugins::loadPlugin(HARMOS_TESTED_PLUGIN, laws);
  return laws;
}

std::vector<std::string> untestedLaws() {
  return {HARMOS_UNTESTED_LAWS};
}

}  // namespace harmos::laws
