#include "closed_oracle.h"

#include <bit>
#include <functional>
#include <map>
#include <vector>

#include "owl/words.h"

namespace closed_oracle {

using namespace partonomy;
using namespace partonomy::owl;

namespace {

using Set = unsigned;  // of elements, or of values

/// The values that a data property may have here, the worlds of closed_random having cardinalities up to 1 and the
/// constants 0 and 1: below, at, between and above them, and one that is no integer. Where two properties or
/// individuals may want different ones, all eight.
constexpr int no_integer = 1000;
constexpr int values[] = {0, 1, -1, 2, no_integer, -2, 3, no_integer};
constexpr unsigned few = 5, many = 8;

struct Interpretation {
    unsigned elements = 0;
    std::map<Iri, unsigned> element_of;
    std::map<Iri, Set> classes;
    std::map<Iri, std::vector<Set>> properties;  // by subject: objects
    std::map<Iri, std::vector<Set>> data;        // by subject: values
    [[nodiscard]] Set everything() const { return (1U << elements) - 1; }
};

class Evaluator {
public:
    Evaluator(const Ontology& ontology, unsigned value_count) : ontology_(ontology), value_count_(value_count) {
        for (const Axiom& axiom : ontology.axioms) note_known(axiom);
    }

    [[nodiscard]] bool holds(const Axiom& axiom, const Interpretation& in) const {
        const auto classes = [&] {
            std::vector<Set> sets;
            for (const ClassPointer& each : axiom.classes) sets.push_back(extension(*each, in));
            return sets;
        };
        const auto related = [&](std::size_t i, unsigned a, unsigned b) {
            return relates(axiom.properties[i], a, b, in);
        };
        const auto element = [&](std::size_t i) { return in.element_of.at(axiom.individuals[i]); };
        const auto of = [&](std::size_t i, unsigned a) { return data_of(axiom.properties[i].iri, a, in); };
        const unsigned n = in.elements;
        switch (axiom.kind) {
            case AxiomKind::sub_class_of: {
                const auto sets = classes();
                return (sets[0] & ~sets[1]) == 0;
            }
            case AxiomKind::equivalent_classes: {
                for (const Set set : classes())
                    if (set != extension(*axiom.classes[0], in)) return false;
                return true;
            }
            case AxiomKind::disjoint_classes:
            case AxiomKind::disjoint_union: {
                const std::size_t first = axiom.kind == AxiomKind::disjoint_union ? 1 : 0;
                const auto sets = classes();
                Set whole = 0;
                for (std::size_t i = first; i < sets.size(); ++i) {
                    for (std::size_t j = first; j < i; ++j)
                        if (!same(*axiom.classes[i], *axiom.classes[j]) && (sets[i] & sets[j]) != 0) return false;
                    whole |= sets[i];
                }
                return first == 0 || whole == sets[0];
            }
            case AxiomKind::sub_object_property_of:
                return chain(axiom, in);
            case AxiomKind::equivalent_object_properties:
            case AxiomKind::inverse_object_properties:
            case AxiomKind::disjoint_object_properties:
            case AxiomKind::symmetric_object_property:
            case AxiomKind::asymmetric_object_property:
            case AxiomKind::transitive_object_property:
                for (unsigned a = 0; a < n; ++a)
                    for (unsigned b = 0; b < n; ++b) {
                        const bool here = related(0, a, b);
                        if (axiom.kind == AxiomKind::equivalent_object_properties && here != related(1, a, b))
                            return false;
                        if (axiom.kind == AxiomKind::inverse_object_properties && here != related(1, b, a))
                            return false;
                        if (axiom.kind == AxiomKind::disjoint_object_properties &&
                            axiom.properties[0] != axiom.properties[1] && here && related(1, a, b))
                            return false;
                        if (axiom.kind == AxiomKind::symmetric_object_property && here != related(0, b, a))
                            return false;
                        if (axiom.kind == AxiomKind::asymmetric_object_property && here && related(0, b, a))
                            return false;
                        if (axiom.kind != AxiomKind::transitive_object_property) continue;
                        for (unsigned c = 0; c < n; ++c)
                            if (here && related(0, b, c) && !related(0, a, c)) return false;
                    }
                return true;
            case AxiomKind::object_property_domain:
            case AxiomKind::object_property_range: {
                const Set set = extension(*axiom.classes[0], in);
                const bool is_range = axiom.kind == AxiomKind::object_property_range;
                for (unsigned a = 0; a < n; ++a)
                    for (unsigned b = 0; b < n; ++b)
                        if (related(0, a, b) && ((set >> (is_range ? b : a)) & 1U) == 0) return false;
                return true;
            }
            case AxiomKind::functional_object_property:
            case AxiomKind::inverse_functional_object_property:
                for (unsigned a = 0; a < n; ++a) {
                    int count = 0;
                    for (unsigned b = 0; b < n; ++b)
                        count +=
                            axiom.kind == AxiomKind::functional_object_property ? related(0, a, b) : related(0, b, a);
                    if (count > 1) return false;
                }
                return true;
            case AxiomKind::reflexive_object_property:
            case AxiomKind::irreflexive_object_property:
                for (unsigned a = 0; a < n; ++a)
                    if (related(0, a, a) != (axiom.kind == AxiomKind::reflexive_object_property)) return false;
                return true;
            case AxiomKind::sub_data_property_of:
            case AxiomKind::equivalent_data_properties:
            case AxiomKind::disjoint_data_properties:
            case AxiomKind::data_property_domain:
            case AxiomKind::data_property_range:
            case AxiomKind::functional_data_property:
                for (unsigned a = 0; a < n; ++a) {
                    const Set here = of(0, a);
                    if (axiom.kind == AxiomKind::sub_data_property_of && !is_top(axiom.properties[1]) &&
                        (here & ~of(1, a)) != 0)
                        return false;
                    if (axiom.kind == AxiomKind::equivalent_data_properties && here != of(1, a)) return false;
                    if (axiom.kind == AxiomKind::disjoint_data_properties &&
                        axiom.properties[0] != axiom.properties[1] && (here & of(1, a)) != 0)
                        return false;
                    if (axiom.kind == AxiomKind::data_property_domain && here != 0 &&
                        ((extension(*axiom.classes[0], in) >> a) & 1U) == 0)
                        return false;
                    if (axiom.kind == AxiomKind::data_property_range && (here & ~inside(axiom.range)) != 0)
                        return false;
                    if (axiom.kind == AxiomKind::functional_data_property && std::popcount(here) > 1) return false;
                }
                return true;
            case AxiomKind::class_assertion:
                return ((extension(*axiom.classes[0], in) >> element(0)) & 1U) != 0;
            case AxiomKind::object_property_assertion:
                return related(0, element(0), element(1));
            case AxiomKind::negative_object_property_assertion:
                return !related(0, element(0), element(1));
            case AxiomKind::data_property_assertion:
                return (of(0, element(0)) & value(axiom.literal)) != 0;
            case AxiomKind::negative_data_property_assertion:
                return (of(0, element(0)) & value(axiom.literal)) == 0;
            case AxiomKind::same_individual:
            case AxiomKind::different_individuals:
                for (std::size_t i = 0; i < axiom.individuals.size(); ++i)
                    for (std::size_t j = 0; j < i; ++j)
                        if ((element(i) == element(j)) != (axiom.kind == AxiomKind::same_individual)) return false;
                return true;
            case AxiomKind::has_key:
                return key(axiom, in);
            case AxiomKind::datatype_definition:
                return true;
            case AxiomKind::rule:
                return rule(*axiom.rule, in);
        }
        return true;
    }

private:
    /// Equal for structurally equal expressions: operands and individuals are sets.
    static std::string structure(const ClassExpression& expression) {
        std::set<std::string> operands(expression.individuals.begin(), expression.individuals.end());
        for (const ClassPointer& operand : expression.operands) operands.insert(structure(*operand));
        ClassExpression head = expression;
        head.operands.clear();
        if (!expression.operands.empty()) head.kind = ClassKind::named;
        std::string text = std::to_string(static_cast<int>(expression.kind));
        text.append(head.kind == ClassKind::named ? head.iri : to_manchester(head)).append(head.property.iri);
        text.append(head.property.inverse ? "-" : "+").append(std::to_string(head.number)).append("(");
        for (const std::string& operand : operands) text.append(operand).append(" ");
        return text.append(")");
    }

