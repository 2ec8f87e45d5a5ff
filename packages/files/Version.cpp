#include <harmos/files/Version.hpp>

namespace harmos::files {

const char* version() {
  return HARMOS_VERSION;
}

}  // namespace harmos::files
