#pragma once

#include <string>

namespace harmos::base {

/// The kernels that OpenBLAS should be told to use (OPENBLAS_CORETYPE) where it runs the given ones on a processor that
/// can do so much; empty: those that it has chosen.
///
/// OpenBLAS chooses by the model number of the processor and takes kernels of the year 2004 for those that it does not
/// know, which are all that are younger than it is: three to four times slower than what such a processor can do.
std::string fittingBlasKernels(const std::string& chosen, bool hasAvx2, bool hasAvx512);

/// Starts the program again, in the same process, with OPENBLAS_CORETYPE set when fittingBlasKernels() says so; to be
/// called first of all. Does nothing with another BLAS, or when the variable is set.
void useFittingBlasKernels(char** argv);

}  // namespace harmos::base
