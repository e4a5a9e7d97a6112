#pragma once

#include <map>
#include <memory>
#include <random>
#include <set>

#include "knowledge/explain.h"
#include "mini.h"

// Random ontologies of composite parts over one range concept, and what they mean by the book: groups built one after
// the other, classes evaluated straight from their definitions.

namespace composites_random {

using namespace mini;
using namespace partonomy::knowledge;

using Names = std::set<std::string>;

/// A region, a composite part or the object.
struct Individual {
    int kind = -1;          ///< of a composite part
    std::string value;      ///< of a region
    std::set<int> regions;  ///< of a composite part
    std::vector<const Individual*> parts;
    bool is_region() const { return !value.empty(); }
};

struct Random {
    Ontology ontology;
    std::vector<std::string> values{"a", "b", "c"};
    std::map<std::string, ClassPointer> definitions;
    std::map<std::string, int> kinds;  ///< of composite concepts; absent: any
    std::vector<Names> mentions;       ///< by kind
    std::vector<std::string> objects;
    std::vector<std::pair<ClassPointer, ClassPointer>> constraints;  ///< on composite parts

    void define(const std::string& n, ClassPointer c) {
        ontology.same(n, c);
        definitions[n] = std::move(c);
    }

    explicit Random(unsigned seed) {
        std::mt19937 random(seed);
        const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
        ontology.range("F", values);
        for (int i = 0; i < 3; ++i) {
            auto value = name(values[pick(3)]);
            if (pick(3) == 0) value = no(value);
            define("P" + std::to_string(i), both({name("Region"), some("hasF", value)}));
        }
        std::vector<std::string> regions{"P0", "P1", "P2"}, composites;
        Names mentioned;
        const auto count = [&](const std::string& part) -> ClassPointer {
            mentioned.insert(part);
            const auto n = static_cast<unsigned>(pick(3));
            switch (pick(5)) {
                case 0:
                    return at_least(n, name(part));
                case 1:
                    return at_most(n, name(part));
                case 2:
                    return exactly(n, name(part));
                case 3:
                    return no(some("hasPart", name(part)));
                default:
                    return some("hasPart", name(part));
            }
        };
        const auto add_kind = [&](const std::string& n) {
            // The same mentions speak of the same groups.
            for (const auto& [other, own] : own_mentions_)
                if (own == mentioned) {
                    kinds[n] = kinds[other];
                    return;
                }
            kinds[n] = static_cast<int>(mentions.size());
            mentions.push_back(mentioned);
        };
        const auto add_composite = [&](const std::string& n, const std::vector<ClassPointer>& counts) {
            std::vector<ClassPointer> all{name("CompositePart")};
            all.insert(all.end(), counts.begin(), counts.end());
            add_kind(n);
            own_mentions_[n] = mentioned;
            define(n, both(all));
            composites.push_back(n);
        };
        add_composite("C0", {count(regions[pick(3)]), count(regions[pick(3)])});
        if (pick(2) == 0) {  // a C0, and more
            mentioned.clear();
            const ClassPointer more = count(regions[pick(3)]);
            kinds["C1"] = kinds["C0"];
            mentions[static_cast<std::size_t>(kinds["C0"])].insert(mentioned.begin(), mentioned.end());
            own_mentions_["C1"] = mentioned;
            define("C1", both({name("C0"), more}));
            composites.emplace_back("C1");
        } else if (pick(2) == 0) {
            mentioned.clear();
            add_composite("C1", {count(regions[pick(3)])});
        }
        if (pick(2) == 0) {  // one layer up
            mentioned.clear();
            std::vector<ClassPointer> counts{count("C0")};
            if (pick(2) == 0) counts.push_back(count(regions[pick(3)]));
            add_composite("D", counts);
        }
        if (composites.size() > 1 && pick(2) == 0) {
            define("E", either({name(composites[0]), name(composites[1])}));
            composites.emplace_back("E");
        }
        for (int i = 0; i < 3; ++i) {
            std::vector<ClassPointer> counts{name("Object"), count(composites[pick(composites.size())])};
            if (pick(2) == 0) counts.push_back(count(regions[pick(3)]));
            if (pick(4) == 0) counts.push_back(some("hasPart", both({name("C0"), some("hasPart", "P1")})));
            objects.push_back("Q" + std::to_string(i));
            define(objects.back(), both(counts));
        }
        if (pick(4) == 0) {
            constraints.emplace_back(name("C0"), at_most(1, name(regions[pick(3)])));
            ontology.sub(constraints.back().first, constraints.back().second);
        }
    }

