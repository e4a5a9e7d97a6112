/* How patterns, lengths and constants cut the infinitely many strings into cells.

   Every language is a part of one automaton: each character class written in a pattern is a position (Glushkov 1961),
   and a length is a chain of "any character". Reading a string from all begin positions at once leads to a set of
   positions, which tells for every language whether the string is in it (the subset construction, all languages
   together). The sets that are reached form a finite graph; strings that end in sets with the same answers are one
   cell. A set that lies behind a cycle of the graph is reached by infinitely many strings, the others by as many as
   there are paths to them, counted with the number of characters on each step.

   Characters matter only by which classes contain them, so the alphabet is cut first; the graph has one edge for each
   piece. Cost: states × pieces × positions in a state; more than `max_states` states is refused (patterns such as
   [ab]*a[ab]{20} need 2^20). */

#include "knowledge/text_languages.h"

#include <algorithm>
#include <map>

#include "knowledge/data_value.h"

namespace partonomy::knowledge::closed {
namespace {

constexpr std::size_t max_states = 50'000;
constexpr std::size_t max_positions = 5'000;

/// What XML allows in a document, hence in a string.
const Characters& xml_characters() {
    static const Characters all{{0x9, 0xA}, {0xD, 0xD}, {0x20, 0xD7FF}, {0xE000, 0xFFFD}, {0x10000, 0x10FFFF}};
    return all;
}

/// The characters of XML cut into pieces that no class separates: of each a character, and how many it has.
std::vector<std::pair<char32_t, std::uint64_t>> pieces_of(const std::vector<Characters>& classes) {
    std::vector<char32_t> cuts;
    for (const auto& [first, last] : xml_characters()) cuts.insert(cuts.end(), {first, last + 1});
    for (const Characters& each : classes)
        for (const auto& [first, last] : each) cuts.insert(cuts.end(), {first, last + 1});
    std::ranges::sort(cuts);
    cuts.erase(std::ranges::unique(cuts).begin(), cuts.end());
    std::vector<std::pair<char32_t, std::uint64_t>> pieces;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const bool is_xml = std::ranges::any_of(
            xml_characters(), [&](const auto& range) { return range.first <= cuts[i] && cuts[i] <= range.second; });
        if (is_xml) pieces.emplace_back(cuts[i], cuts[i + 1] - cuts[i]);
    }
    return pieces;
}

bool has(const Characters& characters, char32_t c) {
    return std::ranges::any_of(characters, [&](const auto& range) { return range.first <= c && c <= range.second; });
}

void join(std::vector<int>& into, const std::vector<int>& more) {
    into.insert(into.end(), more.begin(), more.end());
    std::ranges::sort(into);
    into.erase(std::ranges::unique(into).begin(), into.end());
}

/// The graph of position sets: all states, each with its answers, and edges with the number of characters on them.
struct Graph {
    std::vector<std::vector<bool>> inside;
    std::vector<std::map<int, std::uint64_t>> edges;
};

/// How many strings lead from state 0 to each state.
std::vector<std::uint64_t> strings_to(const Graph& graph) {
    std::vector<std::size_t> incoming(graph.edges.size(), 0);
    for (const auto& edges : graph.edges)
        for (const auto& [to, count] : edges) ++incoming[static_cast<std::size_t>(to)];
    std::vector<std::uint64_t> strings(graph.edges.size(), 0);
    std::vector<bool> is_done(graph.edges.size(), false);
    strings[0] = 1;
    std::vector<std::size_t> ready;
    if (incoming[0] == 0) ready.push_back(0);
    while (!ready.empty()) {
        const std::size_t state = ready.back();
        ready.pop_back();
        is_done[state] = true;
        for (const auto& [target, count] : graph.edges[state]) {
            const auto to = static_cast<std::size_t>(target);
            strings[to] = saturating_sum(strings[to], saturating_product(strings[state], count));
            if (--incoming[to] == 0) ready.push_back(to);
        }
    }
    for (std::size_t state = 0; state < strings.size(); ++state)  // on a cycle, or behind one
        if (!is_done[state]) strings[state] = uncountable;
    return strings;
}

}  // namespace

