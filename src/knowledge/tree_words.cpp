#include "knowledge/tree_words.h"

#include <algorithm>
#include <charconv>

#include "base/spelling.h"

namespace partonomy::knowledge {
namespace {

std::string part_words(const Variable& variable) {
    const std::string name = to_manchester(*variable.part_class);
    const bool simple = variable.part_class->kind == owl::ClassKind::named;
    return std::to_string(variable.threshold) + " " + (simple ? name : "(" + name + ")");
}

/// "a Seat", "a Block or Disc", "a Stick" for hasShape some Stick; empty for what is more involved.
std::string whom_words(const owl::ClassExpression& part) {
    if (part.kind == owl::ClassKind::named) return with_article(owl::local_name(part.iri));
    if (part.kind == owl::ClassKind::some_values_from && !part.property.inverse &&
        part.operands[0]->kind == owl::ClassKind::named && owl::local_name(part.property.iri).starts_with("has"))
        return whom_words(*part.operands[0]);
    if (part.kind != owl::ClassKind::union_of) return {};
    std::string words;
    for (const owl::ClassPointer& each : part.operands) {
        const std::string one = whom_words(*each);
        if (one.empty() || each->kind == owl::ClassKind::union_of) return {};
        words += words.empty() ? one : " or " + one.substr(one.find(' ') + 1);
    }
    return words;
}

/// The wording of the relation, and of who is on the other side; each empty where it takes more than a few words.
struct RelationWords {
    std::string question, whom;
};

RelationWords words_of_relation(const Variable& variable, const Domain& domain) {
    const owl::ClassExpression& whole = *variable.part_class;
    RelationWords words;
    const bool of_target = domain.relational[static_cast<std::size_t>(variable.index)].of_target;
    const bool is_counted = of_target && whole.kind == owl::ClassKind::min_cardinality;
    if ((whole.kind != owl::ClassKind::some_values_from && !is_counted) ||
        whole.operands[0]->kind != owl::ClassKind::intersection_of || whole.operands[0]->operands.size() != 2)
        return words;
    for (const owl::ClassPointer& each : whole.operands[0]->operands) {
        const owl::ClassExpression& operand = *each;
        const bool is_other_side = of_target || owl::local_name(operand.property.iri) == "isTargetRegion";
        if (operand.kind == owl::ClassKind::some_values_from && is_other_side)
            words.whom = whom_words(*operand.operands[0]);
        for (const Relation& relation : domain.relations)
            if (operand.kind == owl::ClassKind::named && operand.iri == relation.iri &&
                (!is_counted || relation.arity == 2))
                words.question = relation.question;
    }
    if (is_counted && !words.whom.empty())
        words.whom = "at least " + std::to_string(whole.number) + words.whom.substr(words.whom.find(' '));
    return words;
}

/// "is a Seat above it", from "is it above"; where the wording speaks of no "it", "… this (asked of a Seat)".
std::string asked_of(const std::string& whom, const std::string& question) {
    constexpr const char* it = " it ";
    const std::size_t place = question.find(it);
    if (place == std::string::npos) return question + " this (asked of " + whom + ")";
    return question.substr(0, place + 1) + whom + question.substr(place + 3) + " it";
}

/// "is it above a Seat", "does it touch at least 2 Rail", or, of the region as a reference, "is a Seat above it", where
/// the relation has a wording and the other side is named in a few words; else the expression as written.
std::string relation_words(const Variable& variable, const Domain& domain) {
    const auto [question, whom] = words_of_relation(variable, domain);
    if (question.empty() || whom.empty()) return "is it so: " + to_manchester(*variable.part_class);
    const bool of_target = domain.relational[static_cast<std::size_t>(variable.index)].of_target;
    return of_target ? question + " " + whom : asked_of(whom, question);
}

}  // namespace

std::string other_side_in_words(const Variable& variable, const Domain& domain) {
    if (variable.part_class->kind != owl::ClassKind::some_values_from) return {};
    return words_of_relation(variable, domain).whom;
}

std::vector<NodeFeatures> follow(const DecisionTree& tree) {
    const Space& space = *tree.space;
    std::vector<std::vector<char>> asked(tree.nodes.size());  // [node][variable]: 1 a yes, 2 a number was compared
    std::vector<NodeFeatures> features(tree.nodes.size());
    std::vector<std::size_t> parent(tree.nodes.size(), 0);  // the first; the root is its own
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {   // a node's first parent comes before it
        const TreeNode& node = tree.nodes[i];
        if (asked[i].empty()) asked[i].assign(space.variables.size(), 0);
        // What a parent rules out stays ruled out. A variable has one value: the last that is possible holds.
        auto excluded_above = features[parent[i]].ruled_out;
        excluded_above.push_back({static_cast<VariableId>(space.variables.size()), 0});
        auto next = excluded_above.begin();
        for (std::size_t v = 0; v < space.variables.size(); ++v) {
            std::size_t possible = 0;
            Question last{static_cast<VariableId>(v), 0};
            for (std::size_t k = 0; k < space.variables[v].values.size(); ++k) {
                const Question value{static_cast<VariableId>(v), static_cast<ValueId>(k)};
                if (*next == value) {
                    ++next;
                    features[i].ruled_out.push_back(value);
                } else if (!node.configurations.intersects(space.holds[v][k])) {
                    features[i].ruled_out.push_back(value);
                } else {
                    ++possible;
                    last = value;
                }
            }
            if (possible == 1) (asked[i][v] ? features[i].told : features[i].inferred).push_back(last);
        }
        if (!node.question) continue;
        const std::size_t variable = node.question->variable;
        for (const bool yes : {true, false}) {
            const int child = yes ? node.yes : node.no;
            if (child < 0 || !asked[child].empty()) continue;
            asked[child] = asked[i];
            parent[child] = i;
            const VariableKind kind = space.variables[variable].kind;
            if (yes || kind != VariableKind::range) asked[child][variable] = 1;
        }
    }
    return features;
}

std::string variable_name(const Variable& variable) {
    if (variable.kind == VariableKind::relation || variable.kind == VariableKind::open)
        return to_manchester(*variable.part_class);
    return variable.kind == VariableKind::parts ? "at least " + part_words(variable) : owl::local_name(variable.iri);
}

std::string value_words(const Space& space, Question value) {
    const Variable& variable = space.variables[value.variable];
    const std::string& word = variable.values[value.value];
    switch (variable.kind) {
        case VariableKind::number:
            return owl::local_name(variable.iri) + " " + word;
        case VariableKind::range:
            return word == "other" ? "other " + owl::local_name(variable.iri) : word;
        default:
            return (value.value == 0 ? "" : "not ") + variable_name(variable);
    }
}

std::string question_words(const Space& space, const TreeNode& node, const Domain& domain) {
    if (node.segmented) return to_text(space, *node.question, domain);
    return "find all " + value_words(space, *node.question);
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
    return result;
}

std::string node_title(const DecisionTree& tree, std::size_t node, const Domain& domain) {
    const TreeNode& shown = tree.nodes[node];
    if (shown.question) return question_words(*tree.space, shown, domain) + "?";
    std::string names;
    for (const ConceptId id : shown.asserted)
        names += (names.empty() ? "" : ", ") + owl::local_name(tree.space->concepts[id].iri);
    return names.empty() ? "nothing named" : names;
}

std::string to_text(const Space& space, Question question, const Domain& domain) {
    const Variable& variable = space.variables[question.variable];
    if (variable.kind == VariableKind::number) {
        const MeasuredProperty::Interval& interval = domain.numbers[variable.index].intervals[question.value];
        char buffer[32];
        const std::string high(buffer, std::to_chars(buffer, buffer + sizeof buffer, interval.high).ptr);
        return owl::local_name(variable.iri) + (interval.high_closed ? " <= " : " < ") + high;
    }
    if (variable.kind == VariableKind::range) {
        const RangeConcept& range = domain.ranges[variable.index];
        if (static_cast<std::size_t>(question.value) >= range.values.size())
            return "has it another " + owl::local_name(range.iri);
        const ElementaryConcept& value = range.values[question.value];
        if (!value.question.empty()) return value.question;
    }
    if (variable.kind == VariableKind::relation) return relation_words(variable, domain);
    if (variable.kind == VariableKind::open) return "is it so: " + to_manchester(*variable.part_class);
    if (variable.kind == VariableKind::parts) return "has it at least " + part_words(variable);
    const std::string name =
        variable.kind == VariableKind::range ? variable.values[question.value] : owl::local_name(variable.iri);
    const bool vowel = !name.empty() && std::string("aeiouAEIOU").find(name[0]) != std::string::npos;
    return "is it " + std::string(vowel ? "an " : "a ") + name;
}

}  // namespace partonomy::knowledge
