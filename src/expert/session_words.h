#pragma once

#include <fmt/format.h>

#include <chrono>
#include <string>

// Inside of the session: what its trace needs.

namespace partonomy {

/// Milliseconds since construction.
class Stopwatch {
public:
    [[nodiscard]] double ms() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "part 3" for region 2.
inline std::string region_name(int region) { return fmt::format("part {}", region + 1); }

/// "1 region", "4 regions".
inline std::string how_many(int count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace partonomy
