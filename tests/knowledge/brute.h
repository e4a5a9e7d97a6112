#pragma once

#include <map>
#include <random>
#include <set>

#include "knowledge/explain.h"
#include "mini.h"

// The second opinion: an ontology evaluated by the book, one region and one object after the other, straight from its
// axioms. A class whose defining axiom is not kept is tried with both truth values. Only for tiny ontologies.

namespace brute {

using namespace partonomy;
using owl::ClassKind;

struct Region {
    std::map<owl::Iri, owl::Iri> features;  ///< property to value
    std::map<owl::Iri, bool> classes;       ///< of each region class
};

using Classes = std::map<owl::Iri, bool>;

inline bool value_is(const owl::ClassExpression& c, const owl::Iri& value) {
    switch (c.kind) {
        case ClassKind::intersection_of:
            return std::ranges::all_of(c.operands, [&](const auto& o) { return value_is(*o, value); });
        case ClassKind::union_of:
            return std::ranges::any_of(c.operands, [&](const auto& o) { return value_is(*o, value); });
        case ClassKind::complement_of:
            return !value_is(*c.operands[0], value);
        default:
            return c.iri == value;
    }
}

inline bool holds(const owl::ClassExpression& c, const Classes& classes, const Region* region,
                  const std::vector<const Region*>& parts) {
    const auto again = [&](const auto& o) { return holds(*o, classes, region, parts); };
    const auto is_member = [&](const Region* part) { return holds(*c.operands[0], part->classes, part, {}); };
    switch (c.kind) {
        case ClassKind::named:
            return c.iri.ends_with("#Thing") || c.iri.ends_with("#Region") || c.iri.ends_with("#Object") ||
                   classes.at(c.iri);
        case ClassKind::intersection_of:
            return std::ranges::all_of(c.operands, again);
        case ClassKind::union_of:
            return std::ranges::any_of(c.operands, again);
        case ClassKind::complement_of:
            return !again(c.operands[0]);
        default:
            break;
    }
    if (region != nullptr) return value_is(*c.operands[0], region->features.at(c.property.iri));
    const auto n = static_cast<std::size_t>(std::ranges::count_if(parts, is_member));
    switch (c.kind) {
        case ClassKind::some_values_from:
            return n > 0;
        case ClassKind::all_values_from:
            return n == parts.size();
        case ClassKind::min_cardinality:
            return n >= c.number;
        case ClassKind::max_cardinality:
            return n <= c.number;
        default:
            return n == c.number;
    }
}

/// A random ontology: two or three range concepts, region classes P0.., object classes Q0.., constraints.
struct Random {
    /// Whether a kept axiom speaks of the class.
    [[nodiscard]] bool is_mentioned(const std::string& name, const std::vector<char>& kept) const {
        for (std::size_t i = 0; i < kept.size(); ++i) {
            if (!kept[i] || i < first_class) continue;
            for (const owl::ClassPointer& c : ontology.result.axioms[i].classes)
                if (to_manchester(*c).find(name) != std::string::npos) return true;
        }
        return false;
    }

    mini::Ontology ontology;
    std::size_t first_class = 0;  ///< axioms before it say what features there are
    std::vector<std::vector<std::string>> values;
    std::vector<std::string> region_classes, object_classes;
    std::map<owl::Iri, std::size_t> definition;  ///< axiom of each class
    std::vector<std::size_t> constraints;        ///< axioms that are A SubClassOf B over regions, or over objects

