#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <vector>

namespace partonomy {

/// Numbers 0 to count - 1 in sets that grow together; the lowest number stands for its set, so the order of joining
/// does not matter, and several threads may join at once: a link always leads to a lower number.
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
    std::int32_t find(std::int32_t i) {
        for (std::int32_t up = parent(i).load(relaxed); up != i; up = parent(i).load(relaxed)) {
            const std::int32_t above = parent(up).load(relaxed);
            if (above != up) parent(i).compare_exchange_weak(up, above, relaxed);
            i = above;
        }
        return i;
    }
    void join(std::int32_t a, std::int32_t b) {
        for (a = find(a), b = find(b); a != b; a = find(a), b = find(b)) {
            std::int32_t high = std::max(a, b);
            if (parent(high).compare_exchange_strong(high, std::min(a, b), relaxed)) return;
        }
    }

private:
    static constexpr std::memory_order relaxed = std::memory_order_relaxed;
    std::atomic_ref<std::int32_t> parent(std::int32_t i) { return std::atomic_ref<std::int32_t>(parent_[i]); }
    std::vector<std::int32_t> parent_;
};

}  // namespace partonomy
