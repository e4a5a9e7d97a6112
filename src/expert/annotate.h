#pragma once

#include "expert/annotation.h"
#include "expert/session.h"

namespace partonomy {

struct AnnotateOptions {
    Strategy strategy = Strategy::expert;
    knowledge::SplitCriterion criterion = knowledge::SplitCriterion::gain_per_cost;
    bool diagnose = true;  ///< false: `consistent` is told, but not why
    bool mend = true;      ///< the cut by what the ontology says of it, with Strategy::expert; see final_labelling.h
    int threads = 1;       ///< <= 0: all cores
    /// What a person says of the parts, which are numbered as they are without this (accepted_answers.h).
    std::vector<LearnedAnswer> accepted = {};
    std::string accepted_source = {};  ///< the file that says so
};

/// Cuts and names the parts of an object, recognises it, and says what is wrong with it (paper §3.3.2, §5.1.2).
/// Everything but the names and hashes of the files is filled in. Throws UsageError for accepted answers that cannot
/// be.
[[nodiscard]] Annotation annotate(const knowledge::Domain& domain, const Catalogue& catalogue, const Object& object,
                                  const AnnotateOptions& options = {});

/// Why an object is incompatible, one diagnosis for each incompatible concept that holds, or one for a contradiction.
/// `learned`: the session's answers as the annotation keeps them.
[[nodiscard]] std::vector<Diagnosis> diagnose(const Session& session, const knowledge::Conclusions& known,
                                              const std::vector<LearnedAnswer>& learned);

/// "part 3: is it a board: yes (0.98) [l1/l2 5.9 (wanted >= 2)]", or "(a person said so)" when that is where it is
/// from.
[[nodiscard]] std::string answer_in_words(const knowledge::Domain& domain, const knowledge::Answer& answer,
                                          const LearnedAnswer& learned);
/// The same without the part.
[[nodiscard]] std::string what_was_answered(const knowledge::Domain& domain, const knowledge::Answer& answer,
                                            const LearnedAnswer& learned);
/// "Seat EquivalentTo: … (furniture.ttl:31)".
[[nodiscard]] std::string axiom_in_words(const owl::Axiom& axiom);
/// What an explanation that rests on completeness says.
inline constexpr const char* no_other_parts = "there are no other parts";

/// The IRI of a range concept or measured property; of a relation to other regions the expression in Manchester syntax.
[[nodiscard]] std::string feature_name(const knowledge::Variable& variable);
/// Answers by name as knowledge of the domain again. Throws UsageError for a name that the ontology does not have.
[[nodiscard]] knowledge::Knowledge recall(const knowledge::Domain& domain, int part_count, bool is_complete,
                                          const std::vector<LearnedAnswer>& answers,
                                          const std::vector<std::pair<int, int>>& connected);

/// What to compare with: "expert", "naive", "segment-then-identify". Throws UsageError for another word.
[[nodiscard]] Strategy parse_strategy(const std::string& word);

/// "dichotomy" or "gain-per-cost". Throws UsageError for another word.
[[nodiscard]] knowledge::SplitCriterion parse_criterion(const std::string& word);

}  // namespace partonomy
