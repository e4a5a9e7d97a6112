#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "knowledge/configuration_set.h"
#include "knowledge/diagram.h"
#include "owl/ontology.h"

namespace partonomy::knowledge {

using owl::Iri;

/// Handles into the vectors of a Domain or a Space.
using VariableId = int;
using ValueId = int;
using ConceptId = int;

/// One trapezoid over one measurement, from core:criterion, or core:measure and core:membership.
struct Criterion {
    std::string measure;
    double a1, a2, a3, a4;
};

/// A value of a range concept: Board, Vertical, Up …
struct ElementaryConcept {
    Iri iri;
    std::vector<Criterion> criteria;  ///< all must hold, the lowest score counts; empty: no algorithm from annotations
    std::optional<double> cost;
    std::string question;  ///< core:question, may be empty
};

/// A kind of feature: Shape, Orientation …
struct RangeConcept {
    Iri iri;
    Iri property;  ///< the functional property that leads to it
    std::vector<ElementaryConcept> values;
    bool covered = false;  ///< declared the (disjoint) union of its values; otherwise "other" completes it
};

/// A data property whose value is measured (core:measure), cut into intervals at the numbers that axioms mention.
struct MeasuredProperty {
    Iri iri;
    std::string measure;  ///< empty: no algorithm, restrictions on it stay open
    struct Interval {
        double low, high;  ///< -inf, inf when unbounded
        bool low_closed, high_closed;
        [[nodiscard]] bool has(double x) const;
    };
    std::vector<Interval> intervals;  ///< ascending, disjoint, covering the line
};

/// A relation between regions: UpFrom, Between …
struct Relation {
    Iri iri;
    std::size_t arity = 2;            ///< regions that it links, the target included: 2 or 3
    std::vector<Criterion> criteria;  ///< all must hold, the lowest score counts; empty: nothing can answer it
    std::optional<double> cost;
    std::string question;  ///< core:question, may be empty
};

/// What a class expression says of one relation node (N-ary Relation pattern): of which relation it is, and what the
/// regions are that it links.
struct NodeTest {
    enum class Kind { relation, references, target, all, any, no };
    Kind kind = Kind::all;
    std::vector<char> relations;     ///< relation: which of Domain::relations
    unsigned threshold = 1;          ///< references: at least so many are in the class
    std::size_t part_class = 0;      ///< references, target: into RelationalFeature::classes
    std::vector<NodeTest> operands;  ///< all, any, no
};

/// A feature of a region that is a relation to others: "is the target of at least one node that is UpFrom and has a
/// Seat as reference".
struct RelationalFeature {
    bool of_target = true;   ///< the region is the target of the nodes, else one of their references
    unsigned threshold = 1;  ///< at least so many nodes pass the test
    NodeTest test;
    std::vector<ConfigurationSet> classes;  ///< configurations of the regions that the test speaks of
    owl::ClassPointer as_written;
};

enum class VariableKind {
    range,      ///< one value of a range concept
    number,     ///< one interval of a measured property
    relation,   ///< a relation to other regions, that holds or not (yes is value 0)
    open,       ///< a restriction that no question is about, such as "inverse hasPart some Chair": yes or no
    primitive,  ///< a named concept without sufficient conditions: holds or not, no question can tell
    parts,      ///< of an object or a composite part: has it at least `threshold` parts of a class
};

/// A feature of a region or of an object with its finitely many values; exactly one holds.
struct Variable {
    VariableKind kind;
    Iri iri;  ///< of the range concept, data property or concept; empty for `parts` and `relation`
    std::vector<std::string>
        values;                    ///< local names or words: "Board", "other", "<= 0.55", "yes"/"no" (yes is value 0)
    int index = -1;                ///< into Domain::ranges, Domain::numbers or Domain::relational, for those kinds
    owl::ClassPointer part_class;  ///< for `parts`; for `relation` and `open` the whole expression
    unsigned threshold = 0;        ///< for `parts`
    bool of_composites = false;    ///< for `parts`: the class is one of composite parts
    bool answerable = true;        ///< false for `open`, `primitive`, and for what has no measure
};

/// A named concept of a layer and the configurations in which it holds.
struct Concept {
    Iri iri;
    ConfigurationSet where;
    bool incompatible = false;  ///< below core:Incompatible
    bool provable = true;       ///< has sufficient conditions
    bool relational = false;    ///< of a region: its definition rests on relations to other regions
};

/// The set Ω of all configurations of one layer (paper §3.3.1): every choice of one value for each variable that the
/// axioms allow, impossible ones (an Incompatible concept holds) left out of `possible`.
struct Space {
    std::vector<Variable> variables;
    std::vector<std::vector<ConfigurationSet>> holds;  ///< [variable][value]
    std::vector<Concept> concepts;                     ///< sorted by IRI
    std::size_t size = 0;                              ///< configurations that satisfy the axioms, at most SIZE_MAX
    ConfigurationSet possible;                         ///< those in which no incompatible concept holds
    std::size_t product = 0;                           ///< size of the raw Cartesian product, at most SIZE_MAX
    /// Of a space with too many configurations to list; null otherwise.
    std::shared_ptr<const Diagram> diagram;
    /// Compiled: [number variable][value], the value lies at or below the upper end of this interval.
    std::vector<std::vector<ConfigurationSet>> up_to;

