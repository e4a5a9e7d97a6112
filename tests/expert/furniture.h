#pragma once

#include "expert/annotate.h"

namespace partonomy {

/// furniture.ttl, compiled once for all tests of the program.
struct Furniture {
    knowledge::Domain domain = knowledge::compile(owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/furniture.ttl"));
    Catalogue catalogue = make_catalogue(domain);

    static const Furniture& get() {
        static const Furniture furniture;
        return furniture;
    }
    [[nodiscard]] Annotation annotate(const TriangleMesh& mesh, const Placement& placement = {},
                                      const AnnotateOptions& options = {}) const {
        return partonomy::annotate(domain, catalogue, make_object(mesh, placement), options);
    }
};

}  // namespace partonomy
