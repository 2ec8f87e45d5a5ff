#include <harmos/cli/Command.hpp>

#include <Teuchos_Comm.hpp>

namespace harmos::cli {

bool CommandEnvironment::isRoot() const {
  return communicator->getRank() == 0;
}

}  // namespace harmos::cli
