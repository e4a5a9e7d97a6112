#pragma once

#include <string>

#include "owl/ontology.h"

namespace partonomy::owl {

struct WriteOptions {
    /// False: what the document itself says, with owl:imports of all that was imported; readers find those again.
    /// True: one self-contained document that says all and imports nothing.
    bool merge_imports = false;
};

/// The ontology in Turtle: declarations, annotations and axioms with their annotations, each axiom of the kinds that
/// OWL 2 has. Reading it back gives the same axioms, but that of n things that are equivalent or the same RDF says n-1
/// pairs. Same ontology, same bytes.
[[nodiscard]] std::string write_turtle(const Ontology& ontology, const WriteOptions& options = {});

/// The same in functional syntax.
[[nodiscard]] std::string write_functional(const Ontology& ontology, const WriteOptions& options = {});

/// One axiom in functional syntax, all names in full, without its annotations: equal axioms have equal texts.
[[nodiscard]] std::string functional_text(const Axiom& axiom);

}  // namespace partonomy::owl
