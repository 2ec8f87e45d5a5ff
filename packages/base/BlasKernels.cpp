#include <harmos/base/BlasKernels.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <unistd.h>

// Present when the BLAS is OpenBLAS.
extern "C" {
__attribute__((weak)) char* openblas_get_corename();
__attribute__((weak)) int openblas_get_num_threads();
}

namespace harmos::base {
namespace {

constexpr const char* kernelsVariable = "OPENBLAS_CORETYPE";
constexpr const char* threadsVariable = "OPENBLAS_NUM_THREADS";

/// Whether OpenBLAS has been told its kernels now, which it had not been before.
bool tellKernels() {
#ifdef __x86_64__
  if (std::getenv(kernelsVariable) != nullptr || !openblas_get_corename) return false;
  __builtin_cpu_init();
  const bool hasAvx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool hasAvx512 = hasAvx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                         __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                         __builtin_cpu_supports("avx512vl");
  const std::string kernels = fittingBlasKernels(openblas_get_corename(), hasAvx2, hasAvx512);
  return !kernels.empty() && setenv(kernelsVariable, kernels.c_str(), 0) == 0;
#else
  return false;
#endif
}

/// Whether OpenBLAS has been told to start no threads now, which it had done before.
bool tellThreads() {
  if (!openblas_get_num_threads || openblas_get_num_threads() <= 1) return false;
  const char* told = std::getenv(threadsVariable);
  return (told == nullptr || std::string(told) != "1") && setenv(threadsVariable, "1", 1) == 0;
}

}  // namespace

std::string fittingBlasKernels(const std::string& chosen, bool hasAvx2, bool hasAvx512) {
  // What OpenBLAS falls back on for an unknown processor, by what the system lets it use.
  constexpr std::array<const char*, 4> fallbacks = {"Prescott", "Nehalem", "Sandybridge", "Barcelona"};
  if (std::find(fallbacks.begin(), fallbacks.end(), chosen) == fallbacks.end()) return "";
  if (hasAvx512) return "SKYLAKEX";
  return hasAvx2 ? "HASWELL" : "";
}

void useFittingBlas(char** argv) {
  const bool areOtherKernels = tellKernels();
  const bool areOtherThreads = tellThreads();
  if (!areOtherKernels && !areOtherThreads) return;
  // By its own path, so that it keeps its name. Comes back only where it cannot; then all stays as it is.
  std::error_code error;
  execv(std::filesystem::read_symlink("/proc/self/exe", error).c_str(), argv);
}

}  // namespace harmos::base
