// What a plugin with a description that is made otherwise says of itself; of its laws nothing may be called.
#include "Foreign.hpp"

FOREIGN_PLUGIN(pluginMagic + 1, nullptr, nullptr, nullptr)
