/* Axioms about properties.

   A chain p1 o … o pk SubPropertyOf q is cut into steps: "a reaches c by the first i properties" is a literal of its
   own, implied by what makes it true (nothing more is needed of a premise), so a chain costs k - 1 times n³ clauses
   instead of n to the k + 1. Chains with the same beginning share it. Transitivity is the chain p o p. */

#include <algorithm>

#include "knowledge/closed_grounder.h"

namespace partonomy::knowledge::closed {

using owl::Axiom;
using owl::AxiomKind;

void Grounder::ground_object_property(const Axiom& axiom) {
    std::vector<Property> p;
    for (const owl::PropertyExpression& expression : axiom.properties) p.push_back(property_of(expression));
    if (axiom.kind == AxiomKind::sub_object_property_of && p.size() > 2)
        return ground_chain({p.begin(), p.end() - 1}, p.back());
    if (axiom.kind == AxiomKind::transitive_object_property) return ground_chain({p[0], p[0]}, p[0]);
    if (axiom.kind == AxiomKind::functional_object_property ||
        axiom.kind == AxiomKind::inverse_functional_object_property) {
        if (axiom.kind == AxiomKind::inverse_functional_object_property) p[0].inverse = !p[0].inverse;
        for (int a = 0; a < count_; ++a) require({-at_least_related(p[0], thing_, a, 2)});
        return;
    }
    if (axiom.kind == AxiomKind::object_property_domain || axiom.kind == AxiomKind::object_property_range) {
        if (axiom.kind == AxiomKind::object_property_range) p[0].inverse = !p[0].inverse;
        const int expression = intern(axiom.classes[0]);
        for (int a = 0; a < count_; ++a) require({-some_related(p[0], thing_, a), holds(expression, a)});
        return;
    }
    if (axiom.kind == AxiomKind::disjoint_object_properties) make_set(p, 0);
    for (int a = 0; a < count_; ++a) {
        std::vector<int> partners{a};  // others are related by none of them
        for (const Property& property : p)
            for (const bool inverse : {false, true}) {
                const std::vector<int>& some = candidates({property.id, inverse}, a);
                partners.insert(partners.end(), some.begin(), some.end());
            }
        make_set(partners, 0);
        expect_clauses(static_cast<double>(partners.size() * p.size()));
        for (const int b : partners) {
            std::vector<int> here;
            for (const Property& property : p) here.push_back(property_atom(property, a, b));
            switch (axiom.kind) {
                case AxiomKind::sub_object_property_of:
                    require({-here[0], here[1]});
                    break;
                case AxiomKind::equivalent_object_properties:
                    for (std::size_t i = 0; i < here.size(); ++i) require({-here[i], here[(i + 1) % here.size()]});
                    break;
                case AxiomKind::inverse_object_properties:
                    require({-here[0], property_atom(p[1], b, a)});
                    require({-property_atom(p[1], b, a), here[0]});
                    break;
                case AxiomKind::disjoint_object_properties:
                    require_at_most_one(here);
                    break;
                case AxiomKind::symmetric_object_property:
                    require({-here[0], property_atom(p[0], b, a)});
                    break;
                case AxiomKind::asymmetric_object_property:
                    require({-here[0], -property_atom(p[0], b, a)});
                    break;
                case AxiomKind::reflexive_object_property:
                    if (a == b) require({here[0]});
                    break;
                case AxiomKind::irreflexive_object_property:
                    if (a == b) require({-here[0]});
                    break;
                default:
                    break;
            }
        }
    }
}

void Grounder::ground_chain(std::vector<Property> chain, Property whole) {
    const auto n = static_cast<std::size_t>(count_);
    const double step = static_cast<double>(count_) * count_ * count_;
    std::vector<int> key{chain[0].id, chain[0].inverse};
    std::vector<int> reached(n * n);
    for (int a = 0; a < count_; ++a)
        for (int b = 0; b < count_; ++b)
            reached[static_cast<std::size_t>(a) * n + static_cast<std::size_t>(b)] = property_atom(chain[0], a, b);
    for (std::size_t i = 1; i < chain.size(); ++i) {
        const bool is_last = i + 1 == chain.size();
        key.insert(key.end(), {chain[i].id, chain[i].inverse});
        std::vector<int>* shared = nullptr;
        if (!is_last) {
            const auto [found, is_new] = compositions_.try_emplace(key);
            if (!is_new) {
                reached = found->second;
                continue;
            }
            found->second.resize(n * n);
            for (int& variable : found->second) variable = clauses.add_variable();
            shared = &found->second;
        }
        if (known_.empty()) expect_clauses(step);
        for (int a = 0; a < count_; ++a)
            for (int b = 0; b < count_; ++b) {
                const auto row = static_cast<std::size_t>(a) * n;
                const int first = reached[row + static_cast<std::size_t>(b)];
                if (first == -always_) continue;
                expect_clauses(0);
                for (const int c : candidates(chain[i], b)) {
                    const int second = property_atom(chain[i], b, c);
                    if (is_last)
                        require({-first, -second, property_atom(whole, a, c)});
                    else
                        clauses.add({-first, -second, (*shared)[row + static_cast<std::size_t>(c)]});
                }
            }
        if (!is_last) reached = *shared;
    }
}

void Grounder::ground_data_property(const Axiom& axiom) {
    std::vector<int> d;
    for (const owl::PropertyExpression& expression : axiom.properties) d.push_back(data_property_of(expression));
    if (axiom.kind == AxiomKind::disjoint_data_properties) make_set(d, 0);
    for (int a = 0; a < count_; ++a) {
        switch (axiom.kind) {
            case AxiomKind::data_property_domain:
                require({-some_value(d[0], a, all_literals_), holds(intern(axiom.classes[0]), a)});
                continue;
            case AxiomKind::data_property_range:
                require({-some_value(d[0], a, complement_id(range_id(axiom.range)))});
                continue;
            case AxiomKind::functional_data_property:
                require({-at_least_values(d[0], a, all_literals_, 2)});
                continue;
            default:
                break;
        }
        const auto named = std::ranges::find_if(d, [](int property) { return property >= 0; });
        if (named == d.end() || (axiom.kind == AxiomKind::sub_data_property_of && d[1] == Property::top)) continue;
        for (std::size_t value = 0; value < group_of(*named).values.size(); ++value) {
            std::vector<int> here;
            for (const int property : d) here.push_back(data_atom(property, a, value));
            if (axiom.kind == AxiomKind::sub_data_property_of) require({-here[0], here[1]});
            if (axiom.kind == AxiomKind::disjoint_data_properties) require_at_most_one(here);
            if (axiom.kind == AxiomKind::equivalent_data_properties)
                for (std::size_t i = 0; i < here.size(); ++i) require({-here[i], here[(i + 1) % here.size()]});
        }
    }
}

void Grounder::ground_key(const Axiom& axiom) {
    const int expression = intern(axiom.classes[0]);
    for (int a = 0; a < count_; ++a) {
        for (int b = 0; b < a; ++b) {
            std::vector<int> clause{-holds(expression, a), -holds(expression, b), equality(a, b)};
            for (const owl::PropertyExpression& each : axiom.properties) {
                std::vector<int> shared;  // "a and b have this value in common"
                if (is_data_property(each)) {
                    const int property = data_property_of(each);
                    const std::size_t values = property < 0 ? 0 : group_of(property).values.size();
                    for (std::size_t value = 0; value < values; ++value)
                        shared.push_back(
                            clauses.all_of({data_atom(property, a, value), data_atom(property, b, value)}));
                } else {
                    const Property property = property_of(each);
                    for (int c = 0; c < count_; ++c)
                        shared.push_back(
                            clauses.all_of({property_atom(property, a, c), property_atom(property, b, c)}));
                }
                clause.push_back(-clauses.any_of(shared));
                expect_clauses(0);
            }
            require(clause);
        }
    }
}

}  // namespace partonomy::knowledge::closed