    static bool same(const ClassExpression& a, const ClassExpression& b) { return structure(a) == structure(b); }

    static bool is_top(const PropertyExpression& property) {
        return word_of(property.iri) == Word::owl_topDataProperty;
    }

    static Set value(const Literal& literal) {
        for (unsigned i = 0; i < std::size(values); ++i)
            if (values[i] == std::stoi(literal.value)) return 1U << i;
        return 0;
    }

    void note_known(const DataRange& range) {
        for (const Literal& literal : range.values) known_ |= value(literal);
        for (const DataRange& operand : range.operands) note_known(operand);
    }

    void note_known(const ClassExpression& expression) {
        note_known(expression.range);
        for (const ClassPointer& operand : expression.operands) note_known(*operand);
    }

    void note_known(const Axiom& axiom) {
        for (const ClassPointer& expression : axiom.classes) note_known(*expression);
        note_known(axiom.range);
        if (axiom.kind == AxiomKind::data_property_assertion ||
            axiom.kind == AxiomKind::negative_data_property_assertion)
            known_ |= value(axiom.literal);
        if (axiom.rule == nullptr) return;
        for (const auto* side : {&axiom.rule->body, &axiom.rule->head})
            for (const RuleAtom& atom : *side) {
                note_known(atom.range);
                if (atom.klass != nullptr) note_known(*atom.klass);
                if (atom.kind == RuleAtom::Kind::data_property && atom.arguments[1].kind == RuleTerm::Kind::literal)
                    known_ |= value(atom.arguments[1].literal);
            }
    }