    [[nodiscard]] std::optional<ConceptId> find(const Iri& iri) const;
    [[nodiscard]] std::optional<VariableId> find_variable(const Iri& iri) const;
    [[nodiscard]] ConfigurationSet all() const;
    [[nodiscard]] ConfigurationSet none() const { return all().complement(); }
    [[nodiscard]] std::string product_text() const;  ///< exact, however large
};

/// Composite parts of one kind. Each is a largest connected set of regions that are in `regions`, or in composite parts
/// of lower layers that its concepts speak of (docs/ontology-meaning.md).
struct CompositeSpace {
    Space space;               ///< over its `parts` variables
    int layer = 2;             ///< 2: made of regions only; one more than the highest layer that it is made of
    ConfigurationSet regions;  ///< configurations of a region that belongs to such a composite part by itself
};

/// The axioms in the form in which they are evaluated; for compile, conclude and explain only (assembly.h).
struct Grounding;

/// How high objects of a class are, in metres (core:typicalHeight).
struct TypicalHeight {
    Iri iri;
    Criterion height;  ///< its measure is no word of the catalogue
};

/// What an ontology means for one domain: elementary concepts, and a space for each layer.
struct Domain {
    owl::Ontology ontology;
    std::vector<RangeConcept> ranges;
    std::vector<MeasuredProperty> numbers;
    std::vector<Relation> relations;
    std::vector<RelationalFeature> relational;
    Space regions;                           ///< layer S1: the configurations of one region
    std::vector<CompositeSpace> composites;  ///< each after those that it is made of; mostly none
    /// The highest layer (S2 without composite parts): every configuration of one object, over its `parts` variables.
    /// Listed when first asked for; annotating a mesh does without (Conclusions::objects). Throws OntologyError when
    /// there are too many.
    [[nodiscard]] const Space& objects() const;
    /// For each variable of an object the configurations of a region that count as such a part; same order. Empty set
    /// for primitive concepts and classes of composite parts.
    std::vector<ConfigurationSet> part_conditions;
    /// Configurations of a region on which composite parts hang, what belongs to them and what they count; without
    /// repetition.
    std::vector<ConfigurationSet> composite_conditions;
    /// Range concepts and their values, and relations, are in layer 0, named concepts over S0 in layer 1, those of
    /// composite parts in layer 2 or above, those of objects in object_layer(); -1 for anything else.
    [[nodiscard]] int layer(const Iri& iri) const;
    [[nodiscard]] int object_layer() const;
    /// Most specific of `iris`: those without a strict subclass among them; equivalent ones stay together. A diagnosis
    /// hides diagnoses only: a Chair that is FootIncompatibleFurnitures is both (paper Fig. 14).
    [[nodiscard]] std::vector<Iri> most_specific(const std::vector<Iri>& iris) const;
    /// All pairs (sub, super) of distinct satisfiable named concepts of the expert's layers such that sub is entailed
    /// to be below super; elementary concepts, range concepts, core:Feature, Region, Object and Incompatible included;
    /// sorted.
    [[nodiscard]] std::vector<std::pair<Iri, Iri>> hierarchy() const;
    /// Named concepts that no configuration satisfies.
    [[nodiscard]] std::vector<Iri> unsatisfiable() const;
    std::vector<TypicalHeight> typical_heights;  ///< by IRI
    bool is_about_scenes = false;                ///< core:isScene: meshes are cut as scenes (FindPartsOptions)
    std::vector<std::string> warnings;  ///< what a user should know of regions and composite parts: no algorithm …
    /// The same of objects; lists them.
    [[nodiscard]] std::vector<std::string> object_warnings() const;
    std::shared_ptr<const Grounding> grounding;  ///< set by compile; copies of a domain share it
};

/// Why the configurations of a space are not counted, in words; empty when they are.
[[nodiscard]] std::string why_not_counted(const Space& space);

struct CompileOptions {
    std::size_t configuration_limit = std::size_t{1} << 22;  ///< ways in which the parts of an object may combine
    std::size_t listing_limit = std::size_t{1} << 16;        ///< a larger product of a region's features is compiled
    DiagramOptions diagram;
};

/// Finds the layers, grounds the axioms over them, and builds the configuration spaces (design §5, §6; paper §3.2.4,
/// §3.3.1). Throws OntologyError naming axiom, file and line: a construct that cannot be grounded, a definition that
/// runs in a circle, a trapezoid out of order, no object concept, an inconsistent layer, too many configurations.
[[nodiscard]] Domain compile(owl::Ontology ontology, const CompileOptions& options = {});

}  // namespace partonomy::knowledge
