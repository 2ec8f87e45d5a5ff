#include <harmos/base/BlasKernels.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <unistd.h>

// Present when the BLAS is OpenBLAS.
extern "C" __attribute__((weak)) char* openblas_get_corename();

namespace harmos::base {
namespace {

constexpr const char* variable = "OPENBLAS_CORETYPE";

}  // namespace

std::string fittingBlasKernels(const std::string& chosen, bool hasAvx2, bool hasAvx512) {
  // What OpenBLAS falls back on for an unknown processor, by what the system lets it use.
  constexpr std::array<const char*, 4> fallbacks = {"Prescott", "Nehalem", "Sandybridge", "Barcelona"};
  if (std::find(fallbacks.begin(), fallbacks.end(), chosen) == fallbacks.end()) return "";
  if (hasAvx512) return "SKYLAKEX";
  return hasAvx2 ? "HASWELL" : "";
}

void useFittingBlasKernels(char** argv) {
#ifdef __x86_64__
  if (std::getenv(variable) != nullptr) return;
  if (!openblas_get_corename) return;
  __builtin_cpu_init();
  const bool hasAvx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool hasAvx512 = hasAvx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                         __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                         __builtin_cpu_supports("avx512vl");
  const std::string kernels = fittingBlasKernels(openblas_get_corename(), hasAvx2, hasAvx512);
  if (kernels.empty()) return;
  setenv(variable, kernels.c_str(), 0);
  // By its own path, so that it keeps its name. Comes back only where it cannot; then the kernels stay as they are.
  std::error_code error;
  execv(std::filesystem::read_symlink("/proc/self/exe", error).c_str(), argv);
#else
  static_cast<void>(argv);
#endif
}

}  // namespace harmos::base
