/* Variables for what can be true of names: C(a), p(a, b), d(a, v), a = b. They are made when first asked for, so a
   property that only assertions mention costs a variable for each assertion and not for each pair.

   Names that may mean the same individual have a variable that says so. These are an equivalence relation (a clause for
   every three names), and whatever is said of one name then holds of the other: a clause for each atom and each name
   that its subject or object may equal. ClosedWorld::individuals and what must differ cost nothing: their equality is
   the constant false. */

#include <algorithm>
#include <set>

#include "knowledge/closed_grounder.h"

namespace partonomy::knowledge::closed {

int Names::add(const Iri& iri) {
    const auto [found, is_new] = ids.try_emplace(iri, static_cast<int>(iris.size()));
    if (is_new) iris.push_back(iri);
    return found->second;
}

std::vector<Iri> Names::sorted() const {
    std::vector<Iri> result = iris;
    std::ranges::sort(result);
    return result;
}

void Grounder::make_equalities() {
    std::vector<bool> is_unique(static_cast<std::size_t>(count_), false);
    for (const Iri& iri : world.individuals) is_unique[static_cast<std::size_t>(individuals.ids.at(iri))] = true;
    const auto open = static_cast<std::size_t>(std::ranges::count(is_unique, false));
    std::set<std::pair<int, int>> different;
    if (open > options.max_equalities) {
        for (const owl::Axiom& axiom : world.ontology.axioms) {
            if (axiom.kind != owl::AxiomKind::different_individuals) continue;
            for (const Iri& a : axiom.individuals)
                for (const Iri& b : axiom.individuals) different.emplace(individuals.ids.at(a), individuals.ids.at(b));
        }
    }
    possibly_same_.resize(is_unique.size());
    equalities_.resize(is_unique.size());
    double triples = 0;
    for (int a = 0; a < count_; ++a) {
        const auto row = static_cast<std::size_t>(a);
        for (int b = 0; b < count_; ++b) {
            const auto column = static_cast<std::size_t>(b);
            if (a == b || (is_unique[row] && is_unique[column]) || different.contains({a, b})) continue;
            possibly_same_[row].push_back(b);
            equalities_[row].push_back(b > a ? clauses.add_variable() : equality(b, a));
        }
        triples +=
            static_cast<double>(possibly_same_[row].size()) * static_cast<double>(possibly_same_[row].size()) / 2;
    }
    if (triples > static_cast<double>(options.max_clauses)) {
        throw CannotGround{std::to_string(open) +
                           " individuals may all be the same one, which is too many to compare; "
                           "declare them different (DifferentIndividuals)"};
    }
    for (std::size_t middle = 0; middle < possibly_same_.size(); ++middle)
        for (std::size_t i = 0; i < possibly_same_[middle].size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                clauses.add({-equalities_[middle][i], -equalities_[middle][j],
                             equality(possibly_same_[middle][i], possibly_same_[middle][j])});
            }
}

int Grounder::equality(int a, int b) const {
    if (a == b) return always_;
    const auto& others = possibly_same_[static_cast<std::size_t>(a)];
    const auto found = std::ranges::lower_bound(others, b);
    if (found == others.end() || *found != b) return -always_;
    return equalities_[static_cast<std::size_t>(a)][static_cast<std::size_t>(found - others.begin())];
}

int Grounder::is_first(int individual) {
    std::vector<int> literals;
    for (const int other : possibly_same_[static_cast<std::size_t>(individual)])
        if (other < individual) literals.push_back(-equality(individual, other));
    return clauses.all_of(literals);
}

void Grounder::learn_known() {
    const auto everybody = static_cast<std::size_t>(count_);
    for (int individual = 0; individual < count_; ++individual) everybody_.push_back(individual);
    for (const ClosedWorld::Known& each : world.known) {
        KnownProperty& known = known_[properties.add(each.property)];
        known.is_among.assign(everybody, 0);
        for (const Iri& iri : each.among) known.is_among[static_cast<std::size_t>(individuals.ids.at(iri))] = 1;
        for (auto& related : known.related) related.assign(everybody, {});
        for (const auto& [subject, object] : each.possible) {
            const int from = individuals.ids.at(subject), to = individuals.ids.at(object);
            known.related[0][static_cast<std::size_t>(from)].push_back(to);
            known.related[1][static_cast<std::size_t>(to)].push_back(from);
        }
        for (auto& related : known.related)
            for (std::vector<int>& row : related) make_set(row, 0);
        for (int individual = 0; individual < count_; ++individual)
            if (!known.is_among[static_cast<std::size_t>(individual)]) known.others.push_back(individual);
    }
}

const std::vector<int>& Grounder::candidates(Property property, int subject) const {
    const auto found = known_.find(property.id);
    if (found == known_.end()) return everybody_;
    const auto row = static_cast<std::size_t>(subject);
    return found->second.is_among[row] ? found->second.related[property.inverse ? 1 : 0][row] : found->second.others;
}

int& Grounder::slot(const Atom& atom) {
    const auto subject = static_cast<std::size_t>(atom.subject);
    const auto other = static_cast<std::size_t>(atom.other);
    const auto name = static_cast<std::size_t>(atom.name);
    const auto grow = [&](auto& table, std::size_t size) -> auto& {
        if (table.size() < size) table.resize(size);
        return table;
    };
    const auto everybody = static_cast<std::size_t>(count_);
    if (atom.kind == Atom::Kind::klass) return grow(grow(class_atoms_, name + 1)[name], everybody)[subject];
    if (atom.kind == Atom::Kind::property)
        return grow(grow(grow(property_atoms_, name + 1)[name], everybody)[subject], everybody)[other];
    return grow(grow(grow(data_atoms_, name + 1)[name], everybody)[subject], group_of(atom.name).values.size())[other];
}

int Grounder::atom(const Atom& atom) {
    int& variable = slot(atom);
    if (variable != 0) return variable;
    const int result = variable = clauses.add_variable();
    new_atoms_.push_back(atom);
    if (!is_respecting_) respect_equalities();
    return result;
}

void Grounder::respect_equalities() {
    is_respecting_ = true;
    while (!new_atoms_.empty()) {
        const Atom each = new_atoms_.back();
        new_atoms_.pop_back();
        const int here = slot(each);
        for (const int same : possibly_same_[static_cast<std::size_t>(each.subject)])
            clauses.add({-here, -equality(each.subject, same), atom({each.kind, each.name, same, each.other})});
        if (each.kind != Atom::Kind::property) continue;
        for (const int same : possibly_same_[static_cast<std::size_t>(each.other)])
            clauses.add({-here, -equality(each.other, same), atom({each.kind, each.name, each.subject, same})});
    }
    is_respecting_ = false;
}

int Grounder::class_atom(int klass, int individual) {
    if (klass == everything) return always_;
    if (klass == nothing) return -always_;
    return atom({Atom::Kind::klass, klass, individual, 0});
}

int Grounder::property_atom(Property property, int subject, int object) {
    if (property.id == Property::top) return always_;
    if (property.id == Property::bottom) return -always_;
    if (property.inverse) std::swap(subject, object);
    if (known_.contains(property.id) && !std::ranges::binary_search(candidates({property.id, false}, subject), object))
        return -always_;
    return atom({Atom::Kind::property, property.id, subject, object});
}

int Grounder::data_atom(int property, int individual, std::size_t value) {
    if (property == Property::bottom) return -always_;
    return atom({Atom::Kind::data, property, individual, static_cast<int>(value)});
}

}  // namespace partonomy::knowledge::closed
