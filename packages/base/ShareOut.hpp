#pragma once

#include <vector>

namespace harmos::base {

/// Shares pieces of work out among ranks so that none has much more than the others: those that cost most first, each
/// to the rank that has least to do.
///
/// `cost`: of every piece, in any unit. `load`: of every rank, at least one, what it has to do besides. `owner`: the
/// rank that has each piece, and keeps it where it has hardly more to do than the least loaded one; empty: none has
/// any. Returns the rank of every piece. The largest load is at most 4/3 of the least possible one where nothing is
/// owned and no rank has anything besides. Source: Graham, Bounds on multiprocessing timing anomalies, SIAM J. Appl.
/// Math. 17 (1969), doi:10.1137/0117039.
std::vector<int> shareOut(const std::vector<double>& cost, std::vector<double> load,
                          const std::vector<int>& owner = {});

}  // namespace harmos::base
