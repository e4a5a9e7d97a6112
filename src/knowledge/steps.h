#pragma once

#include <cstdint>
#include <exception>

namespace partonomy::knowledge {

/// A limit on work that is the same on every machine and in every run, as time is not: what a search has left to take.
/// A step is the work of about a microsecond.
class Steps {
public:
    explicit Steps(std::uint64_t most) : left_(most) {}
    /// False, and nothing is left, when there are fewer.
    bool take(std::uint64_t steps) {
        const bool is_enough = steps <= left_;
        left_ = is_enough ? left_ - steps : 0;
        return is_enough;
    }

private:
    std::uint64_t left_;
};

/// What a search throws that has taken all its steps.
struct OutOfSteps : std::exception {};

}  // namespace partonomy::knowledge
