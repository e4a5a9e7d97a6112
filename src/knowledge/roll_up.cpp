/* Rules that are class axioms in other words.

   hasPart(?o, ?p), Seat(?p), height(?p, ?h), lessThan(?h, 0.3) -> LowSeated(?o) says the same as
   (hasPart some (Seat and height some xsd:double[< 0.3])) SubClassOf: LowSeated: start at the head's variable, and walk
   along the body's atoms; each other variable becomes what stands behind a `some`. That is the same as long as the
   variables form a tree and each number is compared with constants only (Horrocks and Tessaris 2000 call it rolling up
   a query). A rule with a circle, or with two things compared, says more and stays a rule. */

#include <algorithm>
#include <map>
#include <set>

#include "knowledge/plain.h"
#include "owl/make_class.h"
#include "owl/words.h"

namespace partonomy::knowledge {
namespace {

using owl::ClassExpression;
using owl::ClassKind;
using owl::ClassPointer;
using owl::DataRange;
using owl::Iri;
using owl::RuleAtom;
using owl::RuleTerm;

bool is_variable(const RuleTerm& term) { return term.kind == RuleTerm::Kind::variable; }

ClassPointer all_of(std::vector<ClassPointer> operands) {
    return operands.empty() ? owl::thing() : owl::combined(ClassKind::intersection_of, std::move(operands));
}

/// xsd:double[facet x] and the like for one comparison of a variable with a constant; nullopt for anything else.
std::optional<DataRange> range_of(const RuleAtom& atom, const Iri& variable) {
    const std::string name = owl::local_name(atom.iri);
    if (!atom.iri.starts_with(owl::swrlb_prefix) || atom.arguments.size() != 2) return std::nullopt;
    const bool is_first = is_variable(atom.arguments[0]) && atom.arguments[0].iri == variable;
    const RuleTerm& other = atom.arguments[is_first ? 1 : 0];
    if (other.kind != RuleTerm::Kind::literal) return std::nullopt;
    const std::string xsd = owl::xsd_prefix;
    DataRange range;
    if (name == "equal" || name == "notEqual") {
        range.kind = owl::DataRangeKind::one_of;
        range.values = {{other.literal.value, xsd + "double", {}}};
        if (name == "equal") return range;
        DataRange others;
        others.kind = owl::DataRangeKind::complement_of;
        others.operands = {range};
        return others;
    }
    static const std::map<std::string, std::pair<std::string, std::string>> facets{
        {"lessThan", {"maxExclusive", "minExclusive"}},
        {"lessThanOrEqual", {"maxInclusive", "minInclusive"}},
        {"greaterThan", {"minExclusive", "maxExclusive"}},
        {"greaterThanOrEqual", {"minInclusive", "maxInclusive"}}};
    const auto found = facets.find(name);
    if (found == facets.end()) return std::nullopt;
    range.datatype = xsd + "double";
    range.facets = {
        {xsd + (is_first ? found->second.first : found->second.second), {other.literal.value, xsd + "double", {}}}};
    return range;
}

class RollUp {
public:
    RollUp(const owl::Rule& rule, const std::function<bool(const Iri&)>& is_measured)
        : rule_(rule), is_measured_(is_measured), used_(rule.body.size(), 0) {}

    std::optional<std::pair<ClassPointer, ClassPointer>> run() {
        std::vector<ClassPointer> heads;
        Iri root;
        for (const RuleAtom& atom : rule_.head) {
            if (atom.kind != RuleAtom::Kind::of_class || !is_variable(atom.arguments[0])) return std::nullopt;
            if (!heads.empty() && root != atom.arguments[0].iri) return std::nullopt;
            root = atom.arguments[0].iri;
            heads.push_back(atom.klass);
        }
        if (heads.empty()) return std::nullopt;
        const std::optional<ClassPointer> body = describe(root);
        if (!body || std::ranges::count(used_, 0) > 0) return std::nullopt;
        return std::pair(*body, all_of(std::move(heads)));
    }

private:
    /// What the atoms that were not used yet say of a variable; nullopt when they form a circle.
    std::optional<ClassPointer> describe(const Iri& variable) {
        if (!seen_.insert(variable).second) return std::nullopt;
        std::vector<ClassPointer> parts;
        for (std::size_t i = 0; i < rule_.body.size(); ++i) {
            const RuleAtom& atom = rule_.body[i];
            const auto is_here = [&](std::size_t k) {
                return is_variable(atom.arguments[k]) && atom.arguments[k].iri == variable;
            };
            if (used_[i] || atom.arguments.empty()) continue;
            if (atom.kind == RuleAtom::Kind::of_class && is_here(0)) {
                used_[i] = 1;
                parts.push_back(atom.klass);
            } else if (atom.kind == RuleAtom::Kind::object_property && (is_here(0) || is_here(1))) {
                if (is_here(0) && is_here(1)) return std::nullopt;
                used_[i] = 1;
                auto link = std::make_shared<ClassExpression>();
                link->property = {atom.property.iri, atom.property.inverse != is_here(1)};
                const RuleTerm& other = atom.arguments[is_here(0) ? 1 : 0];
                if (is_variable(other)) {
                    const std::optional<ClassPointer> filler = describe(other.iri);
                    if (!filler) return std::nullopt;
                    link->kind = ClassKind::some_values_from;
                    link->operands = {*filler};
                } else {
                    link->kind = ClassKind::has_value;
                    link->individuals = {other.iri};
                }
                parts.push_back(link);
            } else if (atom.kind == RuleAtom::Kind::data_property && is_here(0)) {
                used_[i] = 1;
                const std::optional<ClassPointer> number = describe_number(atom);
                if (!number) return std::nullopt;
                parts.push_back(*number);
            }
        }
        return all_of(std::move(parts));
    }

    std::optional<ClassPointer> describe_number(const RuleAtom& atom) {
        if (!is_measured_(atom.property.iri) || !is_variable(atom.arguments[1])) return std::nullopt;
        const Iri& number = atom.arguments[1].iri;
        if (!seen_.insert(number).second) return std::nullopt;
        DataRange range;
        range.kind = owl::DataRangeKind::intersection_of;
        for (std::size_t i = 0; i < rule_.body.size(); ++i) {
            const RuleAtom& other = rule_.body[i];
            const bool is_about = std::ranges::any_of(
                other.arguments, [&](const RuleTerm& term) { return is_variable(term) && term.iri == number; });
            if (!is_about || &other == &atom) continue;
            if (used_[i]) return std::nullopt;
            std::optional<DataRange> part;
            if (other.kind == RuleAtom::Kind::of_data_range) part = other.range;
            if (other.kind == RuleAtom::Kind::built_in) part = range_of(other, number);
            if (!part) return std::nullopt;
            used_[i] = 1;
            range.operands.push_back(std::move(*part));
        }
        auto restriction = std::make_shared<ClassExpression>();
        restriction->kind = ClassKind::data_some_values_from;
        restriction->property = atom.property;
        if (range.operands.empty())
            restriction->range.datatype = std::string(owl::xsd_prefix) + "double";
        else
            restriction->range = range.operands.size() == 1 ? range.operands[0] : range;
        return restriction;
    }

    const owl::Rule& rule_;
    const std::function<bool(const Iri&)>& is_measured_;
    std::vector<char> used_;
    std::set<Iri> seen_;
};

}  // namespace

std::optional<std::pair<ClassPointer, ClassPointer>> roll_up(const owl::Rule& rule,
                                                             const std::function<bool(const Iri&)>& is_measured) {
    return RollUp(rule, is_measured).run();
}

}  // namespace partonomy::knowledge
