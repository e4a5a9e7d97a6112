#pragma once

#include <string>
#include <vector>

#include "owl/statements.h"

namespace partonomy::owl {

/// A piece of functional syntax or of OWL/XML, which write the same constructs: SubClassOf(:Seat :Region).
struct Construct {
    enum class Kind {
        call,       ///< name: "SubClassOf"; parts
        group,      ///< ( … ) without a name, as in HasKey; parts
        iri,        ///< value; name: "Class" where the type is said, "Variable", else empty
        anonymous,  ///< value: the label
        literal,    ///< value, datatype (empty for none), language
    } kind = Kind::call;
    std::string name;
    std::string value;
    std::string datatype;
    std::string language;
    long line = 0;
    std::vector<Construct> parts = {};
};

inline constexpr int max_construct_depth = 500;

/// Whether constructs of that name are but a typed IRI: "Class", "Variable" …
[[nodiscard]] bool is_typed_name(const std::string& name);

/// Says an ontology in constructs as triples. Throws OntologyError for what is none of OWL 2's.
class StructuralReader {
public:
    explicit StructuralReader(Graph& graph) : graph_(graph), say_(graph) {}

    /// The ontology's IRI and version, empty for none. Once, before what is below.
    void ontology(const Iri& iri, const Iri& version, long line);
    /// An axiom, an import or an annotation of the ontology.
    void read(const Construct& construct);

private:
    void import(const Construct& construct);
    void declaration(const Construct& construct, std::size_t first, const std::vector<Note>& notes);
    void class_axiom(const Construct& axiom, std::size_t first, const std::vector<Note>& notes);
    void property_axiom(const Construct& axiom, std::size_t first, const std::vector<Note>& notes);
    void inverse_properties(const Construct& axiom, const Construct& first, const Construct& second,
                            const std::vector<Note>& notes);
    void assertion(const Construct& axiom, std::size_t first, const std::vector<Note>& notes);
    void annotation_axiom(const Construct& axiom, std::size_t first, const std::vector<Note>& notes);
    void has_key(const Construct& axiom, std::size_t first, const std::vector<Note>& notes);
    void rule(const Construct& axiom, std::size_t first, const std::vector<Note>& notes);
    Node atom(const Construct& construct);
    Node rule_argument(const Construct& construct);

    Node class_expression(const Construct& construct);
    Node restriction(const Construct& construct, bool over_data);
    Node data_range(const Construct& construct);
    Node object_property(const Construct& construct);
    Node data_property(const Construct& construct);
    Node annotation_property(const Construct& construct);
    Node individual(const Construct& construct);
    Node literal(const Construct& construct);
    Node entity(const Construct& construct, EntityKind kind);
    Node annotation_value(const Construct& construct);
    std::vector<Note> annotations(const Construct& construct, std::size_t& first);
    Note annotation(const Construct& construct);
    using Read = Node (StructuralReader::*)(const Construct&);
    std::vector<Node> each(const Construct& construct, std::size_t first, Read reader);

    /// Refuses a construct that has not as many parts from `first` on.
    void want(const Construct& construct, std::size_t first, std::size_t least, std::size_t most) const;
    [[noreturn]] void fail(const Construct& construct, const std::string& sentence) const;
    [[noreturn]] void misplaced(const Construct& construct, const std::string& wanted) const;

    Graph& graph_;
    Statements say_;
    Node ontology_ = 0;
};

}  // namespace partonomy::owl
