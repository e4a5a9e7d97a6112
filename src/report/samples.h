#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// The depth of a triangle's plane over a grid of samples, and the range of depths within the triangle.
struct DepthPlane {
    double start = 0, along_x = 0, along_y = 0;  ///< depth at (x, y): start + along_x x + along_y y
    double near = 0, far = 0;

    /// Depth at (x, y), held within the triangle's own range widened by `slack`.
    [[nodiscard]] double at(double x, double y, double slack) const {
        const double depth = start + along_x * x + along_y * y;
        return depth < near - slack ? near - slack : depth > far + slack ? far + slack : depth;
    }
};

/// A rectangle of samples, each holding the index of what is in front there.
class Samples {
public:
    Samples(int columns, int rows)
        : columns_(columns),
          rows_(rows),
          front_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)),
          depths_(front_.size()) {}

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }

    /// Nothing is in front anywhere (-1).
    void clear();

    /// Puts a triangle, corners (column, row, depth), in front wherever it covers the sample at whole (column, row) and
    /// lies before what is there; of two at the same depth the earlier one stays. Its plane; triangles seen edge-on
    /// cover nothing.
    DepthPlane add(const std::array<Vec3, 3>& corners, std::int32_t index);

    /// The `columns()` indices of a row.
    [[nodiscard]] const std::int32_t* row(int y) const {
        return front_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_);
    }

private:
    int columns_, rows_;
    std::vector<std::int32_t> front_;
    std::vector<float> depths_;
};

}  // namespace partonomy
