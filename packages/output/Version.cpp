#include <harmos/output/Version.hpp>

namespace harmos::output {

const char* version() {
  return HARMOS_VERSION;
}

}  // namespace harmos::output
