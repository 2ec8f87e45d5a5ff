// What a plugin of another compiler says of itself; of its laws nothing may be called.
#include "Foreign.hpp"

FOREIGN_PLUGIN(pluginMagic, HARMOS_INTERFACE_VERSION, HARMOS_INTERFACE_DIGEST, "gnu++ 1002, strings 0")
