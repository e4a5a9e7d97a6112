// Imports, found offline: built in, by catalog, by content; cycles; and the sentence when there is nothing to find.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/errors.h"
#include "owl/ontology.h"

namespace partonomy::owl {
namespace {

namespace fs = std::filesystem;

class Imports : public testing::Test {
protected:
    void SetUp() override {
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder = fs::path(testing::TempDir()) / ("partonomy_imports_" + test);
        fs::remove_all(folder);
        fs::create_directories(folder / "deep");
    }
    void TearDown() override { fs::remove_all(folder); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }

    /// An ontology http://e/<iri> with a class of the same name and imports.
    static std::string text(const std::string& iri, const std::vector<std::string>& imports,
                            const std::string& more = "") {
        std::string turtle =
            "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n@prefix rdfs: "
            "<http://www.w3.org/2000/01/rdf-schema#> .\n@prefix e: <http://e/> .\n<http://e/" +
            iri + "> a owl:Ontology" + more + " .\n";
        for (const std::string& other : imports)
            turtle += "<http://e/" + iri + "> owl:imports <http://e/" + other + "> .\n";
        turtle += "e:C" + iri + " a owl:Class ; rdfs:subClassOf owl:Thing .\n";
        for (const std::string& other : imports) turtle += "e:C" + iri + " rdfs:subClassOf e:C" + other + " .\n";
        return turtle;
    }

    [[nodiscard]] std::string sentence(const std::string& name) const {
        try {
            (void)load_ontology(folder / name);
        } catch (const Error& error) {
            return error.what();
        }
        return "(no error)";
    }

