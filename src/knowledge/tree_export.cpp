#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "knowledge/decision_tree.h"

// The tree as files. Beside what the nodes hold, each shows its features as in paper Fig. 8: *told* by an answer on the
// way from the root, *inferred* because one value is left, *ruled out*. Where several ways lead to a node, the first
// one counts.

namespace partonomy::knowledge {
namespace {

using Json = nlohmann::ordered_json;

struct Features {
    std::vector<Question> told, inferred, ruled_out;
};

std::vector<Features> follow(const DecisionTree& tree) {
    const Space& space = *tree.space;
    std::vector<std::vector<char>> asked(tree.nodes.size());  // [node][variable]: 1 a yes, 2 a number was compared
    std::vector<Features> features(tree.nodes.size());
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {  // a node's first parent comes before it
        const TreeNode& node = tree.nodes[i];
        if (asked[i].empty()) asked[i].assign(space.variables.size(), 0);
        for (std::size_t v = 0; v < space.variables.size(); ++v)
            for (std::size_t k = 0; k < space.variables[v].values.size(); ++k) {
                const Question value{static_cast<VariableId>(v), static_cast<ValueId>(k)};
                const bool all = node.configurations.is_subset_of(space.holds[v][k]);
                if (!node.configurations.intersects(space.holds[v][k]))
                    features[i].ruled_out.push_back(value);
                else if (all)
                    (asked[i][v] ? features[i].told : features[i].inferred).push_back(value);
            }
        if (!node.question) continue;
        const std::size_t variable = node.question->variable;
        for (const bool yes : {true, false}) {
            const int child = yes ? node.yes : node.no;
            if (child < 0 || !asked[child].empty()) continue;
            asked[child] = asked[i];
            const VariableKind kind = space.variables[variable].kind;
            if (yes || kind != VariableKind::range) asked[child][variable] = 1;
        }
    }
    return features;
}

std::string part_words(const Variable& variable) {
    const std::string name = to_manchester(*variable.part_class);
    const bool simple = variable.part_class->kind == owl::ClassKind::named;
    return std::to_string(variable.threshold) + " " + (simple ? name : "(" + name + ")");
}

std::string variable_name(const Variable& variable) {
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

template <typename Range, typename Words>
std::string join(const Range& range, const Words& words) {
    std::string list;
    for (const auto& each : range) list += (list.empty() ? "" : ", ") + words(each);
    return list;
}

const char* kind_word(VariableKind kind) {
    switch (kind) {
        case VariableKind::range:
            return "range";
        case VariableKind::number:
            return "number";
        case VariableKind::primitive:
            return "primitive";
        default:
            return "parts";
    }
}

}  // namespace

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
    if (variable.kind == VariableKind::parts) return "has it at least " + part_words(variable);
    const std::string name =
        variable.kind == VariableKind::range ? variable.values[question.value] : owl::local_name(variable.iri);
    const bool vowel = !name.empty() && std::string("aeiouAEIOU").find(name[0]) != std::string::npos;
    return "is it " + std::string(vowel ? "an " : "a ") + name;
}

std::string to_json(const DecisionTree& tree, const Domain& domain) {
    const Space& space = *tree.space;
    const auto concept_name = [&](ConceptId id) { return owl::local_name(space.concepts[id].iri); };
    Json json;
    json["format"] = "partonomy decision tree 1";
    json["ontology"] = domain.ontology.iri;
    json["layer"] = &space == &domain.objects ? 2 : 1;
    json["product"] = space.product;
    json["configurations"] = space.size;
    json["possible"] = space.possible.count();
    json["depth"] = tree.depth();
    json["variables"] = Json::array();
    for (const Variable& variable : space.variables)
        json["variables"].push_back(
            {{"name", variable_name(variable)}, {"kind", kind_word(variable.kind)}, {"values", variable.values}});
    json["concepts"] = Json::array();
    for (const Concept& each : space.concepts)
        json["concepts"].push_back({{"name", owl::local_name(each.iri)},
                                    {"iri", each.iri},
                                    {"incompatible", each.incompatible},
                                    {"provable", each.provable},
                                    {"configurations", each.where.count()}});
    json["nodes"] = Json::array();
    const std::vector<Features> features = follow(tree);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        const auto words = [&](const std::vector<Question>& values) {
            Json list = Json::array();
            for (const Question value : values) list.push_back(value_words(space, value));
            return list;
        };
        const auto names = [&](const std::vector<ConceptId>& ids) {
            Json list = Json::array();
            for (const ConceptId id : ids) list.push_back(concept_name(id));
            return list;
        };
        Json entry{{"id", i}, {"configurations", node.configurations.count()}, {"segmented", node.segmented}};
        if (node.question) {
            entry["question"] = {{"text", question_words(space, node, domain)},
                                 {"variable", node.question->variable},
                                 {"value", node.question->value}};
            entry["yes"] = node.yes;
            entry["no"] = node.no < 0 ? Json(nullptr) : Json(node.no);
        }
        entry["told"] = words(features[i].told);
        entry["inferred"] = words(features[i].inferred);
        entry["ruled_out"] = words(features[i].ruled_out);
        entry["asserted"] = names(node.asserted);
        entry["excluded"] = names(node.excluded);
        json["nodes"].push_back(std::move(entry));
    }
    return json.dump(1) + "\n";
}

std::string to_dot(const DecisionTree& tree, const Domain& domain) {
    const Space& space = *tree.space;
    const auto concept_name = [&](ConceptId id) { return owl::local_name(space.concepts[id].iri); };
    const auto value_name = [&](Question value) { return value_words(space, value); };
    const auto row = [](const std::string& text, const char* color, const std::string& before = {}) {
        return text.empty() ? std::string()
                            : "<br/><font color=\"" + std::string(color) + "\">" + escaped(before + text) + "</font>";
    };
    std::string dot =
        "digraph decision_tree {\n  node [shape=box, style=\"rounded,filled\", fillcolor=white, "
        "fontname=\"Helvetica\"];\n";
    const std::vector<Features> features = follow(tree);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        const std::size_t count = node.configurations.count();
        const std::string asserted = join(node.asserted, concept_name);
        const std::string title = node.question      ? question_words(space, node, domain) + "?"
                                  : asserted.empty() ? "nothing named"
                                                     : asserted;
        dot +=
            "  n" + std::to_string(i) + " [fillcolor=\"" + (node.question ? "#fff3c4" : "#e3f1e1") + "\", label=<<b>" +
            escaped(title) + "</b><br/>" + std::to_string(count) + (count == 1 ? " configuration" : " configurations") +
            row(join(features[i].told, value_name), "#c05a00") + row(join(features[i].inferred, value_name), "#1f5fbf");
        if (node.question) dot += row(asserted, "#2e7d32", "is ");
        dot += row(join(node.excluded, concept_name), "#888888", "not ") + ">];\n";
    }
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (tree.nodes[i].yes >= 0)
            dot += "  n" + std::to_string(i) + " -> n" + std::to_string(tree.nodes[i].yes) + " [label=yes];\n";
        if (tree.nodes[i].no >= 0)
            dot += "  n" + std::to_string(i) + " -> n" + std::to_string(tree.nodes[i].no) + " [label=no];\n";
    }
    return dot + "}\n";
}

}  // namespace partonomy::knowledge
