#pragma once

#include <optional>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

namespace harmos::base {

/// Where all ranks meet at the end of a command, whether they have succeeded or not, so that nobody who failed leaves
/// others waiting elsewhere.
class Rendezvous {
 public:
  /// Collective.
  explicit Rendezvous(const Teuchos::Comm<int>& comm) : comm_(comm.duplicate()) {}

  /// To be called once on every rank. `word`: what this rank has to say. Returns the words of all ranks, or nothing
  /// when some have not come after so many seconds; those that did must then end the others by force.
  std::optional<std::vector<int>> meet(int word, double seconds) const;

 private:
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;  // of its own: the others may be amid any exchange
};

}  // namespace harmos::base
