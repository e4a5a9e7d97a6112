// Compiled once for each thing that may be wrong with a plugin (FAULT_…), and once with a good measure of two regions.

#include <partonomy/plugin.h>

#include <cmath>
#include <stdexcept>

namespace {

double measure(const PartonomyObject*, const PartonomyRegion* regions) {
#if defined(FAULT_throws)
    throw std::runtime_error("no luck today");
#elif defined(FAULT_nan)
    return std::nan("");
#elif defined(FAULT_infinite)
    return INFINITY;
#elif defined(FAULT_pair)
    return regions[0].box_lengths[0] / regions[1].box_lengths[0];
#endif
    return regions[0].box_lengths[0];
}

const PartonomyAlgorithm algorithm = {
#if defined(FAULT_other_version)
    99,
#else
    PARTONOMY_PLUGIN_VERSION,
#endif
#if defined(FAULT_no_name)
    "",
#elif defined(FAULT_taken)
    "inclination",
#elif defined(FAULT_pair)
    "relative length",
#else
    "top heaviness",
#endif
    "1",    "for a test",
#if defined(FAULT_four_regions)
    4,
#elif defined(FAULT_pair)
    2,
#else
    1,
#endif
#if defined(FAULT_no_measure)
    nullptr
#else
    measure
#endif
};

}  // namespace

#if defined(FAULT_no_entry)
extern "C" const PartonomyAlgorithm* another_name() { return &algorithm; }
#else
const PartonomyAlgorithm* partonomy_algorithm() {
#if defined(FAULT_entry_throws)
    throw std::runtime_error("not today");
#elif defined(FAULT_nothing)
    return nullptr;
#endif
    return &algorithm;
}
#endif
