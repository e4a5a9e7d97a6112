// OWL/XML (W3C Recommendation, 11 December 2012). An element is a construct of functional syntax whose names and
// numbers stand in attributes; they are put where functional syntax has them, and each axiom that is complete is said
// as triples and forgotten. A triple stands on the line where the tag of its axiom begins. The prefixes that Prefix
// elements declare and xml:base hold for the whole document. Linear in the length of the text after entities are
// expanded.

#include "owl/owl_xml.h"

#include <cstring>
#include <map>

#include "base/errors.h"
#include "owl/structural.h"

namespace partonomy::owl {
namespace {

constexpr const char* xml_prefix = "http://www.w3.org/XML/1998/namespace";

/// The attributes of an element of OWL/XML. Null where there is none.
struct Attributes {
    const char* iri = nullptr;
    const char* abbreviated_iri = nullptr;
    const char* node_id = nullptr;
    const char* datatype = nullptr;
    const char* language = nullptr;
    const char* cardinality = nullptr;
    const char* facet = nullptr;
    const char* name = nullptr;
    const char* ontology_iri = nullptr;
    const char* version_iri = nullptr;
};

class OwlXmlReader final : public XmlHandler {
public:
    OwlXmlReader(const XmlParser& parser, std::string base, Graph& graph)
        : parser_(parser), reader_(graph), owl_(owl_prefix) {
        bases_.push_back(std::move(base));
        for (const auto& [name, iri] : {std::pair{"owl", owl_prefix}, std::pair{"rdf", rdf_prefix},
                                        std::pair{"rdfs", rdfs_prefix}, std::pair{"xsd", xsd_prefix}}) {
            prefixes_[name] = iri;
        }
    }

    void start(const std::string& name, const char** pairs) override;
    void end() override;
    void characters(const char* text, std::size_t length) override;

private:
    Attributes attributes(const char** pairs);
    void start_ontology(const Attributes& given);
    void open(const std::string& name, const Attributes& given);
    [[nodiscard]] Iri abbreviated(const std::string& name) const;
    /// The IRI that IRI= or abbreviatedIRI= gives; false when there is neither.
    bool named(const Attributes& given, Iri& iri) const;
    void close(Construct&& construct);
    [[nodiscard]] static Construct iri_part(const Iri& iri, long line) {
        return {Construct::Kind::iri, {}, iri, {}, {}, line};
    }

