// Memory of a whole program: linked by programs only, for it replaces what `new` does.
//
// The first touch of a page of 4 KB costs as much as working on it several times: on five million triangles a tenth of
// all time, of which threads take little off, for the system hands out pages one after the other. On pages of 2 MB it
// costs a sixth.

#include "base/heap.h"

#include <malloc.h>
#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>
#include <new>

namespace partonomy {

namespace {

constexpr std::size_t megabyte = 1 << 20;
constexpr std::size_t large = 4 * megabyte;
constexpr std::size_t start_of_heap = 24 * megabyte;  // where small arrays lie; must be less than what is given back
constexpr std::uintptr_t page = 4096;

/// Asks for large pages wherever they fit into an array; a system that has none goes on with small ones.
void prefer_large_pages(void* array, std::size_t bytes) {
    const auto begin = (reinterpret_cast<std::uintptr_t>(array) + page - 1) / page * page;
    const auto end = (reinterpret_cast<std::uintptr_t>(array) + bytes) / page * page;
    ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

}  // namespace

void keep_freed_memory() {
    ::mallopt(M_MMAP_THRESHOLD, 32 * megabyte);
    ::mallopt(M_TRIM_THRESHOLD, 64 * megabyte);
    ::mallopt(M_TOP_PAD, 4 * megabyte);
    ::mallopt(M_ARENA_MAX, 1);  // threads work on what others made; heaps of their own are only more pages
    void* const start = std::malloc(start_of_heap);
    if (start != nullptr) prefer_large_pages(start, start_of_heap);
    std::free(start);  // stays with the process, untouched
}

}  // namespace partonomy

void* operator new(std::size_t bytes) {
    for (;;) {
        if (void* const array = std::malloc(bytes > 0 ? bytes : 1)) {
            if (bytes >= partonomy::large) partonomy::prefer_large_pages(array, bytes);
            return array;
        }
        if (const std::new_handler handler = std::get_new_handler())
            handler();
        else
            throw std::bad_alloc();
    }
}

void operator delete(void* array) noexcept { std::free(array); }
void operator delete(void* array, std::size_t) noexcept { std::free(array); }