std::uint64_t saturating_sum(std::uint64_t a, std::uint64_t b) { return a > uncountable - b ? uncountable : a + b; }

std::uint64_t saturating_product(std::uint64_t a, std::uint64_t b) {
    return a != 0 && b > uncountable / a ? uncountable : a * b;
}

Characters complement(Characters some) {
    std::ranges::sort(some);
    Characters result;
    for (const auto& [first, last] : xml_characters()) {
        char32_t next = first;
        for (const auto& [from, to] : some) {
            if (from > last || to < next) continue;
            if (from > next) result.emplace_back(next, from - 1);
            next = to + 1;
        }
        if (next <= last) result.emplace_back(next, last);
    }
    return result;
}

std::u32string code_points(const std::string& text) {
    std::u32string result;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80         ? 1
                                   : (lead >> 5) == 6  ? 2
                                   : (lead >> 4) == 14 ? 3
                                   : (lead >> 3) == 30 ? 4
                                                       : 0;
        char32_t point = length == 1 ? lead : length == 0 ? 0xFFFD : lead & (0x7FU >> length);
        std::size_t read = 1;
        for (; read < length && i + read < text.size() && (static_cast<unsigned char>(text[i + read]) >> 6) == 2;
             ++read)
            point = (point << 6) | (static_cast<unsigned char>(text[i + read]) & 0x3FU);
        if (read < length) point = 0xFFFD;
        result.push_back(point);
        i += read;
    }
    return result;
}

int TextLanguages::add_position(const Characters& characters) {
    if (positions_.size() >= max_positions) {
        throw CannotGround{"patterns and lengths of strings have more than " + std::to_string(max_positions) +
                           " characters when written out; use shorter ones"};
    }
    positions_.push_back(characters);
    follow_.emplace_back();
    return static_cast<int>(positions_.size()) - 1;
}

TextLanguages::Part TextLanguages::one_of(const Characters& characters) {
    const int position = add_position(characters);
    return {{position}, {position}, false};
}

TextLanguages::Part TextLanguages::sequence(const Part& a, const Part& b) {
    for (const int end : a.last) join(follow_[static_cast<std::size_t>(end)], b.first);
    Part result{a.first, b.last, a.nullable && b.nullable};
    if (a.nullable) join(result.first, b.first);
    if (b.nullable) join(result.last, a.last);
    return result;
}

TextLanguages::Part TextLanguages::either(const Part& a, const Part& b) const {
    Part result = a;
    join(result.first, b.first);
    join(result.last, b.last);
    result.nullable = a.nullable || b.nullable;
    return result;
}

TextLanguages::Part TextLanguages::repeated(const Part& a) {
    for (const int end : a.last) join(follow_[static_cast<std::size_t>(end)], a.first);
    return {a.first, a.last, true};
}

std::size_t TextLanguages::add_language(const Part& part) {
    languages_.push_back(part);
    return languages_.size() - 1;
}

std::size_t TextLanguages::add_pattern(const std::string& pattern) {
    return add_language(PatternParser(*this, pattern).parse());
}

std::size_t TextLanguages::add_length(std::uint64_t least, std::uint64_t most) {
    if (least > most) return add_language({{}, {}, false});
    const std::uint64_t chain = most == uncountable ? std::max<std::uint64_t>(least, 1) : most;
    if (chain > max_positions) {
        throw CannotGround{"a string length of " + std::to_string(chain) + " is more than the " +
                           std::to_string(max_positions) + " that are supported; use a smaller one"};
    }
    Part part{{}, {}, least == 0};
    for (std::uint64_t i = 1; i <= chain; ++i) {
        const int position = add_position(xml_characters());
        if (i == 1) part.first = {position};
        if (i > 1) follow_[static_cast<std::size_t>(position) - 1] = {position};
        if (i >= least) part.last.push_back(position);
        if (i == chain && most == uncountable) follow_[static_cast<std::size_t>(position)] = {position};
    }
    return add_language(part);
}

