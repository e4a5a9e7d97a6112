#include "shape/ranges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace partonomy {

void for_each_range(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& work,
                    std::size_t grain) {
    if (threads == 1 || count <= grain) {
        work(0, count);
        return;
    }
    tbb::task_arena arena(threads <= 0 ? tbb::task_arena::automatic : threads);
    arena.execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                          [&](const tbb::blocked_range<std::size_t>& range) { work(range.begin(), range.end()); });
    });
}

}  // namespace partonomy