    const XmlParser& parser_;
    StructuralReader reader_;
    const std::string owl_;
    std::map<std::string, std::string> prefixes_;
    std::vector<std::string> bases_;      ///< of the open elements and of the document
    std::vector<std::string> languages_;  ///< of the open elements
    std::vector<Construct> open_;         ///< below the Ontology
    bool in_ontology_ = false;
};

Attributes OwlXmlReader::attributes(const char** pairs) {
    Attributes given;
    bases_.push_back(bases_.back());
    languages_.push_back(languages_.empty() ? std::string() : languages_.back());
    for (; *pairs != nullptr; pairs += 2) {
        const std::string_view name = pairs[0];
        const char* value = pairs[1];
        if (name.starts_with(xml_prefix)) {
            const std::string_view local = name.substr(std::strlen(xml_prefix));
            if (local == "base") bases_.back() = resolve_iri(bases_.back(), value);
            if (local == "lang") languages_.back() = value;
            continue;
        }
        const std::pair<const char*, const char**> known[] = {
            {"IRI", &given.iri},
            {"abbreviatedIRI", &given.abbreviated_iri},
            {"nodeID", &given.node_id},
            {"datatypeIRI", &given.datatype},
            {"cardinality", &given.cardinality},
            {"facet", &given.facet},
            {"name", &given.name},
            {"ontologyIRI", &given.ontology_iri},
            {"versionIRI", &given.version_iri},
        };
        for (const auto& [wanted, slot] : known) {
            if (name == wanted) *slot = value;
        }
    }
    return given;
}

Iri OwlXmlReader::abbreviated(const std::string& name) const {
    const std::size_t colon = name.find(':');
    const auto prefix = colon == std::string::npos ? prefixes_.end() : prefixes_.find(name.substr(0, colon));
    if (prefix == prefixes_.end()) {
        parser_.fail("the prefix of '" + name + "' is not declared; add a Prefix element at the head of the ontology");
    }
    return prefix->second + name.substr(colon + 1);
}

bool OwlXmlReader::named(const Attributes& given, Iri& iri) const {
    if (given.iri != nullptr) iri = resolve_iri(bases_.back(), given.iri);
    if (given.abbreviated_iri != nullptr) iri = abbreviated(given.abbreviated_iri);
    return given.iri != nullptr || given.abbreviated_iri != nullptr;
}

void OwlXmlReader::start_ontology(const Attributes& given) {
    in_ontology_ = true;
    reader_.ontology(given.ontology_iri != nullptr ? resolve_iri(bases_.back(), given.ontology_iri) : Iri(),
                     given.version_iri != nullptr ? resolve_iri(bases_.back(), given.version_iri) : Iri(),
                     parser_.line());
}

void OwlXmlReader::start(const std::string& full_name, const char** pairs) {
    if (!full_name.starts_with(owl_)) {
        parser_.fail("the element '" + full_name + "' is none of OWL/XML, whose namespace is <" + owl_ + ">");
    }
    const std::string name = full_name.substr(owl_.size());
    const Attributes given = attributes(pairs);
    if (!in_ontology_) return start_ontology(given);
    if (name == "Ontology") parser_.fail("an Ontology element stands inside another");
    if (open_.size() >= max_construct_depth) {
        parser_.fail("elements are nested more than " + std::to_string(max_construct_depth) + " deep");
    }
    open(name, given);
}

void OwlXmlReader::open(const std::string& name, const Attributes& given) {
    Construct construct;
    construct.name = name;
    construct.line = parser_.line();
    Iri iri;
    if (name == "Prefix") {
        if (given.name == nullptr || given.iri == nullptr) parser_.fail("Prefix wants the attributes name and IRI");
        prefixes_[given.name] = given.iri;
    } else if (is_typed_name(name)) {
        construct.kind = Construct::Kind::iri;
        if (!named(given, construct.value)) parser_.fail(name + " wants the attribute IRI or abbreviatedIRI");
    } else if (name == "IRI" || name == "AbbreviatedIRI") {
        construct.kind = Construct::Kind::iri;
    } else if (name == "AnonymousIndividual") {
        construct.kind = Construct::Kind::anonymous;
        if (given.node_id == nullptr) parser_.fail("AnonymousIndividual wants the attribute nodeID");
        construct.value = given.node_id;
        if (construct.value.starts_with("_:")) construct.value.erase(0, 2);
    } else if (name == "Literal") {
        construct.kind = Construct::Kind::literal;
        if (given.datatype != nullptr) construct.datatype = resolve_iri(bases_.back(), given.datatype);
        if (construct.datatype.empty() || construct.datatype == std::string(rdf_prefix) + "PlainLiteral" ||
            construct.datatype == std::string(rdf_prefix) + "langString") {
            construct.language = languages_.back();
            construct.datatype.clear();
        }
    } else if (name == "FacetRestriction") {
        if (given.facet == nullptr) parser_.fail("FacetRestriction wants the attribute facet");
        construct.parts.push_back(iri_part(resolve_iri(bases_.back(), given.facet), construct.line));
    } else if (name == "BuiltInAtom") {
        if (!named(given, iri)) parser_.fail("BuiltInAtom wants the attribute IRI or abbreviatedIRI");
        construct.parts.push_back(iri_part(iri, construct.line));
    } else if (given.cardinality != nullptr) {
        construct.parts.push_back({Construct::Kind::literal, {}, given.cardinality, {}, {}, construct.line});
    } else if (name.ends_with("Cardinality")) {
        parser_.fail(name + " wants the attribute cardinality");
    }
    open_.push_back(std::move(construct));
}

void OwlXmlReader::characters(const char* text, std::size_t length) {
    const bool takes_text = !open_.empty() && (open_.back().name == "Literal" || open_.back().name == "IRI" ||
                                               open_.back().name == "AbbreviatedIRI" || open_.back().name == "Import");
    if (takes_text) {
        open_.back().value.append(text, length);
    } else if (std::string_view(text, length).find_first_not_of(" \t\r\n") != std::string_view::npos) {
        parser_.fail("text stands where an element is expected");
    }
}

void OwlXmlReader::end() {
    bases_.pop_back();
    languages_.pop_back();
    if (open_.empty()) return;
    Construct construct = std::move(open_.back());
    open_.pop_back();
    close(std::move(construct));
}

void OwlXmlReader::close(Construct&& construct) {
    if (construct.kind != Construct::Kind::call && !construct.parts.empty()) {
        parser_.fail(construct.name + " holds no other element");
    }
    if (construct.name == "IRI" || construct.name == "AbbreviatedIRI" || construct.name == "Import") {
        std::string& text = construct.value;
        text.erase(0, std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        text.erase(text.find_last_not_of(" \t\r\n") + 1);
        const Iri iri = construct.name == "AbbreviatedIRI" ? abbreviated(text) : resolve_iri(bases_.back(), text);
        if (construct.name == "Import") {
            if (construct.parts.empty()) construct.parts.push_back(iri_part(iri, construct.line));
        } else {
            construct.value = iri;
            construct.name.clear();
        }
    }
    if (construct.name == "Prefix") return;
    if (construct.kind == Construct::Kind::literal) construct.name.clear();
    if (open_.empty()) return reader_.read(construct);
    Construct& parent = open_.back();
    if (construct.name == "FacetRestriction" && parent.name == "DatatypeRestriction") {
        for (Construct& part : construct.parts) parent.parts.push_back(std::move(part));
    } else {
        parent.parts.push_back(std::move(construct));
    }
}

}  // namespace

std::unique_ptr<XmlHandler> make_owl_xml_handler(const XmlParser& parser, const std::string& base, Graph& graph) {
    return std::make_unique<OwlXmlReader>(parser, base, graph);
}

}  // namespace partonomy::owl
