#include "base/zeroed_allocator.h"

#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace lightbench {
namespace {

constexpr std::size_t kManyBytes = std::size_t{4} << 20;  // twice a large page

}  // namespace

void* allocate_zeroed(std::size_t bytes) {
  if (bytes < kManyBytes) {
    if (void* memory = std::calloc(1, bytes)) return memory;
    throw std::bad_alloc();
  }
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: page faults are most of the time that large memory takes
#endif
  return memory;
}

void free_zeroed(void* memory, std::size_t bytes) {
  if (bytes < kManyBytes)
    std::free(memory);
  else
    munmap(memory, bytes);
}

}  // namespace lightbench
