// A measure of a region: how much of its surface lies in its upper half. A cone on its tip is top-heavy, a bell is not.
//
//   c++ -std=c++20 -O2 -shared -fPIC -Iinclude examples/plugin/top_heaviness.cpp -o top_heaviness.so
//   partonomy annotate MESH --ontology ONTOLOGY --plugin top_heaviness.so
//
// In the ontology: :TopHeavy core:measure "top heaviness" ; core:membership "0.55 0.65 inf inf" .

#include <partonomy/plugin.h>

#include <algorithm>
#include <cmath>

namespace {

double height(const PartonomyObject& object, const double* point) {
    return point[0] * object.up[0] + point[1] * object.up[1] + point[2] * object.up[2];
}

double top_heaviness(const PartonomyObject* object, const PartonomyRegion* region) {
    double low = INFINITY, high = -INFINITY, above = 0, all = 0;
    for (size_t i = 0; i < 3 * region->triangle_count; ++i) {
        low = std::min(low, height(*object, region->corners + 3 * i));
        high = std::max(high, height(*object, region->corners + 3 * i));
    }
    for (size_t i = 0; i < region->triangle_count; ++i) {
        const double *a = region->corners + 9 * i, *b = a + 3, *c = a + 6;
        const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        const double area =
            std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
        all += area;
        if (height(*object, a) + height(*object, b) + height(*object, c) > 1.5 * (low + high)) above += area;
    }
    return above / all;
}

const PartonomyAlgorithm algorithm = {PARTONOMY_PLUGIN_VERSION,
                                      "top heaviness",
                                      "1",
                                      "share of the surface in the upper half of the region",
                                      1,
                                      top_heaviness};

}  // namespace

const PartonomyAlgorithm* partonomy_algorithm() { return &algorithm; }
