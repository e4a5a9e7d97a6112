/* What a plugin of Partonomy is: a shared library with one algorithm, a measurement of a region or between regions. An
 * ontology names it in core:measure or core:criterion like the built-in ones. Plain C, so that any compiler will do. */

#ifndef PARTONOMY_PLUGIN_H
#define PARTONOMY_PLUGIN_H

#include <stddef.h>

/* Changes when anything below does; a plugin that was made for another version is refused. */
#define PARTONOMY_PLUGIN_VERSION 1

/* One region: some triangles of the mesh. All lengths are in the units of the mesh file. */
typedef struct PartonomyRegion {
    const double* corners; /* nine numbers a triangle: x, y, z of its corners, counter-clockwise from outside */
    size_t triangle_count;
    double box_lengths[3]; /* of the smallest box around the region, longest first; noise does not enlarge them */
} PartonomyRegion;

typedef struct PartonomyObject {
    double up[3];           /* unit vector */
    double low, high;       /* extent of the whole object along up */
    double metres_per_unit; /* 0 when the unit is not known */
} PartonomyObject;

typedef struct PartonomyAlgorithm {
    int version;             /* PARTONOMY_PLUGIN_VERSION */
    const char* name;        /* as core:measure says it */
    const char* unit;        /* "1", "degrees", "m" … */
    const char* description; /* for the catalogue */
    int region_count;        /* 1: of a region; 2 or 3: between regions, the target first */
    /* The measurement. NaN, infinity or a C++ exception: the question stays open, and a note says why. What is pointed
     * to lives as long as the call. Must give the same number for the same regions, whenever it is called. */
    double (*measure)(const PartonomyObject* object, const PartonomyRegion* regions);
} PartonomyAlgorithm;

#ifdef __cplusplus
extern "C" {
#endif
/* The one function that a plugin exports. What it returns lives as long as the program. */
__attribute__((visibility("default"))) const PartonomyAlgorithm* partonomy_algorithm(void);
#ifdef __cplusplus
}
#endif

#endif