    fs::path folder;
};

TEST_F(Imports, CoreIsBuiltIn) {
    const std::string header =
        "@prefix owl: <http://www.w3.org/2002/07/owl#> . <http://e/o> a owl:Ontology ; owl:imports <";
    for (const std::string iri : {core_iri, core_prefix}) {
        const Ontology ontology = parse_ontology(header + iri + "> .", "o.ttl");
        ASSERT_EQ(ontology.imports.size(), 1U);
        EXPECT_EQ(ontology.imports[0].first, iri);
        EXPECT_NE(ontology.find(std::string(core_prefix) + "Board", EntityKind::klass), nullptr);
        EXPECT_EQ(ontology.axioms.front().source.file, "core.ttl (built in)");
    }
    EXPECT_EQ(parse_ontology(header + core_iri + "> , <" + core_prefix + "> .", "o.ttl").imports.size(), 1U);
}

TEST_F(Imports, AnEditedCoreTakesThePlaceOfTheBuiltInOne) {
    const std::string edited = std::string(core_ontology_text()) + "\ncore:Edited a owl:Class .\n";
    const std::string importing =
        "@prefix owl: <http://www.w3.org/2002/07/owl#> . <http://e/o> a owl:Ontology ; owl:imports <" +
        std::string(core_iri) + "> .";
    write("o.ttl", importing);
    write("core.ttl", edited);
    write("deep/core.ttl", edited);
    const auto has_edited = [&](const Ontology& ontology) {
        return ontology.find(std::string(core_prefix) + "Edited", EntityKind::klass) != nullptr;
    };
    EXPECT_FALSE(has_edited(load_ontology(folder / "o.ttl"))) << "a file that merely lies beside is not taken";
    LoadOptions options;
    options.import_folders = {folder / "deep"};
    EXPECT_TRUE(has_edited(load_ontology(folder / "o.ttl", options)));
    write("catalog-v001.xml", "<catalog xmlns=\"urn:oasis:names:tc:entity:xmlns:xml:catalog\"><uri id=\"c\" name=\"" +
                                  std::string(core_iri) + "\" uri=\"core.ttl\"/></catalog>\n");
    EXPECT_TRUE(has_edited(load_ontology(folder / "o.ttl")));
    fs::remove(folder / "core.ttl");
    EXPECT_FALSE(has_edited(load_ontology(folder / "o.ttl"))) << "an entry whose file is gone is passed over";
}

TEST_F(Imports, CoreItselfIsReadOnce) {
    const Ontology alone = load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/core.ttl");
    EXPECT_EQ(alone.iri, core_iri);
    EXPECT_TRUE(alone.imports.empty());
    std::ofstream(folder / "core.ttl") << core_ontology_text() << "<" << core_iri << "> owl:imports <http://e/a> .\n";
    write("a.ttl", text("a", {}) + "<http://e/a> owl:imports <" + std::string(core_prefix) + "> .\n");
    const Ontology cycle = load_ontology(folder / "core.ttl");
    EXPECT_EQ(cycle.imports.size(), 1U);
    EXPECT_EQ(cycle.axioms.size(), alone.axioms.size() + 1);
}

TEST_F(Imports, ByContentBesideTheFileAndInImportFolders) {
    write("a.ttl", text("a", {"b", "c"}));
    write("misleading_name.owl", text("b", {}));
    write("deep/c.rdf", text("c", {"d"}));
    write("deep/any.xml", text("other", {}, " ; owl:versionIRI <http://e/d>") + "e:Cd a owl:Class .\n");
    write("broken.ttl", "<http://e/b> is broken");
    EXPECT_NE(sentence("a.ttl").find("<http://e/c> cannot be found"), std::string::npos) << sentence("a.ttl");
    const Ontology ontology = load_ontology(folder / "a.ttl", {.import_folders = {folder / "deep"}});
    ASSERT_EQ(ontology.imports.size(), 3U);
    EXPECT_EQ(ontology.imports[0].second, (folder / "misleading_name.owl").string());
    EXPECT_EQ(ontology.imports[1].second, (folder / "deep/c.rdf").string());
    EXPECT_EQ(ontology.imports[2].second, (folder / "deep/any.xml").string());
    EXPECT_EQ(ontology.axioms.front().source.file, (folder / "misleading_name.owl").string());
    EXPECT_EQ(ontology.axioms.back().source.file, (folder / "a.ttl").string());
    EXPECT_EQ(ontology.iri, "http://e/a");
}

TEST_F(Imports, CyclesAndDiamondsAreMergedOnce) {
    write("a.ttl", text("a", {"b", "c"}));
    write("b.ttl", text("b", {"d", "a"}));
    write("c.ttl", text("c", {"d"}));
    write("d.ttl", text("d", {"c", "d"}));
    const Ontology ontology = load_ontology(folder / "a.ttl");
    EXPECT_EQ(ontology.imports.size(), 3U);
    EXPECT_EQ(ontology.axioms.size(), 4U + 7U);
}

TEST_F(Imports, CatalogComesFirst) {
    write("a.ttl", text("a", {"b"}));
    write("b.ttl", text("b", {}));
    write("deep/b two.ttl", text("b", {}) + "e:FromTheCatalog a owl:Class .\n");
    write("catalog-v001.xml",
          "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n<catalog prefer=\"public\" "
          "xmlns=\"urn:oasis:names:tc:entity:xmlns:xml:catalog\">\n<uri id=\"x\" name=\"http://e/x\" uri=\"x.ttl\"/>\n"
          "<group id=\"g\" prefer=\"public\" xml:base=\"deep\"><uri id=\"y\" name=\"http://e/b\" "
          "uri=\"b%20two.ttl\"/></group>\n"
          "</catalog>\n");
    EXPECT_NE(load_ontology(folder / "a.ttl").find("http://e/FromTheCatalog", EntityKind::klass), nullptr);
    // An entry whose file is gone is passed over: Protégé leaves such entries behind.
    fs::remove(folder / "deep/b two.ttl");
    EXPECT_EQ(load_ontology(folder / "a.ttl").imports[0].second, (folder / "b.ttl").string());
    write("catalog-v001.xml", "<catalog>\n<uri");
    EXPECT_TRUE(sentence("a.ttl").starts_with((folder / "catalog-v001.xml").string() + ":2: ")) << sentence("a.ttl");
}

TEST_F(Imports, AnySyntaxImportsAnyOther) {
    write("a.ofn",
          "Prefix(:=<http://e/>) Ontology(<http://e/a> Import(<http://e/b>) Declaration(Class(:A)) "
          "SubClassOf(:A ObjectSomeValuesFrom(:p :B)))");
    write("b.omn",
          "Prefix: : <http://e/>\nOntology: <http://e/b>\nImport: <http://e/c>\nClass: B\n"
          "    SubClassOf: size some Length\nObjectProperty: p\n");
    write("c.owl",
          "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" xml:base=\"http://e/\" ontologyIRI=\"http://e/c\">"
          "<Import>http://e/d</Import><Declaration><DataProperty IRI=\"size\"/></Declaration></Ontology>");
    write("d.xml",
          "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
          "xmlns:owl=\"http://www.w3.org/2002/07/owl#\" xmlns:rdfs=\"http://www.w3.org/2000/01/rdf-schema#\">"
          "<owl:Ontology rdf:about=\"http://e/d\"><owl:imports rdf:resource=\"http://e/a\"/></owl:Ontology>"
          "<rdfs:Datatype rdf:about=\"http://e/Length\"/></rdf:RDF>");
    for (const char* name : {"a.ofn", "b.omn", "c.owl", "d.xml"}) {  // a cycle: each of them reaches all
        const Ontology ontology = load_ontology(folder / name);
        EXPECT_EQ(ontology.imports.size(), 3U) << name;
        EXPECT_EQ(ontology.axioms.size(), 2U) << name;
        // What `size some Length` is about is said in another file, and in Manchester syntax nowhere else.
        for (const Axiom& axiom : ontology.axioms) {
            const bool is_size = axiom.source.file.ends_with("b.omn");
            EXPECT_EQ(axiom.classes.at(1)->kind,
                      is_size ? ClassKind::data_some_values_from : ClassKind::some_values_from);
        }
    }
}

TEST_F(Imports, AnonymousIndividualsOfTwoDocumentsAreTwo) {
    write("a.ofn", "Ontology(<http://e/a> Import(<http://e/b>) ClassAssertion(owl:Thing _:x) SameIndividual(_:x _:y))");
    write("b.ofn", "Ontology(<http://e/b> ClassAssertion(owl:Thing _:x))");
    const Ontology ontology = load_ontology(folder / "a.ofn");
    ASSERT_EQ(ontology.axioms.size(), 3U);
    EXPECT_EQ(ontology.axioms[0].individuals, std::vector<Iri>{"_:x.2"}) << "the one of the import is renamed";
    EXPECT_EQ(ontology.axioms[1].individuals, std::vector<Iri>{"_:x"});
    EXPECT_EQ(ontology.axioms[2].individuals, (std::vector<Iri>{"_:x", "_:y"}));
}

TEST_F(Imports, NotFoundNamesTheImportingLine) {
    write("a.ttl", text("a", {"b"}));
    write("b.ttl", text("b", {"missing"}));
    const std::string said = sentence("a.ttl");
    EXPECT_TRUE(said.starts_with((folder / "b.ttl").string() + ":5: the imported ontology <http://e/missing>")) << said;
    EXPECT_NE(said.find("--import-dir"), std::string::npos);
    EXPECT_THROW((void)load_ontology(folder / "a.ttl", {.import_folders = {folder / "no such"}}), FileError);
}

TEST_F(Imports, AnErrorInAnImportNamesTheImportedFile) {
    write("a.ttl", text("a", {"b"}));
    write("b.ttl", text("b", {}) + "e:Cb rdfs:subClassOf e:Nowhere .\n");
    const std::string said = sentence("a.ttl");
    EXPECT_TRUE(said.starts_with((folder / "b.ttl").string() + ":6: ")) << said;
}

TEST_F(Imports, PropertyKindsComeFromImports) {
    write("a.ttl",
          text("a", {"b"}) + "e:Ca rdfs:subClassOf [ owl:onProperty e:size ; owl:someValuesFrom e:Length ] .\n");
    write("b.ttl", text("b", {}) + "e:size a owl:DatatypeProperty . e:Length a rdfs:Datatype .\n");
    EXPECT_EQ(load_ontology(folder / "a.ttl").axioms.back().classes[1]->kind, ClassKind::data_some_values_from);
}

}  // namespace
}  // namespace partonomy::owl
