// A counting sort: a few threads count what their share of the triangles holds, and know from that where it goes.

#include "shape/pieces.h"

#include <utility>

namespace partonomy {

Groups group_members(std::span<const std::int32_t> group_of, std::size_t groups, int threads) {
    const std::size_t shares = threads == 1 ? 1 : 4;
    std::vector<std::size_t> next(shares * groups, 0);  // counts, then places; those of one share beside each other
    const auto for_each_member = [&](const auto& work) {
        for_each_range(
            shares, threads,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t share = begin; share < end; ++share)
                    for (std::size_t i = group_of.size() * share / shares; i < group_of.size() * (share + 1) / shares;
                         ++i)
                        if (group_of[i] >= 0)
                            work(static_cast<std::int32_t>(i),
                                 next[share * groups + static_cast<std::size_t>(group_of[i])]);
            },
            1);
    };
    for_each_member([](std::int32_t, std::size_t& count) { ++count; });
    Groups result;
    result.begins.reserve(groups + 1);
    std::size_t place = 0;
    for (std::size_t group = 0; group < groups; ++group) {
        result.begins.push_back(place);
        for (std::size_t share = 0; share < shares; ++share)
            place += std::exchange(next[share * groups + group], place);
    }
    result.begins.push_back(place);
    result.members.resize(place);
    for_each_member([&](std::int32_t i, std::size_t& at) { result.members[at++] = i; });
    return result;
}

}  // namespace partonomy