    bool holds(const owl::ClassExpression& c, const Individual& x) const {
        const auto again = [&](const ClassPointer& o) { return holds(*o, x); };
        switch (c.kind) {
            case ClassKind::named: {
                const std::string n = owl::local_name(c.iri);
                if (n == "Region" || n == "CompositePart" || n == "Object") return true;
                const auto kind = kinds.find(n);
                if (kind != kinds.end() && kind->second != x.kind) return false;
                if (n[0] == 'P' && !x.is_region()) return false;
                if ((n[0] == 'C' || n[0] == 'D' || n[0] == 'E') && x.kind < 0) return false;
                return holds(*definitions.at(n), x);
            }
            case ClassKind::intersection_of:
                return std::ranges::all_of(c.operands, again);
            case ClassKind::union_of:
                return std::ranges::any_of(c.operands, again);
            case ClassKind::complement_of:
                return !again(c.operands[0]);
            default:
                break;
        }
        if (x.is_region()) {
            const bool is_not = c.operands[0]->kind == ClassKind::complement_of;
            return (owl::local_name((is_not ? *c.operands[0]->operands[0] : *c.operands[0]).iri) == x.value) != is_not;
        }
        const auto n = static_cast<unsigned>(
            std::ranges::count_if(x.parts, [&](const Individual* part) { return holds(*c.operands[0], *part); }));
        switch (c.kind) {
            case ClassKind::some_values_from:
                return n > 0;
            case ClassKind::min_cardinality:
                return n >= c.number;
            case ClassKind::max_cardinality:
                return n <= c.number;
            default:
                return n == c.number;
        }
    }

    /// Kinds in an order in which each comes after what it is made of.
    [[nodiscard]] std::vector<int> order() const {
        std::vector<int> lower, higher;
        for (int k = 0; k < static_cast<int>(mentions.size()); ++k)
            (mentions[static_cast<std::size_t>(k)].contains("C0") ? higher : lower).push_back(k);
        lower.insert(lower.end(), higher.begin(), higher.end());
        return lower;
    }

    /// The composite parts of `regions`; empty `ok` when one breaks a constraint.
    void build(std::vector<Individual>& regions, const std::vector<std::pair<int, int>>& connected,
               std::vector<std::unique_ptr<Individual>>& made, bool& ok) const {
        for (const int k : order()) {
            std::set<int> members;
            for (const std::string& mention : mentions[static_cast<std::size_t>(k)]) {
                for (int r = 0; r < static_cast<int>(regions.size()); ++r)
                    if (holds(*name(mention), regions[static_cast<std::size_t>(r)])) members.insert(r);
                for (const auto& part : made)
                    if (holds(*name(mention), *part)) members.insert(part->regions.begin(), part->regions.end());
            }
            const std::size_t before = made.size();
            while (!members.empty()) {
                auto part = std::make_unique<Individual>();
                part->kind = k;
                part->regions.insert(*members.begin());
                for (bool grown = true; grown;) {
                    grown = false;
                    for (const auto& [a, b] : connected)
                        if (members.contains(a) && members.contains(b) &&
                            part->regions.contains(a) != part->regions.contains(b)) {
                            part->regions.insert(a);
                            part->regions.insert(b);
                            grown = true;
                        }
                }
                for (const int r : part->regions) {
                    members.erase(r);
                    part->parts.push_back(&regions[static_cast<std::size_t>(r)]);
                }
                for (std::size_t m = 0; m < before; ++m)
                    if (std::ranges::includes(part->regions, made[m]->regions)) part->parts.push_back(made[m].get());
                made.push_back(std::move(part));
            }
        }
        for (const auto& [sub, super] : constraints)
            for (const auto& part : made)
                if (holds(*sub, *part) && !holds(*super, *part)) ok = false;
    }

private:
    std::map<std::string, Names> own_mentions_;
};

/// Regions of which each two touch or not, all of them known; `answer_about` each adds what was asked of it.
template <class AnswerAbout>
Knowledge random_mesh(std::mt19937& random, int regions, const AnswerAbout& answer_about) {
    Knowledge knowledge;
    knowledge.region_count = regions;
    knowledge.complete = true;
    for (int a = 0; a < regions; ++a) {
        for (int b = 0; b < a; ++b)
            if (random() % 2 == 0) knowledge.connected.emplace_back(b, a);
        answer_about(a, knowledge.answers);
    }
    return knowledge;
}

}  // namespace composites_random
