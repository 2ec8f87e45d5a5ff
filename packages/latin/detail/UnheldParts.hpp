#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/latin/Iterate.hpp>
#include <harmos/latin/LoadBalance.hpp>
#include <harmos/latin/Response.hpp>

namespace harmos::latin {

/// Parts that nothing holds in the state of contact that was found: where they are is not determined, though their
/// forces are.
///
/// Contacts that are open, or bear nothing but round-off at a load step without loads, resist nothing, those that slide
/// neither their normal nor, with friction, the direction across their slip excepted; those that stick and joints that
/// are bonded resist all that their laws can bear, but bolts that are being tightened not the way of their force, and
/// laws over whole faces only what they bear of the resultant. Load steps before the first force between parts are left
/// out.
class UnheldParts {
 public:
  /// Collective. Of all load steps, which must be selected. `balance`: of the same assembly; null: loads are not asked
  /// for. `responses`: which to look at, not all of which tell how they change with displacements. Nothing is kept.
  UnheldParts(const Iterate& state, const LoadBalance* balance,
              const std::vector<std::shared_ptr<const Response>>& responses);

  /// One sentence for every set of them: parts, load steps, the rigid motions that nothing resists and the responses
  /// that change along these.
  const std::vector<std::string>& remarks() const { return remarks_; }
  /// Their loads along these motions, over the largest load of all load steps [-], the least of those that are more
  /// than round-off: such a state is no equilibrium, however small its residual. 1: they are not loaded.
  double leastLoad() const { return leastLoad_; }
  /// The first load step at which some are loaded; -1: none.
  int firstLoaded() const { return firstLoaded_; }

 private:
  std::vector<std::string> remarks_;
  double leastLoad_ = 1.0;
  int firstLoaded_ = -1;
};

}  // namespace harmos::latin
