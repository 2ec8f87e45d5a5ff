#include "FreedMemory.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

void keepFreedMemory() {
#ifdef __GLIBC__
  // The largest that glibc takes; a value of one's own also keeps it from moving the threshold.
  constexpr int alwaysGivenBack = 32 << 20;
  constexpr int kept = 256 << 20;
  // What users set in the environment is theirs.
  if (std::getenv("MALLOC_MMAP_THRESHOLD_") == nullptr) mallopt(M_MMAP_THRESHOLD, alwaysGivenBack);
  if (std::getenv("MALLOC_TRIM_THRESHOLD_") == nullptr) mallopt(M_TRIM_THRESHOLD, kept);
#endif
}
