#pragma once

#include <harmos/cli/Command.hpp>

namespace harmos::cli {

/// Each verb stands in a file of its own, <Verb>Verb.cpp.
Command runCommand();
Command checkCommand();
Command docCommand();
Command meshCommand();
Command compareCommand();
Command studyCommand();
Command reportCommand();
Command importCommand();
Command predictCommand();
Command pictureCommand();
Command showCommand();
Command exportCommand();
Command tradeCommand();

}  // namespace harmos::cli
