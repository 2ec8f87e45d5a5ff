#pragma once

namespace harmos::output {

/// Version of Harmos, for example "0.1.0".
const char* version();

}  // namespace harmos::output