    [[nodiscard]] Set inside(const DataRange& range) const {
        Set result = 0;
        const Set all_values = (1U << value_count_) - 1;
        switch (range.kind) {
            case DataRangeKind::datatype:
                if (local_name(range.datatype) == "Literal") return all_values;
                for (unsigned i = 0; i < value_count_; ++i) {
                    bool fits = values[i] != no_integer;
                    for (const auto& [facet, literal] : range.facets) {
                        const int bound = std::stoi(literal.value);
                        const std::string name = local_name(facet);
                        fits = fits && (name == "minInclusive"   ? values[i] >= bound
                                        : name == "minExclusive" ? values[i] > bound
                                        : name == "maxInclusive" ? values[i] <= bound
                                                                 : values[i] < bound);
                    }
                    if (fits) result |= 1U << i;
                }
                return result;
            case DataRangeKind::one_of:
                for (const Literal& literal : range.values) result |= value(literal);
                return result;
            case DataRangeKind::complement_of:
                return all_values & ~inside(range.operands[0]);
            case DataRangeKind::intersection_of:
                return inside(range.operands[0]) & inside(range.operands[1]);
            case DataRangeKind::union_of:
                return inside(range.operands[0]) | inside(range.operands[1]);
        }
        return result;
    }

    static bool relates(const PropertyExpression& property, unsigned a, unsigned b, const Interpretation& in) {
        if (property.inverse) std::swap(a, b);
        return ((in.properties.at(property.iri)[a] >> b) & 1U) != 0;
    }

    static Set data_of(const Iri& property, unsigned a, const Interpretation& in) { return in.data.at(property)[a]; }

    static bool chain(const Axiom& axiom, const Interpretation& in) {
        for (unsigned a = 0; a < in.elements; ++a) {
            Set reached = 1U << a;
            for (std::size_t i = 0; i + 1 < axiom.properties.size(); ++i) {
                Set next = 0;
                for (unsigned b = 0; b < in.elements; ++b)
                    for (unsigned c = 0; c < in.elements; ++c)
                        if (((reached >> b) & 1U) != 0 && relates(axiom.properties[i], b, c, in)) next |= 1U << c;
                reached = next;
            }
            for (unsigned c = 0; c < in.elements; ++c)
                if (((reached >> c) & 1U) != 0 && !relates(axiom.properties.back(), a, c, in)) return false;
        }
        return true;
    }

