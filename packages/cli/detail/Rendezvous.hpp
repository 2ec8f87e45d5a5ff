#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

namespace harmos::cli {

/// Where ranks that cannot go on find out whether none of the others can, so that nobody waits for them elsewhere.
class Rendezvous {
 public:
  /// Collective.
  explicit Rendezvous(const Teuchos::Comm<int>& comm) : comm_(comm.duplicate()) {}

  /// To be called once. Whether all ranks call it within so many seconds of each other; if not, those that did must end
  /// the others by force.
  bool allCome(double seconds) const;

 private:
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;  // of its own: the others may be amid any exchange
};

}  // namespace harmos::cli
