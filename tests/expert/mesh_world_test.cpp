/* The closed world of each of the paper's objects says of object and parts what the program says: asked of our own
   closed reasoner, and of HermiT on the exported OWL. */

#include "knowledge/mesh_world.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "examples/objects.h"
#include "expert/furniture.h"
#include "knowledge/hermit.h"
#include "owl/write.h"

namespace partonomy {
namespace {

using namespace knowledge;

struct Told {
    MeshWorld mesh;
    std::set<std::string> classes;  ///< "Chair(object)"
};

Told told_of(const std::string& name) {
    const Domain& domain = Furniture::get().domain;
    const Annotation annotation = Furniture::get().annotate(paper_object(name).mesh);
    const Knowledge known = recall(domain, static_cast<int>(annotation.parts.size()), annotation.is_complete,
                                   annotation.answers, annotation.connected);
    EXPECT_TRUE(known.complete);
    Told told{make_mesh_world(domain, known), {}};
    const Conclusions concluded = conclude(domain, known);
    const auto tell = [&](const Space& space, const ConfigurationSet& set, const Iri& individual) {
        for (const ConceptId id : entailed(space, set))
            told.classes.insert(owl::local_name(space.concepts[id].iri) + "(" + owl::local_name(individual) + ")");
    };
    tell(*concluded.objects, concluded.object, told.mesh.object);
    for (std::size_t r = 0; r < told.mesh.regions.size(); ++r)
        tell(domain.regions, concluded.regions[r], told.mesh.regions[r]);
    return told;
}

/// Of object and parts, furniture's own classes.
std::set<std::string> own_classes(const std::set<std::string>& all) {
    std::set<std::string> own;
    const Domain& domain = Furniture::get().domain;
    for (const std::string& each : all) {
        const Iri iri = "https://w3id.org/partonomy/furniture#" + each.substr(0, each.find('('));
        if (domain.objects().find(iri) || domain.regions.find(iri)) own.insert(each);
    }
    return own;
}

/// The exported ontology but for "there is nobody else": with 100 individuals that costs HermiT minutes, and what is
/// told of each property is enough for furniture.
owl::Ontology without_domain_closure(const ClosedWorld& world) {
    owl::Ontology result = closed_ontology(world);
    std::erase_if(result.axioms, [](const owl::Axiom& axiom) {
        return axiom.kind == owl::AxiomKind::equivalent_classes && axiom.classes[1]->kind == owl::ClassKind::one_of &&
               axiom.classes[0]->iri.ends_with("#Thing");
    });
    return result;
}

class MeshOfPaper : public testing::TestWithParam<std::string> {};

TEST_P(MeshOfPaper, TheClosedReasonerAgrees) {
    const Told told = told_of(GetParam());
    ClosedReasoner reasoner(told.mesh.world);
    std::set<std::string> found;
    std::vector<Iri> asked = told.mesh.regions;
    asked.push_back(told.mesh.object);
    for (const Iri& individual : asked)
        for (const Iri& type : reasoner.types(individual))
            found.insert(owl::local_name(type) + "(" + owl::local_name(individual) + ")");
    EXPECT_EQ(own_classes(found), told.classes);
    EXPECT_FALSE(told.classes.empty());
}

INSTANTIATE_TEST_SUITE_P(All, MeshOfPaper, paper_object_names, without_dashes);

TEST(MeshesOfPaper, HermitAgrees) {
    if (!hermit::is_there()) GTEST_SKIP() << "no HermiT: run ./dev setup";
    std::vector<Told> told;
    std::vector<std::string> texts;
    // Those that take it two seconds each; the curved bench, with its 22 parts, would take minutes.
    for (const char* name : {"bench", "chair", "couch"}) {
        told.push_back(told_of(name));
        texts.push_back(owl::write_functional(without_domain_closure(told.back().mesh.world), {.merge_imports = true}));
    }
    const std::vector<std::string> lines = hermit::judge(texts, "object part https://w3id.org/partonomy/furniture#", 300);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::istringstream words(lines[i]);
        std::string verdict;
        words >> verdict;
        EXPECT_EQ(verdict, "consistent") << lines[i];
        std::set<std::string> theirs;
        for (std::string word; words >> word;) theirs.insert(word);
        EXPECT_EQ(own_classes(theirs), told[i].classes) << i;
    }
}

}  // namespace
}  // namespace partonomy