    [[nodiscard]] bool key(const Axiom& axiom, const Interpretation& in) const {
        const Set members = extension(*axiom.classes[0], in);
        for (unsigned a = 0; a < in.elements; ++a)
            for (unsigned b = 0; b < a; ++b) {
                bool agree = ((members >> a) & (members >> b) & 1U) != 0;
                for (const PropertyExpression& property : axiom.properties) {
                    bool shares = false;
                    if (ontology_.find(property.iri, EntityKind::data_property) != nullptr) {
                        shares = (data_of(property.iri, a, in) & data_of(property.iri, b, in)) != 0;
                    } else {
                        for (unsigned c = 0; c < in.elements; ++c)
                            shares = shares || (relates(property, a, c, in) && relates(property, b, c, in));
                    }
                    agree = agree && shares;
                }
                if (agree) return false;
            }
        return true;
    }

    [[nodiscard]] Set extension(const ClassExpression& expression, const Interpretation& in) const {
        Set result = 0;
        const auto filler = [&] { return extension(*expression.operands[0], in); };
        const auto collect = [&](const std::function<bool(unsigned)>& test) {
            for (unsigned a = 0; a < in.elements; ++a)
                if (test(a)) result |= 1U << a;
            return result;
        };
        const auto count = [&](unsigned a, Set among) {
            unsigned found = 0;
            for (unsigned b = 0; b < in.elements; ++b)
                found += ((among >> b) & 1U) != 0 && relates(expression.property, a, b, in);
            return found;
        };
        const auto data = [&](unsigned a) {
            return data_of(expression.property.iri, a, in) & inside(expression.range);
        };
        const auto data_count = [&](unsigned a) { return static_cast<unsigned>(std::popcount(data(a))); };
        const unsigned number = expression.number;
        switch (expression.kind) {
            case ClassKind::named:
                if (word_of(expression.iri) == Word::owl_Thing) return in.everything();
                if (word_of(expression.iri) == Word::owl_Nothing) return 0;
                return in.classes.at(expression.iri);
            case ClassKind::intersection_of:
                result = in.everything();
                for (const ClassPointer& operand : expression.operands) result &= extension(*operand, in);
                return result;
            case ClassKind::union_of:
                for (const ClassPointer& operand : expression.operands) result |= extension(*operand, in);
                return result;
            case ClassKind::complement_of:
                return in.everything() & ~filler();
            case ClassKind::one_of:
                for (const Iri& iri : expression.individuals) result |= 1U << in.element_of.at(iri);
                return result;
            case ClassKind::some_values_from: {
                const Set among = filler();
                return collect([&](unsigned a) { return count(a, among) > 0; });
            }
            case ClassKind::all_values_from: {
                const Set outside = in.everything() & ~filler();
                return collect([&](unsigned a) { return count(a, outside) == 0; });
            }
            case ClassKind::has_value: {
                const Set one = 1U << in.element_of.at(expression.individuals[0]);
                return collect([&](unsigned a) { return count(a, one) == 1; });
            }
            case ClassKind::has_self:
                return collect([&](unsigned a) { return relates(expression.property, a, a, in); });
            case ClassKind::min_cardinality: {
                const Set among = filler();
                return collect([&](unsigned a) { return count(a, among) >= number; });
            }
            case ClassKind::max_cardinality: {
                const Set among = filler();
                return collect([&](unsigned a) { return count(a, among) <= number; });
            }
            case ClassKind::exact_cardinality: {
                const Set among = filler();
                return collect([&](unsigned a) { return count(a, among) == number; });
            }
            case ClassKind::data_some_values_from:
            case ClassKind::data_has_value:
                return collect([&](unsigned a) { return data(a) != 0; });
            case ClassKind::data_all_values_from:
                return collect([&](unsigned a) { return data(a) == data_of(expression.property.iri, a, in); });
            case ClassKind::data_min_cardinality:
                return collect([&](unsigned a) { return data_count(a) >= number; });
            case ClassKind::data_max_cardinality:
                return collect([&](unsigned a) { return data_count(a) <= number; });
            case ClassKind::data_exact_cardinality:
                return collect([&](unsigned a) { return data_count(a) == number; });
        }
        return result;
    }