std::vector<int> TextLanguages::begin() const {
    std::vector<int> result;
    for (const Part& language : languages_) join(result, language.first);
    return result;
}

std::vector<int> TextLanguages::after(const std::vector<int>& positions) const {
    std::vector<int> result;
    for (const int position : positions) {
        const auto& next = follow_[static_cast<std::size_t>(position)];
        result.insert(result.end(), next.begin(), next.end());
    }
    std::ranges::sort(result);
    result.erase(std::ranges::unique(result).begin(), result.end());
    return result;
}

std::vector<bool> TextLanguages::ends_at(const std::vector<int>& positions) const {
    std::vector<bool> result;
    for (const Part& language : languages_) {
        result.push_back(std::ranges::any_of(
            language.last, [&](int position) { return std::ranges::binary_search(positions, position); }));
    }
    return result;
}

std::vector<bool> TextLanguages::has_empty() const {
    std::vector<bool> result;
    for (const Part& language : languages_) result.push_back(language.nullable);
    return result;
}

std::vector<bool> TextLanguages::inside(const std::string& text) const {
    const std::u32string points = code_points(text);
    if (points.empty()) return has_empty();
    std::vector<int> reached, next = begin();
    for (const char32_t c : points) {
        reached.clear();
        for (const int position : next)
            if (has(positions_[static_cast<std::size_t>(position)], c)) reached.push_back(position);
        next = after(reached);
    }
    return ends_at(reached);
}

std::vector<TextLanguages::Cell> TextLanguages::cut() const {
    const auto pieces = pieces_of(positions_);
    std::vector<std::vector<bool>> reads(pieces.size(), std::vector<bool>(positions_.size()));
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t position = 0; position < positions_.size(); ++position)
            reads[i][position] = has(positions_[position], pieces[i].first);

    // State 0 is the begin, the only one that the empty string reaches; no set of positions stands for it.
    Graph graph{{has_empty()}, {{}}};
    std::map<std::vector<int>, int> ids;
    std::vector<const std::vector<int>*> states{nullptr};
    const auto state_of = [&](const std::vector<int>& positions) {
        const auto [found, is_new] = ids.try_emplace(positions, static_cast<int>(states.size()));
        if (is_new) {
            if (states.size() >= max_states) {
                throw CannotGround{"patterns of strings cut the strings in too many ways (" +
                                   std::to_string(max_states) + " states); use simpler patterns"};
            }
            states.push_back(&found->first);
            graph.edges.emplace_back();
            graph.inside.push_back(ends_at(positions));
        }
        return found->second;
    };
    for (std::size_t state = 0; state < states.size(); ++state) {
        const std::vector<int> next = state == 0 ? begin() : after(*states[state]);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            std::vector<int> reached;
            for (const int position : next)
                if (reads[i][static_cast<std::size_t>(position)]) reached.push_back(position);
            const int to = state_of(reached);
            auto& count = graph.edges[state][to];
            count = saturating_sum(count, pieces[i].second);
        }
    }

    const std::vector<std::uint64_t> strings = strings_to(graph);
    std::vector<Cell> cells;
    std::map<std::vector<bool>, std::size_t> cell_of;
    for (std::size_t state = 0; state < states.size(); ++state) {
        const auto [found, is_new] = cell_of.try_emplace(graph.inside[state], cells.size());
        if (is_new) cells.push_back({graph.inside[state], 0});
        cells[found->second].capacity = saturating_sum(cells[found->second].capacity, strings[state]);
    }
    return cells;
}

}  // namespace partonomy::knowledge::closed
