#include <harmos/files/Version.hpp>

#include <harmos/version.hpp>

namespace harmos::files {

const char* version() {
  return HARMOS_VERSION_STRING;
}

}  // namespace harmos::files
