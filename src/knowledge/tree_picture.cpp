#include <algorithm>

#include "knowledge/tree_words.h"

// The tree to look at. The picture is layered: a node lies below all nodes that lead to it, as deep as the longest way;
// within a layer, nodes stand in the order of the middle of their parents, which keeps most edges from crossing. The
// page holds the tree's JSON and unfolds it on demand, with a script of its own and nothing from elsewhere.

namespace partonomy::knowledge {
namespace {

struct Line {
    std::string text;
    const char* color;
};

struct Box {
    std::vector<Line> lines;
    std::size_t layer = 0;
    double x = 0, y = 0, width = 0, height = 0;  // of the upper left corner
};

constexpr double line_height = 15, letter = 6.3, margin = 8, gap = 24, layer_gap = 46;
constexpr std::size_t longest_line = 48;

/// Breaks a list of words into lines.
void add_lines(Box& box, const std::string& text, const char* color) {
    std::string line;
    std::size_t from = 0;
    while (from < text.size()) {
        std::size_t to = text.find(' ', from);
        to = to == std::string::npos ? text.size() : to + 1;
        if (!line.empty() && line.size() + to - from > longest_line) {
            box.lines.push_back({line, color});
            line.clear();
        }
        line += text.substr(from, to - from);
        from = to;
    }
    if (!line.empty()) box.lines.push_back({line, color});
}

std::vector<Box> boxes_of(const DecisionTree& tree, const Domain& domain) {
    const Space& space = *tree.space;
    const auto value_name = [&](Question value) { return value_words(space, value); };
    const auto concept_name = [&](ConceptId id) { return owl::local_name(space.concepts[id].iri); };
    const std::vector<NodeFeatures> features = follow(tree);
    std::vector<Box> boxes(tree.nodes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const TreeNode& node = tree.nodes[i];
        const std::string count = node.configurations.count_text();
        add_lines(boxes[i], node_title(tree, i, domain), "#222222");
        add_lines(boxes[i], count + (count == "1" ? " configuration" : " configurations"), "#777777");
        add_lines(boxes[i], join(features[i].told, value_name), "#c05a00");
        add_lines(boxes[i], join(features[i].inferred, value_name), "#1f5fbf");
        if (node.question && !node.asserted.empty())
            add_lines(boxes[i], "is " + join(node.asserted, concept_name), "#2e7d32");
        if (node.is_open) add_lines(boxes[i], "… more below", "#b00020");
        for (const Line& line : boxes[i].lines)
            boxes[i].width = std::max(boxes[i].width, static_cast<double>(line.text.size()) * letter + 2 * margin);
        boxes[i].height = static_cast<double>(boxes[i].lines.size()) * line_height + margin;
    }
    return boxes;
}

/// Places the boxes; returns the size of the picture.
std::pair<double, double> place(const DecisionTree& tree, std::vector<Box>& boxes) {
    std::vector<std::vector<std::size_t>> parents(boxes.size()), layers;
    std::vector<std::size_t> open(boxes.size(), 0), ready;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (const int child : {tree.nodes[i].yes, tree.nodes[i].no})
            if (child >= 0) parents[child].push_back(i);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if ((open[i] = parents[i].size()) == 0) ready.push_back(i);
    for (std::size_t k = 0; k < ready.size(); ++k)
        for (const int child : {tree.nodes[ready[k]].yes, tree.nodes[ready[k]].no}) {
            if (child < 0) continue;
            boxes[child].layer = std::max(boxes[child].layer, boxes[ready[k]].layer + 1);
            if (--open[child] == 0) ready.push_back(static_cast<std::size_t>(child));
        }
    for (const std::size_t i : ready) {
        if (layers.size() <= boxes[i].layer) layers.resize(boxes[i].layer + 1);
        layers[boxes[i].layer].push_back(i);
    }
    const auto middle = [&](std::size_t i) { return boxes[i].x + boxes[i].width / 2; };
    double width = 0, y = gap;
    for (auto& layer : layers) {
        std::vector<std::pair<double, std::size_t>> order;
        for (const std::size_t i : layer) {
            double sum = 0;
            for (const std::size_t parent : parents[i]) sum += middle(parent);
            order.emplace_back(parents[i].empty() ? 0 : sum / static_cast<double>(parents[i].size()), i);
        }
        std::ranges::stable_sort(order, {}, [](const auto& each) { return each.first; });
        double x = gap, height = 0;
        for (const auto& [wish, i] : order) {
            boxes[i].x = x;
            boxes[i].y = y;
            x += boxes[i].width + gap;
            height = std::max(height, boxes[i].height);
        }
        width = std::max(width, x);
        y += height + layer_gap;
    }
    for (const auto& layer : layers) {  // each in the middle
        double end = 0;
        for (const std::size_t i : layer) end = std::max(end, boxes[i].x + boxes[i].width + gap);
        for (const std::size_t i : layer) boxes[i].x += (width - end) / 2;
    }
    return {width, y};
}

std::string number(double x) { return std::to_string(static_cast<long>(x + 0.5)); }

const char* const page_head = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Decision tree</title><style>
body { font: 14px/1.4 system-ui, sans-serif; margin: 1.5em; color: #222; background: #fafafa }
.node { border: 1px solid #bbb; border-radius: 6px; background: #fff3c4; padding: .3em .7em; margin: .25em 0; display: inline-block }
.leaf { background: #e3f1e1 } .open { border-style: dashed }
.children { margin-left: 1.6em; border-left: 2px solid #ddd; padding-left: .8em }
.told { color: #c05a00 } .inferred { color: #1f5fbf } .asserted { color: #2e7d32 } .excluded, .count { color: #777 }
.answer { font-weight: bold; margin-right: .5em } .title { font-weight: bold; cursor: pointer }
button { margin-right: .5em }
</style></head><body>
<h1>Decision tree</h1><p id="about"></p>
<p><button id="more">unfold one level</button><button id="less">fold all</button></p>
<div id="tree"></div>
<script type="application/json" id="data">)";

const char* const page_tail = R"(</script><script>
const data = JSON.parse(document.getElementById("data").textContent);
document.getElementById("about").textContent = data.ontology + ": " + data.possible + " possible configurations, " +
  data.nodes.length + " nodes, depth " + data.depth;
function line(box, kind, words, before) {
  if (!words.length) return;
  const row = document.createElement("div");
  row.className = kind;
  row.textContent = (before || "") + words.join(", ");
  box.append(row);
}
function show(id, answer) {
  const node = data.nodes[id], holder = document.createElement("div"), box = document.createElement("div");
  box.className = "node" + (node.question ? "" : " leaf") + (node.open ? " open" : "");
  if (answer) {
    const word = document.createElement("span");
    word.className = "answer";
    word.textContent = answer;
    box.append(word);
  }
  const title = document.createElement("span"), below = [["yes", node.yes], ["no", node.no]].filter(e => e[1] != null);
  title.className = "title";
  const words = node.question ? node.question.text + "?" : node.asserted.join(", ") || "nothing named";
  box.append(title);
  line(box, "count", [node.configurations + " configuration" + (node.configurations == 1 ? "" : "s")]);
  line(box, "told", node.told);
  line(box, "inferred", node.inferred);
  if (node.question) line(box, "asserted", node.asserted, "is ");
  line(box, "excluded", node.excluded, "not ");
  if (node.open) line(box, "excluded", ["more below, not in this file"]);
  holder.append(box);
  let children = null;
  const sign = () => title.textContent = (below.length ? (children ? "▾ " : "▸ ") : "") + words;
  holder.unfold = () => {
    if (children || !below.length) return false;
    children = document.createElement("div");
    children.className = "children";
    for (const [word, child] of below) children.append(show(child, word));
    holder.append(children);
    sign();
    return true;
  };
  holder.fold = () => { if (children) children.remove(); children = null; sign(); };
  title.onclick = () => children ? holder.fold() : holder.unfold();
  sign();
  return holder;
}
const root = show(0);
document.getElementById("tree").append(root);
root.unfold();
document.getElementById("less").onclick = () => root.fold();
document.getElementById("more").onclick = () => {
  for (const box of [root, ...root.querySelectorAll("div")]) if (box.unfold && box.isConnected) box.unfold();
};
</script></body></html>
)";

}  // namespace

std::string to_svg(const DecisionTree& tree, const Domain& domain) {
    std::vector<Box> boxes = boxes_of(tree, domain);
    const auto [width, height] = place(tree, boxes);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width) + "\" height=\"" +
                      number(height) + "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"11\">\n" +
                      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (const bool yes : {true, false}) {
            const int child = yes ? tree.nodes[i].yes : tree.nodes[i].no;
            if (child < 0) continue;
            const Box &from = boxes[i], &to = boxes[child];
            const double x = from.x + from.width * (yes ? 0.35 : 0.65), y = from.y + from.height;
            const double end = to.x + to.width / 2, bend = (y + to.y) / 2;
            const char* color = yes ? "#2e7d32" : "#b00020";
            svg += "<path d=\"M" + number(x) + " " + number(y) + " C" + number(x) + " " + number(bend) + " " +
                   number(end) + " " + number(bend) + " " + number(end) + " " + number(to.y) +
                   "\" fill=\"none\" stroke=\"" + color + "\"/>\n<text x=\"" + number(x + (yes ? -22 : 5)) + "\" y=\"" +
                   number(y + 12) + "\" fill=\"" + color + "\">" + (yes ? "yes" : "no") + "</text>\n";
        }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Box& box = boxes[i];
        svg += "<rect x=\"" + number(box.x) + "\" y=\"" + number(box.y) + "\" width=\"" + number(box.width) +
               "\" height=\"" + number(box.height) + "\" rx=\"5\" fill=\"" +
               (tree.nodes[i].question ? "#fff3c4" : "#e3f1e1") + "\" stroke=\"#999999\"" +
               (tree.nodes[i].is_open ? " stroke-dasharray=\"5 3\"" : "") + "/>\n";
        for (std::size_t l = 0; l < box.lines.size(); ++l)
            svg += "<text x=\"" + number(box.x + margin) + "\" y=\"" +
                   number(box.y + line_height * static_cast<double>(l + 1)) + "\" fill=\"" + box.lines[l].color + "\"" +
                   (l == 0 ? " font-weight=\"bold\"" : "") + ">" + escaped(box.lines[l].text) + "</text>\n";
    }
    return svg + "</svg>\n";
}

std::string to_html(const DecisionTree& tree, const Domain& domain) {
    std::string json;
    for (const char c : to_json(tree, domain)) {  // no "</script>" within
        if (c == '<')
            json += "\\u003c";
        else if (c != '\n')
            json += c;
    }
    return page_head + json + page_tail;
}

}  // namespace partonomy::knowledge
