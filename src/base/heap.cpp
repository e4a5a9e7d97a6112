#include "base/heap.h"

#include <malloc.h>

namespace partonomy {

void keep_freed_memory() {
    constexpr int megabyte = 1 << 20;
    ::mallopt(M_MMAP_THRESHOLD, 32 * megabyte);
    ::mallopt(M_TRIM_THRESHOLD, 64 * megabyte);
    ::mallopt(M_TOP_PAD, 4 * megabyte);
    ::mallopt(M_ARENA_MAX, 1);  // threads work on what others made; heaps of their own are only more pages
}

}  // namespace partonomy