    using Assignment = std::map<Iri, unsigned>;

    [[nodiscard]] bool atom(const RuleAtom& atom, const Assignment& at, const Interpretation& in) const {
        const auto element = [&](std::size_t i) {
            const RuleTerm& term = atom.arguments[i];
            return term.kind == RuleTerm::Kind::variable ? at.at(term.iri) : in.element_of.at(term.iri);
        };
        const auto value_set = [&](std::size_t i) {
            const RuleTerm& term = atom.arguments[i];
            return term.kind == RuleTerm::Kind::variable ? 1U << at.at(term.iri) : value(term.literal);
        };
        switch (atom.kind) {
            case RuleAtom::Kind::of_class:
                return ((extension(*atom.klass, in) >> element(0)) & 1U) != 0;
            case RuleAtom::Kind::of_data_range:
                return (inside(atom.range) & value_set(0)) != 0;
            case RuleAtom::Kind::object_property:
                return relates(atom.property, element(0), element(1), in);
            case RuleAtom::Kind::data_property:
                return (data_of(atom.property.iri, element(0), in) & value_set(1)) != 0;
            case RuleAtom::Kind::same_as:
                return element(0) == element(1);
            case RuleAtom::Kind::different_from:
                return element(0) != element(1);
            case RuleAtom::Kind::built_in: {
                const auto number = [&](std::size_t i) {
                    const RuleTerm& term = atom.arguments[i];
                    return term.kind == RuleTerm::Kind::literal ? std::stoi(term.literal.value)
                                                                : values[at.at(term.iri)];
                };
                const int a = number(0), b = number(1);
                const std::string name = local_name(atom.iri);
                return name == "equal"             ? a == b
                       : name == "notEqual"        ? a != b
                       : name == "lessThan"        ? a < b
                       : name == "lessThanOrEqual" ? a <= b
                       : name == "greaterThan"     ? a > b
                                                   : a >= b;
            }
        }
        return true;
    }

    [[nodiscard]] bool rule(const Rule& rule, const Interpretation& in) const {
        std::map<Iri, int> kinds;  // 0: individuals, 1: values, 2: mentioned values
        for (const auto* side : {&rule.body, &rule.head})
            for (const RuleAtom& each : *side)
                for (std::size_t i = 0; i < each.arguments.size(); ++i) {
                    if (each.arguments[i].kind != RuleTerm::Kind::variable) continue;
                    int& kind = kinds[each.arguments[i].iri];
                    if (each.kind == RuleAtom::Kind::of_data_range ||
                        (each.kind == RuleAtom::Kind::data_property && i == 1))
                        kind = std::max(kind, 1);
                    if (each.kind == RuleAtom::Kind::built_in) kind = 2;
                }
        Assignment at;
        const std::function<bool(std::map<Iri, int>::const_iterator)> all = [&](auto variable) {
            if (variable == kinds.end()) {
                for (const RuleAtom& each : rule.body)
                    if (!atom(each, at, in)) return true;
                for (const RuleAtom& each : rule.head)
                    if (!atom(each, at, in)) return false;
                return true;
            }
            const unsigned size = variable->second == 0 ? in.elements : value_count_;
            for (unsigned i = 0; i < size; ++i) {
                if (variable->second == 2 && ((known_ >> i) & 1U) == 0) continue;
                at[variable->first] = i;
                if (!all(std::next(variable))) return false;
            }
            return true;
        };
        return all(kinds.begin());
    }

