// What a plugin of another version says of itself; of its laws nothing may be called.
#include "Foreign.hpp"

FOREIGN_PLUGIN(pluginMagic, "0.0.9", HARMOS_INTERFACE_DIGEST, HARMOS_COMPILER_ABI)
