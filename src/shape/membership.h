#pragma once

#include <limits>

namespace partonomy {

/// The trapezoidal membership function of paper §4.1: 0 up to a1, rising to 1 at a2, 1 up to a3, falling to 0 at a4.
/// a1 <= a2 <= a3 <= a4; a1 = a2 = -inf and a3 = a4 = inf are allowed (an open side).
struct Trapezoid {
    double a1, a2, a3, a4;
    /// Score in [0, 1] of the measurement x; 0 when x is not a number.
    [[nodiscard]] double operator()(double x) const;
    [[nodiscard]] bool is_ordered() const { return a1 <= a2 && a2 <= a3 && a3 <= a4; }
};

}  // namespace partonomy
