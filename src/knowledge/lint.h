#pragma once

#include <functional>
#include <string>
#include <vector>

#include "knowledge/decision_tree.h"

namespace partonomy::knowledge {

enum class FindingKind {
    refused,            ///< an axiom cannot be grounded
    contradiction,      ///< the axioms leave no region, or no object
    unsatisfiable,      ///< nothing can be a member of a concept
    unprovable,         ///< nothing can be proved to be a member of a concept
    indistinguishable,  ///< nothing can tell concepts apart
    unanswerable,       ///< no algorithm answers a question
    unknown_term,       ///< a term of the core ontology that there is not
    left_aside,         ///< a class of neither regions nor objects
    universal,          ///< every region, or every object, is a member of a concept
    gap,                ///< a measurement that no value of a covered range fits
    unused,             ///< no axiom asks for a concept, a value or a property
    uncounted,          ///< the configurations of a layer are too many to count
    overlapping,        ///< something may be a member of several concepts
    own_side,           ///< a relation whose other side is not named, or only the one on which the part itself is
    both_fit,           ///< a measurement that two values of a range fit fully
};

/// "unsatisfiable", "unknown term" …
[[nodiscard]] std::string to_text(FindingKind kind);

/// Something that an expert should know about an ontology.
struct Finding {
    FindingKind kind;
    bool is_wrong = true;                          ///< false: a remark
    std::vector<Iri> concepts;                     ///< that it is about (classes, properties or other terms)
    owl::Source where;                             ///< of the axiom, annotation or declaration to look at
    std::string what;                              ///< one sentence, without the place
    std::string advice;                            ///< what would be right
    std::vector<std::vector<std::size_t>> causes;  ///< minimal sets of axioms (indices into Ontology::axioms)
};

struct LintOptions {
    /// Whether some algorithm answers the question about a region; every question counts as answered when it is empty.
    std::function<bool(Question)> can_answer;
    std::size_t causes = 3;        ///< listed for each unsatisfiable concept
    std::size_t explained = 50;    ///< unsatisfiable concepts to find causes for
    std::size_t overlapping = 20;  ///< concepts to tell overlaps of
};

/// All findings about a compiled ontology but unknown terms: what is wrong first, then remarks; each kind by place.
/// Bounded: spaces that are not listed are looked at by a SAT solver, about once for each concept.
[[nodiscard]] std::vector<Finding> lint(const Domain& domain, const LintOptions& options = {});

/// Terms in the core ontology's namespace (or one spelled nearly like it) that it does not declare, each with the
/// nearest term that it does.
[[nodiscard]] std::vector<Finding> unknown_terms(const owl::Ontology& ontology);

/// What cannot be grounded, all of it, as compile() would say it, in the order of the axioms and each sentence once.
/// Circles of definitions, and knobs that are no numbers, one at a time. Empty where the axioms can be read.
[[nodiscard]] std::vector<std::string> all_refusals(const owl::Ontology& ontology);

/// Why `ontology` cannot be compiled, given the error that compile() threw for it: a contradiction with its causes, or
/// the error itself and what else is refused. At least one.
[[nodiscard]] std::vector<Finding> why_refused(const owl::Ontology& ontology, const std::string& error);

}  // namespace partonomy::knowledge
