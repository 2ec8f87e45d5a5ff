#pragma once

namespace harmos::base {

/// Lets BLAS and the parallel regions of libraries in this process work in one thread each, also where a library names
/// a number of threads, as CHOLMOD does: threads on the small blocks of a substructure cost more than they give, and
/// ranks are the way to use more cores. For the calling thread and those that it starts. Does nothing with a BLAS other
/// than OpenBLAS, or without an OpenMP runtime.
void useOneThread();

}  // namespace harmos::base
