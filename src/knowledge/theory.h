#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knowledge/domain.h"

// Inside of the knowledge folder: an ontology as formulas over feature variables, part counts and concepts, and the two
// steps that turn them into configuration spaces. Everything that a user may have written wrongly is found by
// read_theory.

namespace partonomy::knowledge {

/// What a class expression speaks of. A *whole* has parts, and so far nothing else is known of it: a composite part
/// when it is itself a part of something, else an object.
enum class Level { unknown, feature, relation, region, whole, composite, object };

/// A term of the core ontology: core_term("Region").
[[nodiscard]] Iri core_term(const char* name);
/// Whether `iri` is core_term(name).
[[nodiscard]] bool is_core_term(const Iri& iri, std::string_view name);
[[nodiscard]] bool is_thing(const Iri& iri);
[[nodiscard]] bool is_nothing(const Iri& iri);

/// "file:line: <axiom> cannot be grounded: <why>; <what would be right>".
[[noreturn]] void refuse(const owl::Axiom& axiom, const std::string& why, const std::string& right);

/// "a Leg", "an Armrest".
[[nodiscard]] std::string with_article(const std::string& name);

using FormulaId = int;

/// A node of a formula; nodes live in Theory::formulas and are never cyclic but through concepts.
struct Formula {
    enum class Kind { truth, falsity, conjunction, disjunction, negation, choice, named, parts };
    Kind kind = Kind::truth;
    int index = -1;                    ///< choice: feature variable; named: concept; parts: formula of the part class
    unsigned threshold = 0;            ///< parts: at least so many, >= 1
    ConfigurationSet values;           ///< choice: the values that make it true
    owl::ClassPointer part_class;      ///< parts: as written
    Level part_level = Level::region;  ///< parts: region or composite
    std::vector<FormulaId> operands;   ///< conjunction, disjunction, negation
};

struct NamedConcept {
    Iri iri;
    Level level = Level::unknown;  ///< region, composite or object
    bool incompatible = false;
    FormulaId definition = -1;  ///< -1: primitive
    std::size_t axiom = 0;      ///< that defines it
    int group = -1;             ///< composite: into Theory::groups; -1: says nothing of what its members consist of
    /// A restriction that is no question: it holds or not, and the closed world of a mesh may tell (mesh_world.h). Then
    /// the IRI is "~" and a number, which sorts after all names.
    owl::ClassPointer open = nullptr;
};

/// A kind of composite part: concepts that speak of the same groups. A group is a largest connected set of regions that
/// are in `regions`, or in a composite part that is in `composites`.
struct Group {
    FormulaId regions = 1;     ///< about a region
    FormulaId composites = 1;  ///< about a composite part of an earlier group
    std::vector<int> inner;    ///< groups whose composite parts may be in `composites`; ascending
};

/// A formula that holds in every configuration of its layer.
struct Constraint {
    Level level;
    std::size_t axiom;
    FormulaId formula;
};

struct Theory {
    std::vector<RangeConcept> ranges;
    std::vector<MeasuredProperty> numbers;
    std::vector<Relation> relations;
    std::vector<RelationalFeature> relational;               ///< their classes are filled last
    std::vector<std::vector<FormulaId>> relational_classes;  ///< [relational][class]: about a region
    std::vector<Formula> formulas;
    std::vector<NamedConcept> concepts;  ///< sorted by IRI
    std::vector<Constraint> constraints;
    std::vector<Group> groups;  ///< each after those that it is made of
    std::vector<std::string> warnings;
    /// Axioms that say more about a mesh than the formulas here do.
    std::vector<std::size_t> beyond;
    std::set<Iri> no_numbers;  ///< data properties of anything else than one measured number

