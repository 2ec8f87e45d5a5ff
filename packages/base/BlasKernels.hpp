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

/// Starts the program again, in the same process, with OPENBLAS_CORETYPE set when fittingBlasKernels() says so; to be
/// called first of all, before MPI and threads start. Does nothing with another BLAS or processor than x86-64, or when
/// the variable is set; where the program cannot be started again, the kernels stay as they are. `argv` as main() has
/// it, ended by a null. Linux only.
void useFittingBlasKernels(char** argv);

}  // namespace harmos::base
