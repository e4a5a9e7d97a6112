#pragma once

#include <set>
#include <string>

#include "knowledge/closed_world.h"

/// What follows from a closed world, in a form that every judge can give.
struct ClosedAnswer {
    bool consistent = false;
    std::set<std::string> entailed;  ///< "C0(a0)", "p0(a0,a1)", "a0=a1"; empty when inconsistent
    bool operator==(const ClosedAnswer&) const = default;
};

/// The answer of ClosedReasoner.
[[nodiscard]] ClosedAnswer our_answer(const partonomy::knowledge::ClosedWorld& world);

/// "consistent C0(a0) a0=a1 ", or "inconsistent".
[[nodiscard]] std::string line_of(const ClosedAnswer& answer);

/// "p0(a0,a1)" with local names.
[[nodiscard]] std::string fact(const partonomy::owl::Iri& predicate, const partonomy::owl::Iri& a,
                               const partonomy::owl::Iri& b = {});