    const Ontology& ontology_;
    unsigned value_count_;
    Set known_ = 0;
};

bool is_about_data(const ClassExpression& expression) {
    bool result = expression.kind >= ClassKind::data_some_values_from;
    for (const ClassPointer& operand : expression.operands) result = result || is_about_data(*operand);
    return result;
}

bool is_about_data(const Axiom& axiom) {
    bool result =
        (axiom.kind >= AxiomKind::sub_data_property_of && axiom.kind <= AxiomKind::functional_data_property) ||
        axiom.kind == AxiomKind::data_property_assertion || axiom.kind == AxiomKind::negative_data_property_assertion ||
        axiom.kind == AxiomKind::has_key || axiom.kind == AxiomKind::rule;
    for (const ClassPointer& each : axiom.classes) result = result || is_about_data(*each);
    return result;
}

/// Counts through all values of some binary digits; calls `step` with each, as long as it says so.
class Digits {
public:
    explicit Digits(std::size_t count) : end_(std::uint64_t{1} << count) {}
    template <class Step>
    void for_each(Step step) const {
        for (std::uint64_t i = 0; i < end_; ++i) step(i);
    }

private:
    std::uint64_t end_;
};

}  // namespace

ClosedAnswer ask(const knowledge::ClosedWorld& world) {
    std::vector<Iri> individuals = knowledge::individuals_of(world.ontology), classes, properties, data;
    for (const Entity& entity : world.ontology.entities) {
        if (entity.kind == EntityKind::klass) classes.push_back(entity.iri);
        if (entity.kind == EntityKind::object_property) properties.push_back(entity.iri);
        if (entity.kind == EntityKind::data_property) data.push_back(entity.iri);
    }
    const unsigned value_count = data.size() * individuals.size() > 1 ? many : few;
    const Evaluator evaluator(world.ontology, value_count);
    std::vector<const Axiom*> plain, about_data;
    for (const Axiom& axiom : world.ontology.axioms) (is_about_data(axiom) ? about_data : plain).push_back(&axiom);
    const auto hold = [&](const std::vector<const Axiom*>& axioms, const Interpretation& in) {
        for (const Axiom* axiom : axioms)
            if (!evaluator.holds(*axiom, in)) return false;
        return true;
    };

    ClosedAnswer answer;
    std::set<std::string> refuted;  // false in some model
    const auto note_model = [&](const Interpretation& in) {
        answer.consistent = true;
        for (const Iri& a : individuals) {
            const unsigned from = in.element_of.at(a);
            for (const Iri& c : classes) {
                const std::string name = fact(c, a);
                answer.entailed.insert(name);
                if (((in.classes.at(c) >> from) & 1U) == 0) refuted.insert(name);
            }
            for (const Iri& b : individuals) {
                for (const Iri& p : properties) {
                    const std::string name = fact(p, a, b);
                    answer.entailed.insert(name);
                    if (((in.properties.at(p)[from] >> in.element_of.at(b)) & 1U) == 0) refuted.insert(name);
                }
                if (a >= b) continue;
                const std::string name = local_name(a).append("=").append(local_name(b));
                answer.entailed.insert(name);
                if (from != in.element_of.at(b)) refuted.insert(name);
            }
        }
    };

    for (unsigned elements = 1; elements <= individuals.size();
         ++elements) {  // two individuals at most: one or two elements
        Interpretation in;
        in.elements = elements;
        for (unsigned i = 0; i < individuals.size(); ++i) in.element_of[individuals[i]] = std::min(i, elements - 1);
        if (elements < individuals.size() && world.individuals.size() > 1) continue;
        Digits(classes.size() * elements + properties.size() * elements * elements).for_each([&](std::uint64_t digits) {
            const auto take = [](std::uint64_t& from, unsigned count) {
                const auto taken = static_cast<Set>(from & ((std::uint64_t{1} << count) - 1));
                from >>= count;
                return taken;
            };
            for (const Iri& iri : classes) in.classes[iri] = take(digits, elements);
            for (const Iri& iri : properties) {
                in.properties[iri].resize(elements);
                for (Set& row : in.properties[iri]) row = take(digits, elements);
            }
            if (!hold(plain, in)) return;
            bool is_found = false;
            Digits(data.size() * elements * value_count).for_each([&](std::uint64_t more) {
                if (is_found) return;
                for (const Iri& iri : data) {
                    in.data[iri].resize(elements);
                    for (Set& row : in.data[iri]) row = take(more, value_count);
                }
                is_found = hold(about_data, in);
            });
            if (is_found) note_model(in);
        });
    }
    for (const std::string& name : refuted) answer.entailed.erase(name);
    return answer;
}

}  // namespace closed_oracle
