#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

namespace partonomy {

/// Calls work(begin, end) for pieces that cover [0, count) once. threads <= 0: all cores; 1: one call on this thread.
/// Pieces hold about `grain` items. The work on different pieces must be independent.
void for_each_range(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& work,
                    std::size_t grain = 2048);

/// What work(begin, end) returns for blocks of [0, count), in order. Blocks are the same on any number of threads, so
/// sums over them round alike; a result must be default-constructible.
template <class Work>
[[nodiscard]] auto map_blocks(std::size_t count, int threads, const Work& work, std::size_t block = 8192) {
    std::vector<std::invoke_result_t<const Work&, std::size_t, std::size_t>> results((count + block - 1) / block);
    for_each_range(
        results.size(), threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) results[k] = work(k * block, std::min(count, (k + 1) * block));
        },
        1);
    return results;
}

/// The sum of the values, the same on any number of threads.
[[nodiscard]] double sum(std::span<const double> values, int threads);

}  // namespace partonomy