    /// Feature variables: the ranges, then the numbers, then the relational ones.
    [[nodiscard]] std::size_t feature_count() const { return ranges.size() + numbers.size() + relational.size(); }
    [[nodiscard]] std::size_t value_count(std::size_t feature) const;
    [[nodiscard]] int find(const Iri& iri) const;  ///< concept, -1 when there is none
    /// Whether only the closed world of a mesh says all that the ontology says about it.
    [[nodiscard]] bool needs_world() const;
};

/// Range concepts in the order of their properties' range axioms, and measured properties by IRI, with their values,
/// intervals, criteria and costs. Throws OntologyError.
[[nodiscard]] std::vector<RangeConcept> find_ranges(const owl::Ontology& ontology);
/// Fills `no_numbers` with data properties without core:measure that axioms use in another way.
[[nodiscard]] std::vector<MeasuredProperty> find_numbers(const owl::Ontology& ontology, std::set<Iri>& no_numbers);
/// Classes below core:Relation that have no class below them, or criteria; in the order of their names.
[[nodiscard]] std::vector<Relation> find_relations(const owl::Ontology& ontology);
/// (sub, super) of all different classes below core:Relation, as told, that one included; sorted.
[[nodiscard]] std::vector<std::pair<Iri, Iri>> told_relations(const owl::Ontology& ontology);

/// core:typicalHeight of every class that has one, sorted.
[[nodiscard]] std::vector<TypicalHeight> find_typical_heights(const owl::Ontology& ontology);
/// Whether a class says core:isScene "true".
[[nodiscard]] bool is_about_scenes(const owl::Ontology& ontology);

/// The part of the number line that a data range allows, as cuts; throws OntologyError for what is no range of numbers.
/// `ends` is ascending and disjoint.
[[nodiscard]] std::vector<MeasuredProperty::Interval> number_range(const owl::DataRange& range,
                                                                   const owl::Axiom& axiom);

/// What each named class speaks of, found from the axioms alone. Classes that no axiom ties to anything are absent.
[[nodiscard]] std::map<Iri, Level> find_levels(const owl::Ontology& ontology, const std::vector<RangeConcept>& ranges);

[[nodiscard]] Level level_of(const owl::ClassExpression& expression, const std::map<Iri, Level>& levels,
                             const std::vector<RangeConcept>& ranges);

/// The surest of theirs: the first that is no mere whole.
[[nodiscard]] Level level_of_all(std::span<const owl::ClassPointer> expressions, const std::map<Iri, Level>& levels,
                                 const std::vector<RangeConcept>& ranges);

/// Whether a class is about neither regions nor objects, and nothing says what else it is for. `ontology` is plain.
[[nodiscard]] bool is_left_aside(const Theory& theory, const owl::Ontology& ontology,
                                 const std::map<Iri, Level>& levels, const Iri& iri);

/// The whole ontology as formulas. Throws OntologyError for what cannot be grounded.
[[nodiscard]] Theory read_theory(const owl::Ontology& ontology);

/// Which part of a theory to look at: explanations take axioms away and only need what the goal rests on.
struct Scope {
    std::vector<char> axioms;  ///< by axiom of the ontology: its definition or constraint counts
    std::vector<char>
        concepts;  ///< by concept: has a set in the layer; primitive when its defining axiom does not count
    std::vector<char> features;  ///< by feature variable: has a variable in the layer
};
[[nodiscard]] Scope whole_scope(const Theory& theory, std::size_t axiom_count);
/// The concepts and features that `goal` (a concept, -1 for none) and the counting constraints rest on. With
/// `all_features` every feature counts.
[[nodiscard]] Scope cone(const Theory& theory, int goal, std::vector<char> axioms, bool all_features);

/// A layer in the making, and when made.
struct Layer {
    Space space;  ///< variables, holds, size, product
    std::vector<ConfigurationSet>
        concepts;                 ///< by concept of the theory; of size 0 when out of scope or of another layer
    std::vector<int> features;    ///< variable of each feature, -1 when out of scope
    std::vector<int> primitives;  ///< variable of each concept, -1 when it has none
    std::vector<int> atoms;       ///< variable of each `parts` formula; -1: cannot hold
    std::vector<int> literals;    ///< of a compiled layer: of each formula, 0 for those that nobody asks for
};

/// The configurations in which `formula` holds. Concepts must have their sets already (see close_layer).
[[nodiscard]] ConfigurationSet evaluate(const Theory& theory, const Layer& layer, FormulaId formula);

/// What a layer is about: a region, the object, or a composite part of one group.
struct Subject {
    Level level = Level::object;
    int group = -1;
    /// Concepts of other groups hold for no composite part of this one.
    [[nodiscard]] bool has(const NamedConcept& named) const {
        return named.level == level && (named.group < 0 || named.group == group);
    }
};

/// Gives each concept of the subject's level its set, and packs the layer to the configurations that satisfy the
/// constraints. Returns those.
ConfigurationSet close_layer(const Theory& theory, const Scope& scope, Subject subject, Layer& layer);

/// Adds a yes/no variable for each open restriction, then for each primitive concept of the subject; returns how many.
std::size_t add_primitives(const Theory& theory, const Scope& scope, Subject subject, Layer& layer);

/// The configurations of one region, listed or compiled. Throws OntologyError when a limit of the diagram is reached
/// (no source: the caller adds it).
[[nodiscard]] Layer build_regions(const Theory& theory, const Scope& scope, const CompileOptions& options);
/// Fills the sets of a layer whose variables are there, over a diagram of all its configurations.
void compile_regions(const Theory& theory, const Scope& scope, const DiagramOptions& options, Layer& layer);
/// By concept: of a region, and there are features that prove it, whatever the concepts without definition are.
[[nodiscard]] std::vector<char> provable_regions(const Theory& theory, const Scope& scope);

/// How many parts of each class an object has, each count capped where more makes no difference, packed into one word.
using Counts = std::uint64_t;

/// The classes of parts that the concepts of an object, or of a composite part, count.
struct Parts {
    struct PartClass {
        ConfigurationSet where;                    ///< configurations of a region
        std::vector<ConfigurationSet> composites;  ///< by group: configurations of a composite part; mostly empty
        unsigned cap = 0;                          ///< highest threshold
        unsigned shift = 0;                        ///< of its count in Counts
    };
    struct Atom {
        std::size_t part;
        unsigned threshold;
        owl::ClassPointer as_written;
    };
    /// Configurations of a region that no part class tells apart.
    struct Type {
        std::vector<std::size_t> classes;
        ConfigurationSet where;
    };
    std::vector<PartClass> classes;
    std::vector<Atom> atoms;
    std::vector<int> atom_of;  ///< by formula; -1: cannot hold, or out of scope
    std::vector<Type> types;
    bool fits = true;  ///< Counts holds the counts of all classes; otherwise nothing below works

