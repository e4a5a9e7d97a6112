/* Core holds every feature that Partonomy can measure; a domain speaks of a few. Reading the others takes longer than
   reading the domain, so who only wants to know what a domain means reads a module of core.

   Core is written in paragraphs, one for each term, and terms of one paragraph belong together: a range concept names
   its values, a property its range. What all features hang on (core:Region, core:Feature, annotation properties …)
   stands before the first of them, is always read, and binds nothing together; so do the three terms that all relations
   hang on. The groups are found by union-find, once for each run of the program; a module takes one pass over the text.
 */

#include "owl/core_module.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "owl/ontology.h"

namespace partonomy::owl {
namespace {

constexpr std::string_view first_feature = "\ncore:Shape a owl:Class";
constexpr std::array<std::string_view, 3> hubs_of_relations{"Relation", "isTargetRegion", "isReferenceRegion"};

using Terms = std::vector<std::string_view>;

/// Local names of core's terms in a text, in order.
Terms terms_of(std::string_view text) {
    constexpr std::string_view prefix = "core:";
    const auto is_in_name = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    Terms terms;
    for (std::size_t at = text.find(prefix); at != std::string_view::npos; at = text.find(prefix, at)) {
        at += prefix.size();
        const auto end = std::ranges::find_if_not(text.substr(at), is_in_name);
        terms.push_back(text.substr(at, static_cast<std::size_t>(end - text.begin()) - at));
    }
    return terms;
}

/// Paragraphs, each with the empty lines after it.
std::vector<std::string_view> paragraphs_of(std::string_view text) {
    std::vector<std::string_view> paragraphs;
    while (!text.empty()) {
        const std::size_t gap = std::min(text.find("\n\n"), text.size());
        const std::size_t end = std::min(text.find_first_not_of('\n', gap), text.size());
        paragraphs.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return paragraphs;
}

class Core {
public:
    explicit Core(std::string_view text) {
        const std::size_t start = std::min(text.find(first_feature), text.size() - 1) + 1;
        head_ = text.substr(0, start);
        std::unordered_set<std::string_view> hubs(hubs_of_relations.begin(), hubs_of_relations.end());
        for (std::size_t at = head_.find("\ncore:"); at != std::string_view::npos; at = head_.find("\ncore:", at + 1))
            hubs.insert(terms_of(head_.substr(at, head_.find(' ', at) - at)).front());
        for (const std::string_view paragraph : paragraphs_of(text.substr(start))) {
            Terms terms;
            if (paragraph.starts_with("core:")) terms = terms_of(paragraph);
            std::erase_if(terms, [&](std::string_view term) { return hubs.contains(term); });
            for (const std::string_view term : terms) unite(terms.front(), term);
            paragraphs_.push_back({paragraph, terms.empty() ? std::string_view{} : terms.front()});
        }
        Terms always = terms_of(head_);  // what core:Region itself names
        always.push_back("Connected");   // what touches: composite parts are made by it
        for (const std::string_view term : always)
            if (parents_.contains(term)) always_.insert(group(term));
    }

    [[nodiscard]] std::string module(const std::set<std::string>& names) const {
        const std::string_view prefix = core_prefix;
        std::unordered_set<std::string_view> used = always_;
        for (const std::string& name : names)
            if (const auto term = std::string_view(name).substr(prefix.size()); parents_.contains(term))
                used.insert(group(term));
        std::string result(head_);
        for (const auto& [text, term] : paragraphs_)
            if (term.empty() || used.contains(group(term)))
                result += text;
            else
                result.append(static_cast<std::size_t>(std::ranges::count(text, '\n')), '\n');
        return result;
    }

private:
    struct Paragraph {
        std::string_view text, term;  ///< one of its terms that belong to a group; empty: always read
    };

    void unite(std::string_view a, std::string_view b) {
        parents_.emplace(a, a);
        parents_.emplace(b, b);
        parents_[group(b)] = group(a);
    }
    [[nodiscard]] std::string_view group(std::string_view term) const {
        for (auto up = parents_.find(term); up->second != term; up = parents_.find(term)) term = up->second;
        return term;
    }

    std::string_view head_;  ///< up to the first feature
    std::vector<Paragraph> paragraphs_;
    std::unordered_map<std::string_view, std::string_view> parents_;
    std::unordered_set<std::string_view> always_;  ///< groups
};

}  // namespace

std::string core_module(const std::set<std::string>& names) {
    static const Core core(core_ontology_text());
    return core.module(names);
}

}  // namespace partonomy::owl
