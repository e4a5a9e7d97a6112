#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/ranges.h"

namespace partonomy {

/// Items sorted into buckets.
template <class Item>
struct Buckets {
    std::unique_ptr<Item[]> items;     ///< those of one bucket beside each other
    std::vector<std::int32_t> begins;  ///< #buckets + 1
    [[nodiscard]] std::size_t size() const { return begins.size() - 1; }
    [[nodiscard]] std::span<const Item> operator[](std::size_t bucket) const {
        return {items.get() + begins[bucket], items.get() + begins[bucket + 1]};
    }
    [[nodiscard]] std::span<Item> operator[](std::size_t bucket) {
        return {items.get() + begins[bucket], items.get() + begins[bucket + 1]};
    }
};

/// A counting sort: visit(i, put) is called twice for each i in [0, count), and puts the same items into the same
/// buckets both times by put(bucket, item). In a bucket, items keep the order in which they were put, on any number of
/// threads. At most 2^31 items; O(items + buckets).
template <class Item, class Visit>
[[nodiscard]] Buckets<Item> sort_into_buckets(std::size_t count, std::size_t buckets, int threads, const Visit& visit) {
    // Each share counts its items, and knows from that where they go: atomic counters would gain nothing.
    const std::size_t shares = threads == 1 ? 1 : 4;
    // Counts, then places; those of one share beside each other, and a cache line away from the next share's.
    constexpr std::size_t line = 64 / sizeof(std::int32_t);
    const std::size_t stride = (buckets / line + 2) * line;
    const auto next = std::make_unique_for_overwrite<std::int32_t[]>(shares * stride);
    const auto for_each_item = [&](const auto& begin_share, const auto& work) {
        for_each_range(
            shares, threads,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t share = begin; share < end; ++share) {
                    std::int32_t* const of_share = next.get() + share * stride;
                    begin_share(of_share);
                    for (std::size_t i = count * share / shares; i < count * (share + 1) / shares; ++i)
                        visit(i, [&](std::int32_t bucket, const Item& item) { work(of_share[bucket], item); });
                }
            },
            1);
    };
    for_each_item([&](std::int32_t* counts) { std::fill_n(counts, buckets, 0); },
                  [](std::int32_t& count_of_bucket, const Item&) { ++count_of_bucket; });
    constexpr std::size_t block = 4096;
    std::vector<std::int32_t> sizes = map_blocks(
        buckets, threads,
        [&](std::size_t begin, std::size_t end) {
            std::int32_t size = 0;
            for (std::size_t share = 0; share < shares; ++share)
                for (std::size_t k = begin; k < end; ++k) size += next[share * stride + k];
            return size;
        },
        block);
    std::int32_t total = 0;
    for (std::int32_t& size : sizes) total += std::exchange(size, total);
    Buckets<Item> result{std::make_unique_for_overwrite<Item[]>(static_cast<std::size_t>(total)),
                         std::vector<std::int32_t>(buckets + 1, total)};
    for_each_range(
        sizes.size(), threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                std::int32_t place = sizes[k];
                for (std::size_t bucket = k * block; bucket < std::min(buckets, (k + 1) * block); ++bucket) {
                    result.begins[bucket] = place;
                    for (std::size_t share = 0; share < shares; ++share)
                        place += std::exchange(next[share * stride + bucket], place);
                }
            }
        },
        1);
    for_each_item([](std::int32_t*) {}, [&](std::int32_t& place, const Item& item) { result.items[place++] = item; });
    return result;
}

}  // namespace partonomy
