#include "closed_answer.h"

using partonomy::owl::local_name;

std::string fact(const partonomy::owl::Iri& predicate, const partonomy::owl::Iri& a, const partonomy::owl::Iri& b) {
    std::string result = local_name(predicate);
    result.append("(").append(local_name(a));
    if (!b.empty()) result.append(",").append(local_name(b));
    return result.append(")");
}

ClosedAnswer our_answer(const partonomy::knowledge::ClosedWorld& world) {
    partonomy::knowledge::ClosedReasoner reasoner(world);
    ClosedAnswer answer;
    answer.consistent = reasoner.is_consistent();
    if (!answer.consistent) return answer;
    for (const auto& [individual, klass] : reasoner.all_types()) answer.entailed.insert(fact(klass, individual));
    for (const auto& [subject, property, object] : reasoner.relations())
        answer.entailed.insert(fact(property, subject, object));
    for (const auto& [a, b] : reasoner.same_individuals())
        answer.entailed.insert(local_name(a).append("=").append(local_name(b)));
    return answer;
}

std::string line_of(const ClosedAnswer& answer) {
    if (!answer.consistent) return "inconsistent";
    std::string line = "consistent ";
    for (const std::string& each : answer.entailed) line.append(each).append(" ");
    return line;
}
