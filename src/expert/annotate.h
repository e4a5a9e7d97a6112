#pragma once

#include "expert/annotation.h"
#include "expert/session.h"

namespace partonomy {

struct AnnotateOptions {
    Strategy strategy = Strategy::expert;
    knowledge::SplitCriterion criterion = knowledge::SplitCriterion::gain_per_cost;
};

/// Cuts and names the parts of an object, recognises it, and says what is wrong with it (paper §3.3.2, §5.1.2).
/// Everything but the names and hashes of the files is filled in.
[[nodiscard]] Annotation annotate(const knowledge::Domain& domain, const Catalogue& catalogue, const Object& object,
                                  const AnnotateOptions& options = {});

/// Why an object is incompatible, one diagnosis for each incompatible concept that holds, or one for a contradiction.
[[nodiscard]] std::vector<Diagnosis> diagnose(const Session& session, const knowledge::Conclusions& known);

/// What to compare with: "expert", "naive", "segment-then-identify". Throws UsageError for another word.
[[nodiscard]] Strategy parse_strategy(const std::string& word);

/// "dichotomy" or "gain-per-cost". Throws UsageError for another word.
[[nodiscard]] knowledge::SplitCriterion parse_criterion(const std::string& word);

}  // namespace partonomy
