/* How many literals are enough.

   A data property may have any of infinitely many literals, so before grounding we choose finitely many of them that
   do. Data properties that a subproperty, equivalence or disjointness axiom or a rule connects are one group; groups do
   not know of each other, and each has its own cells (data_cells.cpp). Take any model, and one individual. Of each cell
   keep, for every property d of the group, as many of its values there as the largest number k that a restriction `min
   k` on d over this cell asks for (`some` asks for 1, `max k` for k + 1), and all literals that the ontology mentions;
   drop every other literal from all properties of the group. Each restriction is then as true or false as it was, and
   all that the other axioms say of values they say of all values (subproperties, disjointness, domain, range, keys,
   rules), so they still hold. Hence the sum of those k over the properties of the group is enough of a cell. Values of
   different individuals may be the same ones, unless a key or rule compares them: then there must be enough for
   everybody. */

#include <algorithm>

#include "knowledge/closed_grounder.h"
#include "owl/words.h"

namespace partonomy::knowledge::closed {

using owl::Axiom;
using owl::AxiomKind;
using owl::ClassKind;
using owl::RuleAtom;
using owl::RuleTerm;
using owl::Word;

namespace {

constexpr std::size_t max_values = 100'000;

}  // namespace

int Grounder::data_property_of(const owl::PropertyExpression& expression) {
    const Word word = owl::word_of(expression.iri);
    if (word == Word::owl_topDataProperty) return Property::top;
    if (word == Word::owl_bottomDataProperty) return Property::bottom;
    const int id = data_properties.add(expression.iri);
    if (parents_.size() < data_properties.size()) parents_.push_back(id);
    return id;
}

int Grounder::root_of(int property) {
    const auto parent = [&](int id) -> int& { return parents_[static_cast<std::size_t>(id)]; };
    while (parent(property) != property) property = parent(property) = parent(parent(property));
    return property;
}

void Grounder::join(const std::vector<int>& joined) {
    int first = -1;
    for (const int property : joined) {
        if (property < 0) continue;  // top and bottom
        if (first < 0) first = property;
        const int a = root_of(first), b = root_of(property);
        parents_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
}

void Grounder::mention(int property, const owl::Literal& literal) {
    mention(property, range_id({owl::DataRangeKind::one_of, {}, {}, {literal}, {}}), 0);
}

void Grounder::mention(int property, int range, std::uint64_t count) {
    DataCells check(definitions_);
    check.mention(*ranges_[static_cast<std::size_t>(range)]);
    if (property < 0) return;
    needs_.push_back({property, range, count});
    need_axioms_.push_back(axiom_);
}

void Grounder::collect_restriction(const Expression& expression) {
    if (!is_collecting_) {
        throw CannotGround{
            "it restricts a data property in a way that no axiom does; give it among the questions when "
            "the world is grounded"};
    }
    const std::uint64_t number = expression.number;
    switch (expression.kind) {
        case ClassKind::data_all_values_from:
            return mention(expression.name, complement_id(expression.range), 1);
        case ClassKind::data_min_cardinality:
            return mention(expression.name, expression.range, number);
        case ClassKind::data_max_cardinality:
        case ClassKind::data_exact_cardinality:
            return mention(expression.name, expression.range, number + 1);
        default:
            return mention(expression.name, expression.range, 1);
    }
}

bool Grounder::is_data_property(const owl::PropertyExpression& property) const {
    const Word word = owl::word_of(property.iri);
    return word == Word::owl_topDataProperty || word == Word::owl_bottomDataProperty ||
           world.ontology.find(property.iri, owl::EntityKind::data_property) != nullptr;
}

void Grounder::collect_data(const Axiom& axiom) {
    std::vector<int> ids;
    const auto over_data = [&] {
        for (const owl::PropertyExpression& property : axiom.properties) ids.push_back(data_property_of(property));
    };
    switch (axiom.kind) {
        case AxiomKind::sub_data_property_of:
            over_data();
            if (ids[1] == Property::top) return;
            join(ids);
            break;
        case AxiomKind::equivalent_data_properties:
        case AxiomKind::disjoint_data_properties:
            over_data();
            join(ids);
            break;
        case AxiomKind::data_property_range:
            over_data();
            mention(ids[0], complement_id(range_id(axiom.range)), 0);
            break;
        case AxiomKind::data_property_domain:
        case AxiomKind::functional_data_property:
            over_data();
            break;
        case AxiomKind::data_property_assertion:
        case AxiomKind::negative_data_property_assertion:
            over_data();
            mention(ids[0], axiom.literal);
            break;
        case AxiomKind::has_key:
            for (const owl::PropertyExpression& property : axiom.properties) {
                if (!is_data_property(property)) continue;
                ids.push_back(data_property_of(property));
                shared_.push_back(ids.back());
            }
            break;
        case AxiomKind::rule:
            return collect_rule_data(*axiom.rule);
        default:
            return;
    }
    if (std::ranges::count(ids, static_cast<int>(Property::top)) > 0) {
        throw CannotGround{
            "owl:topDataProperty has all literals there are, which is of use in restrictions and as the "
            "property above all others only; use a data property of your own"};
    }
}

void Grounder::collect_rule_data(const owl::Rule& rule) {
    std::map<Iri, std::vector<int>> properties_of;  // by variable
    for (const auto* side : {&rule.body, &rule.head}) {
        for (const RuleAtom& atom : *side) {
            if (atom.kind != RuleAtom::Kind::data_property) continue;
            const int property = data_property_of(atom.property);
            if (property == Property::top)
                throw CannotGround{"owl:topDataProperty has all literals there are; use a data property of your own"};
            const RuleTerm& value = atom.arguments.at(1);
            if (value.kind == RuleTerm::Kind::literal) mention(property, value.literal);
            if (value.kind == RuleTerm::Kind::variable && property >= 0) properties_of[value.iri].push_back(property);
        }
    }
    for (const auto& [variable, ids] : properties_of) {
        join(ids);
        shared_.push_back(ids.front());
    }
    for (const auto* side : {&rule.body, &rule.head}) {
        for (const RuleAtom& atom : *side) {
            if (atom.kind != RuleAtom::Kind::of_data_range) continue;
            const RuleTerm& value = atom.arguments.at(0);
            const auto found = properties_of.find(value.iri);
            const bool is_variable = value.kind == RuleTerm::Kind::variable && found != properties_of.end();
            mention(is_variable ? found->second.front() : Property::top, range_id(atom.range), 0);
        }
    }
}

void Grounder::choose_values() {
    for (std::size_t i = 0; i < needs_.size(); ++i) {
        auto& group = groups_[root_of(needs_[i].property)];
        if (group == nullptr) group = std::make_unique<DataGroup>(definitions_);
        if (group->axiom == nullptr) group->axiom = need_axioms_[i];
        group->cells.mention(*ranges_[static_cast<std::size_t>(needs_[i].range)]);
        group->needs.push_back(needs_[i]);
    }
    for (int property = 0; property < static_cast<int>(data_properties.size()); ++property) {
        auto& group = groups_[root_of(property)];
        if (group == nullptr) group = std::make_unique<DataGroup>(definitions_);
        group->cells.mention(*ranges_[static_cast<std::size_t>(all_literals_)]);
    }
    for (const int property : shared_)
        if (property >= 0) group_of(property).is_shared = true;
    for (auto& [root, group] : groups_) {
        axiom_ = group->axiom;
        group->cells.cut();
        const auto& cells = group->cells.cells();
        std::vector<std::map<int, std::uint64_t>> wanted(cells.size());  // by property
        for (const auto& [property, range, count] : group->needs) {
            if (count == 0) continue;
            const std::vector<bool> inside = group->cells.inside(*ranges_[static_cast<std::size_t>(range)]);
            for (std::size_t cell = 0; cell < cells.size(); ++cell)
                if (inside[cell]) wanted[cell][property] = std::max(wanted[cell][property], count);
        }
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            std::uint64_t enough = cells[cell].value ? 1 : 0;
            for (const auto& [property, count] : wanted[cell]) enough = saturating_sum(enough, count);
            if (group->is_shared) enough = saturating_product(enough, static_cast<std::uint64_t>(count_));
            enough = std::min(enough, cells[cell].capacity);
            group->first_value.push_back(group->values.size());
            if (enough > max_values || group->values.size() + enough > max_values) {
                throw CannotGround{
                    "more than " + std::to_string(max_values) +
                    " literals would have to be told apart; use smaller cardinalities or fewer thresholds"};
            }
            group->values.insert(group->values.end(), enough, cell);
        }
    }
}

}  // namespace partonomy::knowledge::closed
