#include "base/ranges.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <numeric>

namespace partonomy {

void for_each_range(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& work,
                    std::size_t grain) {
    // More than TBB has would make it warn on stderr.
    const auto most = static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    threads = threads <= 0 ? most : std::min(threads, most);
    if (threads == 1 || count <= grain) {
        work(0, count);
        return;
    }
    const auto all = [&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                          [&](const tbb::blocked_range<std::size_t>& range) { work(range.begin(), range.end()); });
    };
    if (threads == most)
        all();  // an arena of one's own costs more than a small mesh gains
    else
        tbb::task_arena(threads).execute(all);
}

double sum(std::span<const double> values, int threads) {
    const std::vector<double> sums = map_blocks(values.size(), threads, [&](std::size_t begin, std::size_t end) {
        const auto block = values.subspan(begin, end - begin);
        return std::accumulate(block.begin(), block.end(), 0.0);
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace partonomy
