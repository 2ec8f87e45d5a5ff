#pragma once

#include <vector>

#include <harmos/latin/EquilibriumCheck.hpp>

namespace harmos::latin {

/// Notices during an iteration that the interface laws cannot carry the loads.
///
/// Looks at every ninth iteration. When a body has lacked the same reaction four times in a row, to within 5 %, it is
/// pushed along; see movesFreely().
class EquilibriumWatch {
 public:
  /// Imbalances below `accuracy` (relative, see Imbalance) do not count.
  explicit EquilibriumWatch(double accuracy) : accuracy_(accuracy) {}

  /// Collective; to be asked after every iteration, with image = T(alpha).
  bool findsNoEquilibrium(FixedPoint& fixedPoint, const base::Matrix& alpha, base::Matrix& image);
  /// The last one looked at.
  const Imbalance& imbalance() const { return history_.back(); }

 private:
  bool persists() const;

  double accuracy_;
  int iterations_ = 0;
  std::vector<Imbalance> history_;
};

}  // namespace harmos::latin
