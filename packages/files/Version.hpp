#pragma once

namespace harmos::files {

/// Version of Harmos that was built, for example "0.1.0".
const char* version();

}  // namespace harmos::files
