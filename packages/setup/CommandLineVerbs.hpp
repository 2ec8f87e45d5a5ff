#pragma once

#include <harmos/setup/CommandLine.hpp>

namespace harmos::setup {

/// Each verb stands in a file of its own, CommandLine<Verb>.cpp.
Command runCommand();
Command checkCommand();
Command docCommand();
Command meshCommand();
Command compareCommand();
Command studyCommand();
Command reportCommand();
Command predictCommand();

}  // namespace harmos::setup
