// What the laws of this plugin use of Harmos.
#pragma once

#include <harmos/plugins/LawPlugin.hpp>

using namespace harmos::laws;
using harmos::base::Vector3;
namespace input = harmos::input;
