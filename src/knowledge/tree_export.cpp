#include <map>
#include <nlohmann/json.hpp>

#include "knowledge/tree_words.h"

// The tree as files. Beside what the nodes hold, each shows its features as in paper Fig. 8: *told* by an answer on the
// way from the root, *inferred* because one value is left, *ruled out*. Where several ways lead to a node, the first
// one counts.

namespace partonomy::knowledge {
namespace {

using Json = nlohmann::ordered_json;

/// Counts that a double can hold are numbers, larger ones words.
Json to_number(const std::string& digits) {
    if (digits.size() <= 15) return std::stoull(digits);
    return digits;
}

const char* kind_word(VariableKind kind) {
    switch (kind) {
        case VariableKind::range:
            return "range";
        case VariableKind::number:
            return "number";
        case VariableKind::relation:
            return "relation";
        case VariableKind::open:
            return "open";
        case VariableKind::primitive:
            return "primitive";
        default:
            return "parts";
    }
}

/// The nodes, one a line. Written word by word: a tree has hundreds of nodes and few different words, and building a
/// JSON value of them all takes longer than everything else from the ontology to the file.
std::string nodes_as_json(const DecisionTree& tree, const Domain& domain) {
    const Space& space = *tree.space;
    const auto quoted = [](const std::string& words) { return Json(words).dump(); };
    std::vector<std::string> concepts;
    for (const Concept& each : space.concepts) concepts.push_back(quoted(owl::local_name(each.iri)));
    std::map<Question, std::string> values;
    const auto list = [](const auto& items, const auto& word_of) {
        std::string text = "[";
        for (const auto& item : items) text.append(text.size() > 1 ? ", " : "").append(word_of(item));
        return text.append("]");
    };
    const auto value_word = [&](Question value) -> const std::string& {
        std::string& word = values[value];
        if (word.empty()) word = quoted(value_words(space, value));
        return word;
    };
    const auto concept_word = [&](ConceptId id) -> const std::string& { return concepts[id]; };
    const auto id_or_null = [](int id) { return id < 0 ? std::string("null") : std::to_string(id); };
    const std::vector<NodeFeatures> features = follow(tree);
    std::string text;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        text.append(i > 0 ? "," : "").append("\n  {\"id\": ").append(std::to_string(i));
        text.append(", \"configurations\": ").append(to_number(node.configurations.count_text()).dump());
        text.append(", \"segmented\": ").append(node.segmented ? "true" : "false");
        if (node.question) {
            text.append(", \"question\": {\"text\": ").append(quoted(question_words(space, node, domain)));
            text.append(", \"variable\": ").append(std::to_string(node.question->variable));
            text.append(", \"value\": ").append(std::to_string(node.question->value));
            text.append("}, \"yes\": ").append(id_or_null(node.yes)).append(", \"no\": ").append(id_or_null(node.no));
            if (node.is_open) text.append(", \"open\": true");
        }
        text.append(", \"told\": ").append(list(features[i].told, value_word));
        text.append(", \"inferred\": ").append(list(features[i].inferred, value_word));
        text.append(", \"ruled_out\": ").append(list(features[i].ruled_out, value_word));
        text.append(", \"asserted\": ").append(list(node.asserted, concept_word));
        text.append(", \"excluded\": ").append(list(node.excluded, concept_word)).append("}");
    }
    return text;
}

}  // namespace

std::string to_json(const DecisionTree& tree, const Domain& domain) {
    const Space& space = *tree.space;
    Json json;
    json["format"] = "partonomy decision tree 1";
    json["ontology"] = domain.ontology.iri;
    json["layer"] = space.concepts.empty() ? 1 : domain.layer(space.concepts.front().iri);
    json["product"] = to_number(space.product_text());
    json["configurations"] = to_number(space.all().count_text());
    json["possible"] = to_number(space.possible.count_text());
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
                                    {"configurations", to_number(each.where.count_text())}});
    std::string text = json.dump(1);
    text.resize(text.size() - 2);  // the closing bracket: nodes come last
    return text + ",\n \"nodes\": [" + nodes_as_json(tree, domain) + "\n ]\n}\n";
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
    const std::vector<NodeFeatures> features = follow(tree);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        const std::string count = node.configurations.count_text();
        const std::string asserted = join(node.asserted, concept_name);
        dot += "  n" + std::to_string(i) + " [fillcolor=\"" + (node.question ? "#fff3c4" : "#e3f1e1") + "\"" +
               (node.is_open ? ", style=\"rounded,filled,dashed\"" : "") + ", label=<<b>" +
               escaped(node_title(tree, i, domain)) + "</b><br/>" + count +
               (count == "1" ? " configuration" : " configurations") +
               row(join(features[i].told, value_name), "#c05a00") +
               row(join(features[i].inferred, value_name), "#1f5fbf");
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