    [[nodiscard]] Counts add(Counts counts, const Type& type) const;
    /// All parts of both.
    [[nodiscard]] Counts sum(Counts a, Counts b) const;
    [[nodiscard]] bool holds(Counts counts, const Atom& atom) const;
};
/// The classes that `subject` counts. `groups`: the layers of the composite parts that there are so far, by group.
[[nodiscard]] Parts find_parts(const Theory& theory, const Scope& scope, Subject subject, const Layer& regions,
                               std::span<const Layer* const> groups = {});

[[nodiscard]] std::string too_many_classes(const Parts& parts);
/// The yes/no variable of an atom.
[[nodiscard]] Variable part_variable(const Parts::Atom& atom, bool of_composites);

/// Types that meet `regions`.
[[nodiscard]] std::vector<std::size_t> types_within(const Parts& parts, const ConfigurationSet& regions);
/// What `counts` may become with one more part of one of the types; ascending.
[[nodiscard]] std::vector<Counts> with_one_more(const Parts& parts, const std::vector<Counts>& counts,
                                                const std::vector<std::size_t>& types);
/// What `counts` may become with any number of more parts of the types; ascending. Throws OntologyError beyond `limit`.
[[nodiscard]] std::vector<Counts> with_any_more(const Parts& parts, const std::vector<Counts>& counts,
                                                const std::vector<std::size_t>& types, std::size_t limit);

/// The same for steps, each of which adds these counts.
[[nodiscard]] std::vector<Counts> with_any_steps(const Parts& parts, const std::vector<Counts>& counts,
                                                 const std::vector<Counts>& steps, std::size_t limit);

/// The counts of an object that consists of `regions`, each known to lie in its set. An empty set (a contradiction)
/// tells nothing about its region. Ascending.
[[nodiscard]] std::vector<Counts> reachable_counts(const Parts& parts, const std::vector<ConfigurationSet>& regions);

/// What an object can be that consists of `regions`, each known to lie in its set, and of any further parts unless
/// `complete`; without counting, as a solver tells (Diagram::sampled). `why` nothing is counted. For ontologies without
/// composite parts. Throws OntologyError when even that would take too much.
[[nodiscard]] Space objects_by_solver(const Theory& theory, const Scope& scope, const Parts& parts,
                                      const std::vector<ConfigurationSet>& regions, bool complete, std::string why);

struct ObjectLayer {
    Layer layer;
    std::vector<Counts> counts;    ///< ascending
    std::vector<std::size_t> row;  ///< of each of `counts`: which assignment of atoms it is
    std::vector<std::pair<std::size_t, std::size_t>> configurations;  ///< by row: first, and the one after the last

    /// The configurations that belong to any of `some`.
    [[nodiscard]] ConfigurationSet of(const std::vector<Counts>& some) const;
};
/// The configurations of an object, or of a composite part, whose part counts are among `counts`.
[[nodiscard]] ObjectLayer build_objects(const Theory& theory, const Scope& scope, Subject subject, const Parts& parts,
                                        std::vector<Counts> counts, std::size_t limit);

}  // namespace partonomy::knowledge
