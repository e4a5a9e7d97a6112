#pragma once

#include <algorithm>
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "knowledge/closed_world.h"
#include "knowledge/data_cells.h"

// Inside the closed-world reasoner: the machine that turns axioms into clauses. Its parts are in closed_atoms.cpp,
// closed_expressions.cpp, closed_data_names.cpp, closed_data.cpp, closed_axioms.cpp, closed_properties.cpp and
// closed_rules.cpp.

namespace partonomy::knowledge::closed {

/// Names and their numbers, in the order of first mention.
struct Names {
    std::vector<Iri> iris;
    std::unordered_map<Iri, int> ids;

    int add(const Iri& iri);
    [[nodiscard]] std::size_t size() const { return iris.size(); }
    [[nodiscard]] std::vector<Iri> sorted() const;
};

/// Drops repetitions from `first` on: where OWL 2 has sets, to say the same thing twice says nothing more.
template <class Thing>
void make_set(std::vector<Thing>& things, std::ptrdiff_t first) {
    std::sort(things.begin() + first, things.end());
    things.erase(std::unique(things.begin() + first, things.end()), things.end());
}

/// An object property or its inverse; or the one that relates everything (top) or nothing (bottom).
struct Property {
    static constexpr int top = -1, bottom = -2;
    int id = bottom;
    bool inverse = false;
    auto operator<=>(const Property&) const = default;
};

/// A class expression, each different one once.
struct Expression {
    owl::ClassKind kind;
    int name = 0;  ///< class (everything, nothing) or data property (Property::top, bottom)
    Property property;
    std::uint32_t number = 0;
    std::vector<int> operands;
    std::vector<int> individuals;
    int range = -1;             ///< of a restriction of a data property
    std::vector<int> literals;  ///< by individual; 0 while nobody has asked
};

/// Data properties that depend on each other, with the literals that they can have: `values` are enough of each cell
/// that whenever there is a model, one has the same classes, relations and mentioned values and no other literals.
struct DataGroup {
    explicit DataGroup(const DataCells::Definitions& definitions) : cells(definitions) {}

    /// A restriction that asks whether a property has `count` values in a range.
    struct Need {
        int property, range;
        std::uint64_t count;
    };
    DataCells cells;
    std::vector<Need> needs;
    bool is_shared = false;                ///< a key or rule compares values of different individuals
    const owl::Axiom* axiom = nullptr;     ///< the first that needs it, for error sentences
    std::vector<std::size_t> values;       ///< the cell of each value
    std::vector<std::size_t> first_value;  ///< by cell
};

class Grounder {
public:
    static constexpr int everything = -1, nothing = -2;  ///< owl:Thing, owl:Nothing

    Grounder(ClosedWorld world, const GroundOptions& options, std::vector<owl::ClassPointer> questions);
    Grounder(const Grounder&) = delete;  // definitions_ and the expressions point into `world`
    Grounder& operator=(const Grounder&) = delete;

    // closed_atoms.cpp: literals of names
    [[nodiscard]] int class_atom(int klass, int individual);
    [[nodiscard]] int property_atom(Property property, int subject, int object);
    /// Individuals that `subject` may be related to; ascending.
    [[nodiscard]] const std::vector<int>& candidates(Property property, int subject) const;
    [[nodiscard]] int data_atom(int property, int individual, std::size_t value);
    [[nodiscard]] int equality(int a, int b) const;

    // closed_expressions.cpp
    [[nodiscard]] Property property_of(const owl::PropertyExpression& expression);
    [[nodiscard]] int intern(const owl::ClassExpression& expression);
    [[nodiscard]] int holds(int expression, int individual);

    // closed_data.cpp
    [[nodiscard]] std::optional<int> value_atom(int property, int individual, const owl::Literal& literal);

    ClosedWorld world;
    GroundOptions options;
    std::vector<owl::ClassPointer> questions;
    Clauses clauses;
    std::vector<int> selectors;
    Names individuals, classes, properties, data_properties;

private:
    friend class RuleGrounder;

    // closed_atoms.cpp
    struct Atom {
        enum class Kind { klass, property, data } kind;
        int name, subject;
        int other;  ///< object or value
    };
    void make_equalities();
    void learn_known();
    [[nodiscard]] int& slot(const Atom& atom);
    [[nodiscard]] int atom(const Atom& atom);
    void respect_equalities();
    /// True when no name before this one means the same individual, so that each individual counts once.
    [[nodiscard]] int is_first(int individual);

    // closed_expressions.cpp
    [[nodiscard]] int intern(const owl::ClassPointer& expression);
    [[nodiscard]] int make_literal(const Expression& expression, int individual);
    [[nodiscard]] int some_related(Property property, int filler, int individual);
    [[nodiscard]] int at_least_related(Property property, int filler, int individual, std::uint64_t count);

