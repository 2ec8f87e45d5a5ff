#pragma once

namespace harmos::base {

/// Lets OpenBLAS take its buffer now, where the process has a limit on its addresses (`ulimit -v`): later it would try
/// for ever when there are none left, so that the program would not end. Throws std::bad_alloc when there are none now.
/// For the calling thread. Does nothing with another BLAS, and costs no memory that is not used.
void reserveBlasBuffer();

}  // namespace harmos::base
