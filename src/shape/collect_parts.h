#pragma once

#include <chrono>

#include "shape/find_parts.h"

namespace partonomy {

/// The regions of a cut mesh with their boxes: `part_of` is the number of each triangle's part, -1 for none. Regions
/// are sorted by their lowest triangle.
[[nodiscard]] std::vector<PartRegion> collect_parts(const TriangleMesh& mesh, const TriangleGeometry& geometry,
                                                    const std::vector<std::int32_t>& part_of, bool is_noisy,
                                                    int threads);

/// Writes down how long each stage took.
class StageClock {
public:
    explicit StageClock(StageTimes* times) : times_(times) {}
    void done(const char* stage) {
        const auto now = std::chrono::steady_clock::now();
        if (times_) times_->emplace_back(stage, std::chrono::duration<double, std::milli>(now - start_).count());
        start_ = now;
    }

private:
    StageTimes* times_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace partonomy
