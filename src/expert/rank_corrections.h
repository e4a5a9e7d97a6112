#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "expert/annotation.h"
#include "expert/session.h"
#include "knowledge/explain.h"

namespace partonomy {

/// What would mend an object, and what it would no longer be.
struct RankedCorrection {
    Diagnosis::Change change;
    std::vector<int> parts;      ///< regions each of which may be the one to take away; for one part only
    std::vector<owl::Iri> lost;  ///< concepts of the object
    bool has_some = false;       ///< of what is to be added, there is one already
};

/// Finds corrections of one object; the session must outlive it.
class Corrector {
public:
    /// `learned`: the session's answers as the annotation keeps them.
    Corrector(const Session& session, const knowledge::Conclusions& known, const std::vector<LearnedAnswer>& learned);

    /// At most eight: those that leave the object what it is, then the others; each by cost, of costs that are alike
    /// first what the rule itself asks for, then what was measured nearest to where the answers turn, then those about
    /// the parts to blame (`blamed`, from 1). An empty IRI: of a contradiction. `region` of a concept of regions, else
    /// -1. Throws OntologyError where a limit is reached.
    [[nodiscard]] std::vector<RankedCorrection> ranked(const owl::Iri& iri, int region,
                                                       const knowledge::Explanation& why,
                                                       const std::vector<int>& blamed) const;

    /// The parts that have a name for sure: regions, alone or those of a composite part.
    [[nodiscard]] std::vector<std::vector<int>> bearers(const owl::Iri& name) const;

private:
    using Conclusions = knowledge::Conclusions;

    [[nodiscard]] std::vector<owl::Iri> lost(const Conclusions& after) const;
    [[nodiscard]] const Conclusions& turned(const std::vector<std::size_t>& answers) const;
    [[nodiscard]] bool mends(const Conclusions& after, const owl::Iri& iri, int region) const;
    [[nodiscard]] std::vector<std::size_t> said_alike(std::size_t answer, const std::vector<int>& parts) const;
    [[nodiscard]] std::vector<RankedCorrection> by_answers_of(const owl::Iri& iri, int region,
                                                              const knowledge::Explanation& why,
                                                              const std::vector<int>& blamed) const;
    [[nodiscard]] bool keeps(const std::vector<std::size_t>& answers, const owl::Iri& iri, int region) const;
    [[nodiscard]] std::vector<std::size_t> fewest(std::vector<std::size_t> set, const owl::Iri& iri, int region) const;
    [[nodiscard]] bool is_named_in(const std::vector<const owl::Axiom*>& axioms, std::size_t answer) const;
    [[nodiscard]] std::vector<RankedCorrection> by_numbers_of_parts(const owl::Iri& iri) const;
    [[nodiscard]] std::vector<owl::Iri> kinds_of(const owl::Iri& name) const;
    [[nodiscard]] std::optional<Conclusions> with_more(const owl::Iri& name, std::size_t count) const;
    [[nodiscard]] Conclusions without(const std::vector<int>& regions) const;

    const Session& session_;
    const knowledge::Domain& domain_;
    const Conclusions& known_;
    knowledge::Knowledge knowledge_;
    std::vector<owl::Iri> classes_;  ///< of the object, the most specific
    std::vector<double> costs_;      ///< of turning each answer round
    const std::vector<LearnedAnswer>& learned_;
    mutable std::map<std::vector<std::size_t>, Conclusions> turned_;
};

}  // namespace partonomy
