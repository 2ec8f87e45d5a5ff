#pragma once

#include <string>
#include <vector>

#include <harmos/cli/Command.hpp>

namespace harmos::cli {

/// The verbs of `harmos`: run, check, doc, mesh, compare, study, report, predict.
std::vector<Command> commands();

/// Does what `harmos <words...>` does and returns its exit code; --help and --version included. Collective over the
/// communicator, whose rank 0 does all printing. Errors end up as one message on `err`; one
/// that only some ranks meet ends all of them, see base::runOnAllRanks().
int runCommandLine(const std::vector<std::string>& words, const CommandEnvironment& environment);

}  // namespace harmos::cli
