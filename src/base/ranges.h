#pragma once

#include <cstddef>
#include <functional>

namespace partonomy {

/// Calls work(begin, end) for pieces that cover [0, count) once. threads <= 0: all cores; 1: one call on this thread.
/// Pieces hold about `grain` items. The work on different pieces must be independent.
void for_each_range(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& work,
                    std::size_t grain = 2048);

}  // namespace partonomy