    Random(std::mt19937& random, bool with_constraints, std::size_t most_ranges = 3) {
        const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
        const std::size_t ranges = 2 + pick(most_ranges - 1);
        for (std::size_t r = 0; r < ranges; ++r) {
            values.emplace_back();
            for (std::size_t v = 0; v < 2 + (r == 0 ? pick(2) : 0); ++v)
                values.back().push_back(std::string("v").append(std::to_string(r)).append(std::to_string(v)));
            ontology.range(std::string("F").append(std::to_string(r)), values.back());
        }
        first_class = ontology.result.axioms.size();
        const auto region_expression = [&](const auto& self, int depth) -> owl::ClassPointer {
            const std::size_t kind = pick(depth > 0 ? 5 : 2);
            if (kind == 0 && !region_classes.empty()) return mini::name(region_classes[pick(region_classes.size())]);
            if (kind == 2) return mini::no(self(self, depth - 1));
            if (kind == 3) return mini::both({self(self, depth - 1), self(self, depth - 1)});
            if (kind == 4) return mini::either({self(self, depth - 1), self(self, depth - 1)});
            const std::size_t r = pick(values.size());
            auto value = mini::name(values[r][pick(values[r].size())]);
            if (pick(4) == 0) value = mini::no(value);
            const std::string property = "hasF" + std::to_string(r);
            return pick(3) == 0 ? mini::only(property, value) : mini::some(property, value);
        };
        const auto object_expression = [&](const auto& self, int depth) -> owl::ClassPointer {
            const std::size_t kind = pick(depth > 0 ? 5 : 2);
            if (kind == 0 && !object_classes.empty()) return mini::name(object_classes[pick(object_classes.size())]);
            if (kind == 2) return mini::no(self(self, depth - 1));
            if (kind == 3) return mini::both({self(self, depth - 1), self(self, depth - 1)});
            if (kind == 4) return mini::either({self(self, depth - 1), self(self, depth - 1)});
            const auto part = region_expression(region_expression, 1);
            const unsigned n = static_cast<unsigned>(pick(3));
            switch (pick(5)) {
                case 0:
                    return mini::only("hasPart", part);
                case 1:
                    return mini::at_least(n, part);
                case 2:
                    return mini::at_most(n, part);
                case 3:
                    return mini::exactly(n, part);
                default:
                    return mini::some("hasPart", part);
            }
        };
        for (int i = 0; i < 3; ++i) {
            const std::string name = "P" + std::to_string(i);
            definition[mini::iri(name)] = ontology.result.axioms.size();
            ontology.same(name, mini::both({mini::name("Region"), region_expression(region_expression, 2)}));
            region_classes.push_back(name);
        }
        for (int i = 0; i < 3; ++i) {
            const std::string name = "Q" + std::to_string(i);
            definition[mini::iri(name)] = ontology.result.axioms.size();
            ontology.same(name, mini::both({mini::name("Object"), object_expression(object_expression, 2)}));
            object_classes.push_back(name);
        }
        if (!with_constraints) return;
        constraints.push_back(ontology.result.axioms.size());
        ontology.sub(region_expression(region_expression, 1), region_expression(region_expression, 1));
        constraints.push_back(ontology.result.axioms.size());
        ontology.sub(mini::both({mini::name("Object"), object_expression(object_expression, 1)}),
                     object_expression(object_expression, 1));
    }
};

/// Which of the space's concepts hold, for each configuration in `set`.
inline std::set<std::vector<bool>> rows_in(const knowledge::Space& space, const knowledge::ConfigurationSet& set) {
    std::set<std::vector<bool>> rows;
    set.for_each([&](std::size_t i) {
        std::vector<bool> row;
        for (const knowledge::Concept& each : space.concepts) row.push_back(each.where.has(i));
        rows.insert(row);
    });
    return rows;
}

/// Gives each class in `names` its truth value, both where its axiom is not kept, and keeps what meets the constraints.
inline std::vector<Classes> classify(const Random& random, const std::vector<std::string>& names,
                                     const std::vector<char>& kept, const Region* region,
                                     const std::vector<const Region*>& parts) {
    std::vector<Classes> results{{}};
    for (const std::string& name : names) {
        const std::size_t axiom = random.definition.at(mini::iri(name));
        if (!kept[axiom] && !random.is_mentioned(name, kept)) {
            for (Classes& each : results) each[mini::iri(name)] = false;  // makes no difference
            continue;
        }
        std::vector<Classes> next;
        for (const Classes& each : results) {
            for (const bool value : {false, true}) {
                if (kept[axiom] &&
                    value != holds(*random.ontology.result.axioms[axiom].classes[1], each, region, parts))
                    continue;
                next.push_back(each);
                next.back()[mini::iri(name)] = value;
            }
        }
        results = std::move(next);
    }
    for (std::size_t i = 0; i < random.constraints.size(); ++i) {
        const std::size_t axiom = random.constraints[i];
        if (!kept[axiom] || (i == 0) != (region != nullptr)) continue;
        const auto& classes = random.ontology.result.axioms[axiom].classes;
        std::erase_if(results, [&](const Classes& each) {
            return holds(*classes[0], each, region, parts) && !holds(*classes[1], each, region, parts);
        });
    }
    return results;
}

inline std::vector<Region> all_regions(const Random& random, const std::vector<char>& kept) {
    std::vector<Region> regions{{}};
    for (std::size_t r = 0; r < random.values.size(); ++r) {
        std::vector<Region> next;
        for (const Region& each : regions)
            for (const std::string& value : random.values[r]) {
                next.push_back(each);
                next.back().features[mini::iri("hasF" + std::to_string(r))] = mini::iri(value);
            }
        regions = std::move(next);
    }
    std::vector<Region> result;
    for (const Region& each : regions)
        for (Classes& classes : classify(random, random.region_classes, kept, &each, {})) {
            result.push_back(each);
            result.back().classes = std::move(classes);
        }
    return result;
}

/// Calls `visit` with the classes of every object that `knowledge` allows: its regions, and up to `more` others.
template <typename Visit>
void for_each_object(const Random& random, const knowledge::Knowledge& knowledge, const std::vector<char>& kept,
                     const std::vector<char>& answers, int more, const Visit& visit) {
    const std::vector<Region> regions = all_regions(random, kept);
    std::vector<std::vector<const Region*>> choices(static_cast<std::size_t>(knowledge.region_count));
    for (std::size_t i = 0; i < choices.size(); ++i)
        for (const Region& region : regions) {
            bool fits = true;
            for (std::size_t a = 0; a < answers.size(); ++a) {
                const knowledge::Answer& answer = knowledge.answers[a];
                if (!answers[a] || answer.region != static_cast<int>(i)) continue;
                const std::size_t r = answer.question.variable;
                const bool is = region.features.at(mini::iri("hasF" + std::to_string(r))) ==
                                mini::iri(random.values[r][answer.question.value]);
                fits &= is == answer.yes;
            }
            if (fits) choices[i].push_back(&region);
        }
    std::vector<const Region*> parts;
    const auto extend = [&](const auto& self, std::size_t i, int extra, std::size_t from) -> void {
        if (i < choices.size()) {
            for (const Region* region : choices[i]) {
                parts.push_back(region);
                self(self, i + 1, extra, 0);
                parts.pop_back();
            }
            return;
        }
        for (const Classes& classes : classify(random, random.object_classes, kept, nullptr, parts)) visit(classes);
        if (extra == 0) return;
        for (std::size_t k = from; k < regions.size(); ++k) {
            parts.push_back(&regions[k]);
            self(self, i, extra - 1, k);
            parts.pop_back();
        }
    };
    extend(extend, 0, more, 0);
}

/// One or two regions, and up to six answers about them.
inline knowledge::Knowledge random_knowledge(std::mt19937& random, const Random& ontology) {
    knowledge::Knowledge knowledge;
    knowledge.region_count = static_cast<int>(random() % 2) + 1;
    knowledge.complete = random() % 2 == 0;
    const std::size_t answers = random() % 7;
    for (std::size_t a = 0; a < answers; ++a) {
        const auto variable = static_cast<int>(random() % ontology.values.size());
        const auto value = static_cast<int>(random() % ontology.values[static_cast<std::size_t>(variable)].size());
        knowledge.answers.push_back({static_cast<int>(random() % static_cast<unsigned>(knowledge.region_count)),
                                     {variable, value},
                                     random() % 3 != 0});
    }
    return knowledge;
}

}  // namespace brute
