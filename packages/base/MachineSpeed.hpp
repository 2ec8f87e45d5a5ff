#pragma once

namespace harmos::base {

/// How many times as long a small mix of work takes on this machine, now, as on the one of 2020 on which the rates of
/// scene::estimateCost() were fitted: products of dense matrices, products with a matrix that does not fit into the
/// caches, sorting, and clearing new memory. [-], of CPU time of the process, the median of some rounds; takes 0.1 s. 1
/// in a process with a limit on its addresses (`ulimit -v`).
///
/// One number for all work: a machine whose memory is fast for its arithmetic is not told from others. It says how
/// things are at the moment, which changes by half within an hour where others work on the machine.
double machineSlowness();

}  // namespace harmos::base
