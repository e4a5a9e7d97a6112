#include "owl/declarations.h"

#include <algorithm>
#include <optional>

#include "base/errors.h"
#include "base/spelling.h"

namespace partonomy::owl {
namespace {

/// What `x rdf:type word` declares x to be. The characteristics that only object properties have declare one, as in
/// OWL 1.
std::optional<EntityKind> declared_by(Word word) {
    switch (word) {
        case Word::owl_Class:
        case Word::rdfs_Class:
        case Word::owl_DeprecatedClass:
            return EntityKind::klass;
        case Word::owl_ObjectProperty:
        case Word::owl_InverseFunctionalProperty:
        case Word::owl_TransitiveProperty:
        case Word::owl_SymmetricProperty:
        case Word::owl_AsymmetricProperty:
        case Word::owl_ReflexiveProperty:
        case Word::owl_IrreflexiveProperty:
            return EntityKind::object_property;
        case Word::owl_DatatypeProperty:
            return EntityKind::data_property;
        case Word::owl_AnnotationProperty:
        case Word::owl_OntologyProperty:
            return EntityKind::annotation_property;
        case Word::owl_NamedIndividual:
            return EntityKind::individual;
        case Word::rdfs_Datatype:
        case Word::owl_DataRange:
            return EntityKind::datatype;
        default:
            return std::nullopt;
    }
}

const std::string also_called = std::string(core_prefix) + "alsoCalled";
const std::string converse = std::string(core_prefix) + "converse";

}  // namespace

Declarations::Declarations() {
    const auto declare = [this](EntityKind kind, const char* prefix, std::initializer_list<const char*> names) {
        for (const char* name : names) add(std::string(prefix) + name, kind);
    };
    declare(EntityKind::klass, owl_prefix, {"Thing", "Nothing"});
    declare(EntityKind::object_property, owl_prefix, {"topObjectProperty", "bottomObjectProperty"});
    declare(EntityKind::data_property, owl_prefix, {"topDataProperty", "bottomDataProperty"});
    declare(EntityKind::annotation_property, rdfs_prefix, {"label", "comment", "seeAlso", "isDefinedBy"});
    declare(EntityKind::annotation_property, owl_prefix,
            {"deprecated", "versionInfo", "versionIRI", "priorVersion", "backwardCompatibleWith", "incompatibleWith"});
    declare(EntityKind::datatype, owl_prefix, {"real", "rational"});
    declare(EntityKind::datatype, rdf_prefix, {"PlainLiteral", "XMLLiteral", "langString"});
    declare(EntityKind::datatype, rdfs_prefix, {"Literal"});
    declare(EntityKind::datatype, xsd_prefix,
            {"string", "normalizedString", "token", "language", "Name", "NCName", "NMTOKEN", "boolean", "hexBinary",
             "base64Binary", "anyURI", "dateTime", "dateTimeStamp", "date", "time"});
    for (const char* name : numeric_datatypes) add(std::string(xsd_prefix) + name, EntityKind::datatype);
    for (auto& [iri, kinds] : kinds_) kinds |= built_in;
}

bool Declarations::has(const Iri& iri, EntityKind kind) const {
    const auto found = kinds_.find(iri);
    return found != kinds_.end() && (found->second >> static_cast<unsigned>(kind) & 1U) != 0;
}

void Declarations::collect(const Graph& graph, std::vector<Entity>& entities) {
    for (const Triple& triple : graph.triples) {
        const Term& subject = graph.terms[triple.subject];
        if (subject.kind != TermKind::iri) continue;
        if (const Term& object = graph.terms[triple.object]; object.kind == TermKind::literal) {
            const Iri& property = graph.terms[triple.predicate].value;
            if (property == also_called || property == converse)
                other_names_.push_back({object.value, subject.value, property == converse});
            continue;
        }
        if (graph.terms[triple.predicate].word != Word::rdf_type) continue;
        const std::optional<EntityKind> kind = declared_by(graph.terms[triple.object].word);
        if (!kind) continue;
        const auto known = kinds_.find(subject.value);
        if (known != kinds_.end() && (known->second & built_in) != 0 && has(subject.value, *kind)) continue;
        add(subject.value, *kind);
        entities.push_back({*kind, subject.value, {graph.file, triple.line}});
        const auto refuse_both = [&](EntityKind one, EntityKind other, const char* what) {
            if (!has(subject.value, one) || !has(subject.value, other)) return;
            throw OntologyError(
                at(graph.file, triple.line,
                   local_name(subject.value) + " is declared both " + what + "; OWL 2 allows one of them"));
        };
        refuse_both(EntityKind::object_property, EntityKind::data_property, "an object property and a data property");
        refuse_both(EntityKind::klass, EntityKind::datatype, "a class and a datatype");
    }
}

std::string Declarations::suggestion(const Iri& iri, EntityKind kind) const {
    const std::string called = by_other_name(local_name(iri), kind);
    const bool is_sure = iri.starts_with(core_prefix) && !called.empty();
    const std::string spelled = is_sure ? "" : by_spelling(iri, kind);
    const char* both = spelled.empty() || called.empty() ? "" : ", or ";
    const std::string meant = spelled + both + called;
    return meant.empty() ? "" : between(" (did you mean ", meant, "?)");
}

std::string Declarations::by_other_name(const std::string& name, EntityKind kind) const {
    std::string terms;
    for (const OtherName& other : other_names_)
        if (has(other.of, kind) && is_spelled_alike(other.name, name)) {
            terms += (terms.empty() ? "core:" : " or core:") + local_name(other.of);
            if (other.is_converse) terms += ", with isTargetRegion and isReferenceRegion exchanged";
        }
    return terms;
}

std::string Declarations::by_spelling(const Iri& iri, EntityKind kind) const {
    const std::string name = local_name(iri);
    if (name.empty() || name.size() > 100) return {};
    std::size_t best = name.size() / 3 + 1;
    std::string nearest;
    // Of a property that is not declared, nothing but a guess tells whether it leads to numbers.
    const bool is_property = kind == EntityKind::object_property || kind == EntityKind::data_property;
    unsigned wanted = 1U << static_cast<unsigned>(kind);
    if (is_property)
        wanted = 1U << static_cast<unsigned>(EntityKind::object_property) |
                 1U << static_cast<unsigned>(EntityKind::data_property);
    std::vector<Iri> candidates;
    for (const auto& [candidate, kinds] : kinds_)
        if ((kinds & wanted) != 0 && candidate != iri) candidates.push_back(candidate);
    std::ranges::sort(candidates);
    for (const Iri& candidate : candidates) {
        const std::string other = local_name(candidate);
        constexpr std::size_t telling = 5;  // letters: a name that was cut short, or grew
        if (std::min(name.size(), other.size()) >= telling && best > 1 && other != name &&
            (other.starts_with(name) || name.starts_with(other))) {
            best = 1;
            nearest = other;
        }
        const std::size_t apart = other.size() > name.size() ? other.size() - name.size() : name.size() - other.size();
        if (apart >= best || other.size() > 150) continue;
        const std::size_t distance = edit_distance(name, other);
        if (distance < best) {
            best = distance;
            nearest = other != name                        ? other
                      : candidate.starts_with(core_prefix) ? "core:" + other
                                                           : between("<", candidate, ">");
        }
    }
    return nearest;
}

std::vector<Iri> Declarations::names_of_core(EntityKind kind) const {
    std::vector<Iri> names;
    for (const auto& [iri, kinds] : kinds_)
        if ((kinds >> static_cast<unsigned>(kind) & 1U) != 0 && iri.starts_with(core_prefix)) names.push_back(iri);
    std::ranges::sort(names);
    return names;
}

}  // namespace partonomy::owl
