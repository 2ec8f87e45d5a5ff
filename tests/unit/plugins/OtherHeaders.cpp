// What a plugin of this version, but with other headers says of itself; of its laws nothing may be called.
#include "Foreign.hpp"

FOREIGN_PLUGIN(pluginMagic, HARMOS_INTERFACE_VERSION, "0123456789abcdef", HARMOS_COMPILER_ABI)