    // closed_data_names.cpp: which data properties depend on each other, and what is said of their values
    [[nodiscard]] int data_property_of(const owl::PropertyExpression& expression);
    [[nodiscard]] bool is_data_property(const owl::PropertyExpression& property) const;
    void collect_data(const owl::Axiom& axiom);
    void collect_rule_data(const owl::Rule& rule);
    void collect_restriction(const Expression& expression);
    void mention(int property, const owl::Literal& literal);
    void mention(int property, int range, std::uint64_t count);
    void join(const std::vector<int>& joined);
    [[nodiscard]] int root_of(int property);
    void choose_values();

    // closed_data.cpp: literals about values
    [[nodiscard]] int range_id(const owl::DataRange& range);
    [[nodiscard]] int complement_id(int range);
    [[nodiscard]] DataGroup& group_of(int property) { return *groups_.at(root_of(property)); }
    [[nodiscard]] const std::vector<std::size_t>& values_in(int property, int range);
    [[nodiscard]] int some_value(int property, int individual, int range);
    [[nodiscard]] int at_least_values(int property, int individual, int range, std::uint64_t count);
    [[nodiscard]] int any_between(int property, int individual, std::size_t begin, std::size_t end);
    [[nodiscard]] std::uint64_t literals_in(int range) const;
    [[nodiscard]] bool has_literal(const owl::DataRange& range, const owl::Literal& literal) const;

    // closed_axioms.cpp
    template <class Step>
    void with_place(const owl::Axiom* axiom, Step step);
    void collect(const owl::Axiom& axiom);
    void ground(const owl::Axiom& axiom);
    void ground_class_axiom(const owl::Axiom& axiom);
    void ground_assertion(const owl::Axiom& axiom);
    void require(std::vector<int> literals);  ///< a clause of the axiom being grounded
    void require_at_most_one(const std::vector<int>& literals);
    void expect_clauses(double count) const;

    // closed_properties.cpp
    void ground_object_property(const owl::Axiom& axiom);
    void ground_data_property(const owl::Axiom& axiom);
    void ground_chain(std::vector<Property> chain, Property whole);
    void ground_key(const owl::Axiom& axiom);

    // closed_rules.cpp
    void ground_rule(const owl::Rule& rule);

    int count_ = 0;     ///< individuals
    int always_ = 0;    ///< the constant
    int selector_ = 0;  ///< of the axiom being grounded
    const owl::Axiom* axiom_ = nullptr;

    /// ClosedWorld::Known of one property.
    struct KnownProperty {
        std::vector<char> is_among;                ///< by individual
        std::vector<std::vector<int>> related[2];  ///< [inverse][individual]
        std::vector<int> others;                   ///< individuals that are not among them
    };
    std::unordered_map<int, KnownProperty> known_;  ///< by property; only looked up
    std::vector<int> everybody_;

    std::vector<std::vector<int>> class_atoms_;                  ///< by class, individual
    std::vector<std::vector<std::vector<int>>> property_atoms_;  ///< by property, subject, object
    std::vector<std::vector<std::vector<int>>> data_atoms_;      ///< by data property, subject, value
    std::vector<std::vector<int>> possibly_same_;                ///< by individual: the others that it may be
    std::vector<std::vector<int>> equalities_;                   ///< in step with possibly_same_
    std::vector<Atom> new_atoms_;                                ///< whose equals are still to be told
    bool is_respecting_ = false;

    std::vector<Expression> expressions_;
    std::map<std::vector<std::int64_t>, int> expression_ids_;
    std::unordered_map<const owl::ClassExpression*, int> pointer_ids_;
    bool is_collecting_ = true;

    DataCells::Definitions definitions_;
    std::map<owl::DataRange, int> range_ids_;
    std::vector<const owl::DataRange*> ranges_;
    int thing_ = 0;                                     ///< the expression owl:Thing
    int all_literals_ = 0;                              ///< the range rdfs:Literal
    std::vector<int> parents_;                          ///< by data property: a forest whose trees are the groups
    std::map<int, std::unique_ptr<DataGroup>> groups_;  ///< by root
    std::vector<DataGroup::Need> needs_;
    std::vector<const owl::Axiom*> need_axioms_;
    std::vector<int> shared_;                                            ///< data properties
    std::map<std::pair<int, int>, std::vector<std::size_t>> values_in_;  ///< by root and range
    std::map<std::pair<int, int>, std::vector<int>> any_trees_;          ///< by data property, individual
    std::map<std::vector<int>, std::vector<int>> compositions_;          ///< see ground_chain
};

}  // namespace partonomy::knowledge::closed
