#include <array>

#include "base/json_text.h"
#include "knowledge/tree_words.h"

// The tree as files. Beside what the nodes hold, each shows its features as in paper Fig. 8: *told* by an answer on the
// way from the root, *inferred* because one value is left, *ruled out*. Where several ways lead to a node, the first
// one counts.

namespace partonomy::knowledge {
namespace {

/// Counts that a double can hold are numbers, larger ones words.
std::string count_as_json(const std::string& digits) { return digits.size() <= 15 ? digits : quoted_json(digits); }

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

/// The nodes, one a line. A tree has hundreds of nodes and few different words: each word is made once.
void write_nodes(JsonText& json, const DecisionTree& tree, const Domain& domain) {
    const Space& space = *tree.space;
    std::vector<std::string> concepts;
    for (const Concept& each : space.concepts) concepts.push_back(quoted_json(owl::local_name(each.iri)));
    std::vector<std::vector<std::string>> values(space.variables.size());
    std::vector<std::vector<std::array<std::string, 2>>> questions(values.size());  // before and after segmentation
    for (std::size_t v = 0; v < values.size(); ++v) {
        questions[v].resize(space.variables[v].values.size());
        for (std::size_t k = 0; k < space.variables[v].values.size(); ++k)
            values[v].push_back(quoted_json(value_words(space, {static_cast<VariableId>(v), static_cast<ValueId>(k)})));
    }
    const auto list_values = [&](const char* key, const std::vector<Question>& list) {
        json.array(key);
        for (const Question value : list)
            json.raw_item(values[static_cast<std::size_t>(value.variable)][static_cast<std::size_t>(value.value)]);
        json.end();
    };
    const auto list_concepts = [&](const char* key, const std::vector<ConceptId>& list) {
        json.array(key);
        for (const ConceptId id : list) json.raw_item(concepts[static_cast<std::size_t>(id)]);
        json.end();
    };
    const auto id_or_null = [&](const char* key, int id) { id < 0 ? json.member(key, nullptr) : json.member(key, id); };
    const std::vector<NodeFeatures> features = follow(tree);
    json.array("nodes");
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        json.object_in_line().member("id", i);
        json.raw_member("configurations", count_as_json(node.configurations.count_text()));
        json.member("segmented", node.segmented);
        if (node.question) {
            const auto [variable, value] = *node.question;
            std::string& words =
                questions[static_cast<std::size_t>(variable)][static_cast<std::size_t>(value)][node.segmented ? 1 : 0];
            if (words.empty()) words = quoted_json(question_words(space, node, domain));
            json.object("question").raw_member("text", words).member("variable", variable).member("value", value);
            json.end();
            id_or_null("yes", node.yes);
            id_or_null("no", node.no);
            if (node.is_open) json.member("open", true);
        }
        list_values("told", features[i].told);
        list_values("inferred", features[i].inferred);
        list_values("ruled_out", features[i].ruled_out);
        list_concepts("asserted", node.asserted);
        list_concepts("excluded", node.excluded);
        json.end();
    }
    json.end();
}

}  // namespace

std::string to_json(const DecisionTree& tree, const Domain& domain) {
    const Space& space = *tree.space;
    JsonText json(1);
    json.object().member("format", "partonomy decision tree 1").member("ontology", domain.ontology.iri);
    json.member("layer", space.concepts.empty() ? 1 : domain.layer(space.concepts.front().iri));
    json.raw_member("product", count_as_json(space.product_text()));
    json.raw_member("configurations", count_as_json(space.all().count_text()));
    json.raw_member("possible", count_as_json(space.possible.count_text()));
    json.member("depth", tree.depth()).array("variables");
    for (const Variable& variable : space.variables)
        json.object()
            .member("name", variable_name(variable))
            .member("kind", kind_word(variable.kind))
            .member("values", variable.values)
            .end();
    json.end().array("concepts");
    for (const Concept& each : space.concepts)
        json.object()
            .member("name", owl::local_name(each.iri))
            .member("iri", each.iri)
            .member("incompatible", each.incompatible)
            .member("provable", each.provable)
            .raw_member("configurations", count_as_json(each.where.count_text()))
            .end();
    json.end();
    write_nodes(json, tree, domain);
    return json.end().text() + "\n";
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
