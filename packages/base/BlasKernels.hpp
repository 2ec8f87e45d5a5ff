#pragma once

#include <string>

namespace harmos::base {

/// The kernels that OpenBLAS should be told to use (OPENBLAS_CORETYPE) where it runs the given ones on a processor that
/// can do so much; empty: those that it has chosen.
///
/// OpenBLAS chooses by the model number of the processor and takes kernels of the year 2004 for those that it does not
/// know, which are all that are younger than it is: three to four times slower than what such a processor can do.
/// `chosen` is the name that OpenBLAS gives its kernels, such as "Prescott"; returned is "SKYLAKEX", "HASWELL" or "".
/// hasAvx2: AVX2 and FMA. hasAvx512: F, CD, BW, DQ and VL besides.
std::string fittingBlasKernels(const std::string& chosen, bool hasAvx2, bool hasAvx512);

/// Starts the program again, in the same process, with OPENBLAS_CORETYPE set when fittingBlasKernels() says so, and
/// with OPENBLAS_NUM_THREADS set to 1 where OpenBLAS has started threads: each takes 128 MB of addresses, and one that
/// gets none (`ulimit -v`) tries for ever, so that the program would not end. To be called first of all, before MPI and
/// threads start. Does nothing with another BLAS, or where these variables are set so; where the program cannot be
/// started again, all stays as it is. `argv` as main() has it, ended by a null. Linux only.
void useFittingBlas(char** argv);

}  // namespace harmos::base
