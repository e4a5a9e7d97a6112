#pragma once

#include <gtest/gtest.h>

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

/// The paper's seven objects, and how tests of each are called.
inline const auto paper_object_names =
    testing::Values("bench", "bench2", "chair", "chair2", "couch", "curved-bench", "strange-object2");
inline std::string without_dashes(const testing::TestParamInfo<std::string>& name) {
    std::string word = name.param;
    std::erase(word, '-');
    return word;
}

}  // namespace partonomy
