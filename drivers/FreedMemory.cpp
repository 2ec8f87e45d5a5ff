#include "FreedMemory.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

void keepFreedMemory() {
#ifdef __GLIBC__
  // Larger ones, the fields of many load steps, would need whole holes of the heap when they grow, and may find none:
  // 12 for 10.5 fields for each step in command_line_many_steps. A value of one's own also keeps the C library from
  // moving the threshold.
  constexpr int alwaysGivenBack = 8 << 20;
  constexpr int kept = 256 << 20;
  // What users set in the environment is theirs.
  if (std::getenv("MALLOC_MMAP_THRESHOLD_") == nullptr) mallopt(M_MMAP_THRESHOLD, alwaysGivenBack);
  if (std::getenv("MALLOC_TRIM_THRESHOLD_") == nullptr) mallopt(M_TRIM_THRESHOLD, kept);
#endif
}
