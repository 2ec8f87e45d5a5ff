#include "Heap.hpp"

#include <cstddef>
#include <cstdlib>
#include <memory>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace {

// Larger ones, the fields of many load steps, would need whole holes of the heap when they grow, and may find none: 12
// for 10.5 fields for each step in command_line_many_steps. A value of one's own also keeps the C library from moving
// the threshold.
constexpr int alwaysGivenBack = 8 << 20;
constexpr int kept = 256 << 20;
// More than what is kept at the end of the heap would be given back at once.
constexpr int inHugePages = 128 << 20;
static_assert(inHugePages < kept);
constexpr std::size_t hugePage = 2 << 20;
constexpr int usualPad = 128 << 10;

bool isUnlimited(__rlimit_resource resource) {
  rlimit limit{};
  return getrlimit(resource, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
}

}  // namespace
#endif

void keepFreedMemory() {
#ifdef __GLIBC__
  // What users set in the environment is theirs.
  if (std::getenv("MALLOC_MMAP_THRESHOLD_") == nullptr) mallopt(M_MMAP_THRESHOLD, alwaysGivenBack);
  if (std::getenv("MALLOC_TRIM_THRESHOLD_") == nullptr) mallopt(M_TRIM_THRESHOLD, kept);
#endif
}

void useHugePages(int processes) {
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
  if (std::getenv("MALLOC_TOP_PAD_") != nullptr || std::getenv("MALLOC_TRIM_THRESHOLD_") != nullptr) return;
  // The addresses are asked for at once.
  if (!isUnlimited(RLIMIT_AS) || !isUnlimited(RLIMIT_DATA)) return;
  char* const before = static_cast<char*>(sbrk(0));
  mallopt(M_TOP_PAD, inHugePages / processes);
  void* volatile grown = std::malloc(alwaysGivenBack / 2);  // volatile: or the compiler leaves it out
  std::free(grown);
  mallopt(M_TOP_PAD, usualPad);
  void* begin = before;
  auto size = static_cast<std::size_t>(static_cast<char*>(sbrk(0)) - before);
  // A hint: where it is refused, nothing is lost.
  if (std::align(hugePage, hugePage, begin, size) != nullptr) madvise(begin, size, MADV_HUGEPAGE);
#else
  static_cast<void>(processes);
#endif
}
