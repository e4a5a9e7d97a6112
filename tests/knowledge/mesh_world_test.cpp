/* What spaces leave open and the closed world of a mesh tells: every construct of OWL 2 in an ontology about meshes. */

#include "knowledge/mesh_world.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>
#include <sstream>

#include "base/errors.h"
#include "brute.h"
#include "hermit.h"
#include "knowledge/lint.h"
#include "owl/write.h"

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

/// A domain from axioms in functional syntax over core, and a mesh of which features are told.
class Mesh {
public:
    explicit Mesh(const std::string& axioms, int regions = 0) {
        std::string text =
            "Prefix(:=<urn:t#>) Prefix(core:=<https://w3id.org/partonomy/core#>) "
            "Prefix(xsd:=<http://www.w3.org/2001/XMLSchema#>) Prefix(owl:=<http://www.w3.org/2002/07/owl#>) "
            "Prefix(swrlb:=<http://www.w3.org/2003/11/swrlb#>)\nOntology(<urn:t> "
            "Import(<https://w3id.org/partonomy/core>)\n";
        for (const char* name : {"Leg", "Top", "Table", "A", "B", "C", "Wood"})
            text.append("Declaration(Class(:").append(name).append(")) ");
        for (const char* name : {"p", "q", "r", "isPartOf", "hasLeg", "hasMaterial"})
            text.append("Declaration(ObjectProperty(:").append(name).append(")) ");
        for (const char* name : {"d", "e"}) text.append("Declaration(DataProperty(:").append(name).append(")) ");
        text +=
            "Declaration(Datatype(:Low)) "
            "EquivalentClasses(:Leg ObjectIntersectionOf(core:Region ObjectSomeValuesFrom(core:hasShape core:Stick))) "
            "EquivalentClasses(:Top ObjectIntersectionOf(core:Region ObjectSomeValuesFrom(core:hasShape core:Board))) "
            "EquivalentClasses(:Table ObjectIntersectionOf(core:Object ObjectSomeValuesFrom(core:hasPart :Top) "
            "ObjectSomeValuesFrom(core:hasPart :Leg))) ";
        domain = compile(owl::parse_ontology(text + axioms + "\n)", "t"));
        known.region_count = regions;
        known.complete = true;
    }

    Mesh& tell(int region, const std::string& feature, const std::string& value, bool yes = true) {
        for (std::size_t v = 0; v < domain.regions.variables.size(); ++v) {
            const Variable& variable = domain.regions.variables[v];
            if (owl::local_name(variable.iri) != feature) continue;
            for (std::size_t k = 0; k < variable.values.size(); ++k)
                if (variable.values[k] == value)
                    known.answers.push_back({region, {static_cast<int>(v), static_cast<int>(k)}, yes});
        }
        return *this;
    }

    /// Classes that follow for a region (for the object: -1), local names, sorted: "Leg Table". What the world knows of
    /// whole properties must say the same as the axioms that it is exported as.
    [[nodiscard]] std::string classes(int region = -1) const {
        const ClosedWorld world = make_mesh_world(domain, known, *composites_for_world(domain, known)).world;
        ClosedReasoner ours(world), exported({closed_ontology(world), world.individuals});
        EXPECT_EQ(ours.is_consistent(), exported.is_consistent());
        if (ours.is_consistent()) {
            EXPECT_EQ(ours.all_types(), exported.all_types());
        }
        const Conclusions concluded = conclude(domain, known);
        if (concluded.contradiction) return "contradiction";
        const Space& space = region < 0 ? *concluded.objects : domain.regions;
        std::string names;
        for (const ConceptId id : entailed(space, region < 0 ? concluded.object : concluded.regions[region]))
            names += (names.empty() ? "" : " ") + owl::local_name(space.concepts[id].iri);
        return names;
    }

    Domain domain;
    Knowledge known;
};

/// A table of one board and two sticks.
Mesh table(const std::string& axioms) {
    Mesh mesh(axioms, 3);
    mesh.tell(0, "Shape", "Board").tell(1, "Shape", "Stick").tell(2, "Shape", "Stick");
    return mesh;
}

std::string refusal(const std::string& axioms) {
    try {
        const Mesh mesh(axioms);
    } catch (const OntologyError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST(MeshWorld, InversesLeadToTheObject) {
    const std::string a = "EquivalentClasses(:A ObjectIntersectionOf(:Leg ObjectSomeValuesFrom(";
    for (const std::string& axioms :
         {a + "ObjectInverseOf(core:hasPart) :Table)))",
          "InverseObjectProperties(:isPartOf core:hasPart) " + a + ":isPartOf :Table)))",
          "EquivalentObjectProperties(ObjectInverseOf(:p) core:hasPart) EquivalentObjectProperties(:p :isPartOf) " + a +
              ":isPartOf :Table)))"}) {
        EXPECT_EQ(table(axioms).classes(1), "A Leg") << axioms;
        EXPECT_EQ(table(axioms).classes(0), "Top") << axioms;
        Mesh bench(axioms, 1);
        bench.tell(0, "Shape", "Stick");
        EXPECT_EQ(bench.classes(0), "Leg") << axioms;
    }
}

TEST(MeshWorld, SubPropertiesOfPartsAndFeatures) {
    EXPECT_EQ(table("SubObjectPropertyOf(:hasLeg core:hasPart) ObjectPropertyRange(:hasLeg :Leg) "
                    "EquivalentClasses(:A ObjectIntersectionOf(core:Object ObjectMinCardinality(1 :hasLeg)))")
                  .classes(),
              "Table")
        << "nothing says which part is a leg of it";
    EXPECT_EQ(table("SubObjectPropertyOf(:hasLeg core:hasPart) "
                    "DLSafeRule(Body(ObjectPropertyAtom(core:hasPart Variable(:x) Variable(:y)) ClassAtom(:Leg "
                    "Variable(:y))) Head(ObjectPropertyAtom(:hasLeg Variable(:x) Variable(:y)))) "
                    "EquivalentClasses(:A ObjectIntersectionOf(core:Object ObjectExactCardinality(2 :hasLeg :Leg)))")
                  .classes(),
              "A Table");
    EXPECT_EQ(table("EquivalentClasses(:B ObjectIntersectionOf(core:Region ObjectSomeValuesFrom(core:hasFeature "
                    "core:Board)))")
                  .classes(0),
              "B Top");
    EXPECT_EQ(table("SubObjectPropertyOf(:hasLeg core:hasPart) EquivalentClasses(:A ObjectIntersectionOf(core:Object "
                    "ObjectMaxCardinality(3 :hasLeg)))")
                  .classes(),
              "A Table")
        << "it has three parts";
}

TEST(MeshWorld, IndividualsAsValues) {
    const std::string material =
        "SubClassOf(:B core:Feature) FunctionalObjectProperty(:hasMaterial) ObjectPropertyRange(:hasMaterial :B) "
        "EquivalentClasses(:A ObjectIntersectionOf(core:Region ObjectHasValue(:hasMaterial :oak))) "
        "EquivalentClasses(:C ObjectIntersectionOf(core:Region ObjectSomeValuesFrom(:hasMaterial ObjectOneOf(:oak "
        ":steel)))) ";
    for (const std::string values :
         {"EquivalentClasses(:B ObjectOneOf(:oak :steel :glass))",
          "ClassAssertion(:B :oak) ClassAssertion(:B :steel) DifferentIndividuals(:oak :steel)"}) {
        Mesh mesh(material + values, 1);
        EXPECT_EQ(mesh.classes(0), "");
        EXPECT_EQ(Mesh(mesh).tell(0, "B", "oak").classes(0), "A C") << values;
        EXPECT_EQ(Mesh(mesh).tell(0, "B", "steel").classes(0), "C") << values;
        EXPECT_EQ(mesh.tell(0, "B", "oak", false).tell(0, "B", "steel", false).classes(0), "") << values;
    }
}

TEST(MeshWorld, RulesThatAreTreesAreRolledUp) {
    Mesh mesh = table(
        "DLSafeRule(Body(ObjectPropertyAtom(core:hasPart Variable(:x) Variable(:y)) ClassAtom(:Leg Variable(:y)) "
        "DataPropertyAtom(core:height Variable(:y) Variable(:h)) BuiltInAtom(swrlb:lessThan Variable(:h) "
        "\"0.5\"^^xsd:double)) Head(ClassAtom(:A Variable(:x)))) SubClassOf(:A core:Object)");
    EXPECT_EQ(mesh.classes(), "Table");
    EXPECT_FALSE(mesh.domain.grounding == nullptr);
    EXPECT_EQ(mesh.tell(1, "height", "< 0.5").classes(), "A Table");
    const Explanation why = explain(mesh.domain, mesh.known, "urn:t#A");
    EXPECT_EQ(why.answers, (std::vector<std::size_t>{1, 3}));
}

TEST(MeshWorld, RulesThatAreNoTrees) {
    const std::string beside =
        "DLSafeRule(Body(ObjectPropertyAtom(core:hasPart Variable(:x) Variable(:y)) ObjectPropertyAtom(core:hasPart "
        "Variable(:x) Variable(:z)) ClassAtom(:Leg Variable(:y)) ClassAtom(:Leg Variable(:z)) "
        "DifferentIndividualsAtom(Variable(:y) Variable(:z))) Head(ClassAtom(:A Variable(:x)) ClassAtom(:B "
        "Variable(:y)) "
        "ObjectPropertyAtom(:p Variable(:y) Variable(:z)))) SubClassOf(:A core:Object) SubClassOf(:B core:Region) "
        "EquivalentClasses(:C ObjectIntersectionOf(core:Region ObjectSomeValuesFrom(:p :Leg)))";
    EXPECT_EQ(table(beside).classes(), "A Table");
    EXPECT_EQ(table(beside).classes(1), "B C Leg");
    EXPECT_EQ(table(beside).classes(0), "Top");
    EXPECT_NE(
        refusal("DLSafeRule(Body(ClassAtom(:Leg Variable(:y)) DataPropertyAtom(:d Variable(:y) Variable(:h)) "
                "BuiltInAtom(swrlb:add Variable(:k) Variable(:h) Variable(:h))) Head(ClassAtom(:B Variable(:y))))")
            .find("t:3: the axiom"),
        std::string::npos);
}

TEST(MeshWorld, ChainsAndCharacteristics) {
    // Parts of one object are siblings, and each is its own.
    const std::string siblings =
        "SubObjectPropertyOf(ObjectPropertyChain(ObjectInverseOf(core:hasPart) core:hasPart) :p) "
        "EquivalentClasses(:A ObjectIntersectionOf(core:Region ObjectMinCardinality(3 :p core:Region))) "
        "EquivalentClasses(:B ObjectIntersectionOf(core:Region ObjectHasSelf(:p))) ";
    EXPECT_EQ(table(siblings).classes(0), "A B Top");
    EXPECT_EQ(table(siblings + "IrreflexiveObjectProperty(:p)").classes(0), "contradiction");
    EXPECT_EQ(table("ReflexiveObjectProperty(:q) EquivalentClasses(:A ObjectIntersectionOf(core:Region "
                    "ObjectHasSelf(:q))) EquivalentClasses(:B ObjectIntersectionOf(core:Region ObjectHasSelf(:r))) "
                    "IrreflexiveObjectProperty(:r) EquivalentClasses(:C ObjectIntersectionOf(core:Region "
                    "ObjectComplementOf(ObjectHasSelf(:r))))")
                  .classes(0),
              "A C Top");
    EXPECT_EQ(table("FunctionalObjectProperty(core:hasPart)").classes(), "contradiction");
    EXPECT_EQ(table("ObjectPropertyDomain(core:hasPart :A) SubClassOf(:A core:Object)").classes(), "A Table");
    EXPECT_EQ(table("ObjectPropertyRange(core:hasPart :A) SubClassOf(:A core:Region)").classes(1), "A Leg");
}

TEST(MeshWorld, DataOfAnyKindStaysOpen) {
    const std::string text =
        "EquivalentClasses(:A ObjectIntersectionOf(core:Object DataSomeValuesFrom(:d "
        "DatatypeRestriction(xsd:string xsd:pattern \"[A-Z]+\")))) "
        "EquivalentClasses(:B ObjectIntersectionOf(core:Object DataAllValuesFrom(:d xsd:string))) "
        "DataPropertyRange(:d xsd:string) ";
    EXPECT_EQ(table(text).classes(), "B Table");
    EXPECT_EQ(table(text + "SubClassOf(:Table DataHasValue(:d \"IKEA\"))").classes(), "A B Table");
    EXPECT_EQ(table(text + "SubClassOf(:Table DataHasValue(:d \"Ikea\")) FunctionalDataProperty(:d) "
                           "EquivalentClasses(:C ObjectIntersectionOf(core:Object ObjectComplementOf(:A)))")
                  .classes(),
              "B C Table");
}

TEST(MeshWorld, DatatypesAndUnionsOfRanges) {
    Mesh mesh = table(
        "DatatypeDefinition(:Low DataUnionOf(DatatypeRestriction(xsd:double xsd:maxInclusive "
        "\"0.2\"^^xsd:double) DatatypeRestriction(xsd:double xsd:minInclusive \"0.9\"^^xsd:double))) "
        "EquivalentClasses(:A ObjectIntersectionOf(core:Region DataSomeValuesFrom(core:height :Low))) "
        "EquivalentClasses(:B ObjectIntersectionOf(core:Region DataAllValuesFrom(core:height "
        "DataComplementOf(:Low))))");
    EXPECT_EQ(Mesh(mesh).tell(0, "height", "<= 0.2").classes(0), "A Top");
    EXPECT_EQ(Mesh(mesh).tell(0, "height", "<= 0.2", false).tell(0, "height", "> 0.2, < 0.9").classes(0), "B Top");
    EXPECT_EQ(mesh.tell(0, "height", "> 0.2, < 0.9", false).classes(0), "A Top");
}

TEST(MeshWorld, NamedIndividualsAndWhatIsSaidOfThem) {
    const std::string facts =
        "EquivalentClasses(:A ObjectIntersectionOf(core:Object ObjectHasValue(:p :aalto))) "
        "EquivalentClasses(:B ObjectIntersectionOf(core:Object ObjectSomeValuesFrom(:p ObjectSomeValuesFrom(:q "
        "ObjectOneOf(:finland))))) ObjectPropertyAssertion(:q :aalto :finland) ";
    EXPECT_EQ(table(facts).classes(), "Table");
    EXPECT_EQ(table(facts + "SubClassOf(:Table ObjectHasValue(:p :aalto))").classes(), "A B Table");
    EXPECT_EQ(table(facts + "SubClassOf(:Table ObjectHasValue(:p :alvar)) SameIndividual(:alvar :aalto)").classes(),
              "A B Table");
    EXPECT_EQ(table(facts + "SubClassOf(:Table ObjectHasValue(:p :alvar)) NegativeObjectPropertyAssertion(:q :alvar "
                            ":finland) DifferentIndividuals(:alvar :aalto)")
                  .classes(),
              "Table");
    EXPECT_EQ(table("HasKey(core:Region () (:d)) SubClassOf(core:Region DataHasValue(:d \"x\"))").classes(),
              "contradiction")
        << "three regions with one key";
}

TEST(MeshWorld, WhatNobodyNamedMayExist) {
    EXPECT_EQ(table("SubClassOf(:Table ObjectSomeValuesFrom(:p :A)) SubClassOf(:Table ObjectMinCardinality(2 :q :B)) "
                    "DisjointClasses(:A :B core:Object core:Region core:Feature) ClassAssertion(:A :one)")
                  .classes(),
              "Table");
}

TEST(MeshWorld, ExplanationsAndCorrections) {
    Mesh mesh = table(
        "EquivalentClasses(:A ObjectIntersectionOf(:Leg ObjectSomeValuesFrom(ObjectInverseOf("
        "core:hasPart) ObjectMinCardinality(2 core:hasPart :Leg)))) SubClassOf(:A core:Incompatible)");
    ASSERT_EQ(mesh.classes(1), "A Leg");
    const Explanation why = explain(mesh.domain, mesh.known, "urn:t#A", 1);
    EXPECT_EQ(why.answers, (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(why.axioms.size(), 2U) << "Leg and A";
    EXPECT_EQ(all_explanations(mesh.domain, mesh.known, "urn:t#A", 1).sets.size(), 1U);
    const std::vector<Correction> found = corrections(mesh.domain, mesh.known, "urn:t#A", {0.1, 0.4, 0.3}, 1);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].answers, (std::vector<std::size_t>{2}));
    EXPECT_THROW((void)explain(mesh.domain, mesh.known, "urn:t#A", 0), std::invalid_argument);
    try {
        (void)explain(mesh.domain, mesh.known, "urn:t#A", 1, {1, 0});
        ADD_FAILURE() << "explained in no time";
    } catch (const OntologyError& error) {
        EXPECT_STREQ(error.what(), "why it is an A was not found within 0 steps of search");
    }
}

namespace {

/// A table whose legs are joined by twos to frames, of which parts and table are told by way of inverses.
const std::string frames =
    "EquivalentClasses(:A ObjectIntersectionOf(core:CompositePart ObjectMinCardinality(2 core:hasPart :Leg) "
    "ObjectMaxCardinality(3 core:hasPart :Leg))) "
    "EquivalentClasses(:B ObjectIntersectionOf(:A ObjectSomeValuesFrom(ObjectInverseOf(core:hasPart) :Table))) "
    "EquivalentClasses(:C ObjectIntersectionOf(:Leg ObjectSomeValuesFrom(ObjectInverseOf(core:hasPart) :B))) "
    "EquivalentClasses(:Wood ObjectIntersectionOf(core:Object ObjectMinCardinality(2 core:hasPart :C) "
    "ObjectExactCardinality(1 core:hasPart :B))) ";

Mesh framed(const std::string& more = {}) {
    Mesh mesh(frames + more, 4);
    mesh.tell(0, "Shape", "Board").tell(1, "Shape", "Stick").tell(2, "Shape", "Stick").tell(3, "Shape", "Stick");
    mesh.known.connected = {{1, 2}, {0, 3}};
    return mesh;
}

}  // namespace

TEST(MeshWorld, CompositePartsAreToldOnceTheyAreCertain) {
    const Mesh mesh = framed();
    const Conclusions concluded = conclude(mesh.domain, mesh.known);
    ASSERT_EQ(concluded.composites.size(), 2U);
    std::vector<std::string> names;
    for (const CompositePart& part : concluded.composites) {
        const Space& space = mesh.domain.composites[static_cast<std::size_t>(part.group)].space;
        std::string all;
        for (const ConceptId id : entailed(space, part.possible)) all += owl::local_name(space.concepts[id].iri) + " ";
        names.push_back(all);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"A B ", ""})) << "two legs that touch, and one alone";
    const auto types = [&](const Space& space, const ConfigurationSet& set) {
        std::string all;
        for (const ConceptId id : entailed(space, set)) all += owl::local_name(space.concepts[id].iri) + " ";
        return all;
    };
    EXPECT_EQ(types(mesh.domain.regions, concluded.regions[1]), "C Leg ");
    EXPECT_EQ(types(mesh.domain.regions, concluded.regions[3]), "Leg ");
    EXPECT_EQ(types(*concluded.objects, concluded.object), "Table Wood ");

    Mesh open = framed();
    open.known.answers.pop_back();  // part 4 may be a leg or not: then there may be a frame of it, too
    EXPECT_FALSE(composites_for_world(open.domain, open.known));
    EXPECT_FALSE(needs_mesh_world(open.domain, open.known));
    EXPECT_EQ(types(open.domain.regions, conclude(open.domain, open.known).regions[1]), "Leg ");
}

TEST(MeshWorld, ExplanationsAndCorrectionsOfCompositeParts) {
    const Mesh mesh = framed("SubClassOf(:Wood core:Incompatible)");
    const Explanation why = explain(mesh.domain, mesh.known, "urn:t#C", 1);
    EXPECT_EQ(why.answers, (std::vector<std::size_t>{0, 1, 2})) << "the board, and the legs that make up the frame";
    const Explanation of_object = explain(mesh.domain, mesh.known, "urn:t#Wood");
    EXPECT_EQ(of_object.answers, (std::vector<std::size_t>{0, 1, 2}));
    for (const Correction& each : corrections(mesh.domain, mesh.known, "urn:t#Wood", {1, 1, 1, 1})) {
        Knowledge turned = mesh.known;
        for (const std::size_t i : each.answers) turned.answers[i].yes = !turned.answers[i].yes;
        const Conclusions after = conclude(mesh.domain, turned);
        EXPECT_EQ(std::ranges::count(after.diagnoses, "urn:t#Wood"), 0);
    }
    EXPECT_FALSE(corrections(mesh.domain, mesh.known, "urn:t#Wood", {1, 1, 1, 1}).empty());
}

/// Which answers explain, by brute force: sets that no part of would do, such that whatever the others are, and
/// whatever composite parts there are then, the concept holds. That there are no other regions is given.
class BruteReasons {
public:
    explicit BruteReasons(const Mesh& mesh) : mesh_(mesh) {
        const Variable& shape = mesh.domain.regions.variables[0];
        for (const char* name : {"Board", "Stick", "Cube"})
            for (std::size_t k = 0; k < shape.values.size(); ++k)
                if (shape.values[k] == name) values_.push_back(static_cast<int>(k));
        Knowledge told = mesh.known;
        std::vector<std::size_t> choice(static_cast<std::size_t>(told.region_count), 0);
        for (std::size_t at = 0; at < choice.size();) {
            told.answers.clear();
            for (std::size_t r = 0; r < choice.size(); ++r)
                told.answers.push_back({static_cast<int>(r), {0, values_[choice[r]]}, true});
            const auto made = *composites_for_world(mesh.domain, told);
            const MeshWorld world = make_mesh_world(mesh.domain, told, made);
            ClosedReasoner reasoner(world.world);
            std::vector<std::vector<Iri>> types{reasoner.types(world.object)};
            for (const Iri& region : world.regions) types.push_back(reasoner.types(region));
            worlds_.push_back({choice, std::move(types)});
            for (at = 0; at < choice.size() && ++choice[at] == values_.size(); ++at) choice[at] = 0;
        }
    }

    [[nodiscard]] std::set<std::vector<std::size_t>> sets(const Iri& iri, int region) const {
        const std::size_t count = mesh_.known.answers.size();
        std::vector<unsigned> found;
        for (unsigned size = 0; size <= count; ++size)
            for (unsigned set = 0; set < 1U << count; ++set)
                if (static_cast<unsigned>(std::popcount(set)) == size &&
                    std::ranges::none_of(found, [&](unsigned less) { return (set & less) == less; }) &&
                    suffices(set, iri, region))
                    found.push_back(set);
        std::set<std::vector<std::size_t>> result;
        for (const unsigned set : found) {
            std::vector<std::size_t> answers;
            for (std::size_t i = 0; i < count; ++i)
                if ((set >> i & 1U) != 0) answers.push_back(i);
            result.insert(std::move(answers));
        }
        return result;
    }

private:
    struct World {
        std::vector<std::size_t> choice;
        std::vector<std::vector<Iri>> types;  ///< of the object, then of the regions
    };
    [[nodiscard]] bool suffices(unsigned set, const Iri& iri, int region) const {
        return std::ranges::all_of(worlds_, [&](const World& world) {
            for (std::size_t i = 0; i < mesh_.known.answers.size(); ++i) {
                const Answer& answer = mesh_.known.answers[i];
                const bool is_so =
                    values_[world.choice[static_cast<std::size_t>(answer.region)]] == answer.question.value;
                if ((set >> i & 1U) != 0 && is_so != answer.yes) return true;  // not one of those
            }
            return std::ranges::count(world.types[static_cast<std::size_t>(region + 1)], iri) > 0;
        });
    }

    const Mesh& mesh_;
    std::vector<int> values_;
    std::vector<World> worlds_;
};

TEST(MeshWorld, ExplanationsBehindCompositePartsAreMinimalAndAll) {
    int explained = 0, several = 0;
    for (const unsigned seed : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 8U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const int regions = seed < 8 ? 4 : 6;
        Mesh mesh(frames, regions);
        for (int region = 0; region < regions; ++region) {  // with answers that say less, or nothing new
            const bool is_board = random() % 3 == 0;
            if (random() % 3 == 0) mesh.tell(region, "Shape", "Cube", false);
            mesh.tell(region, "Shape", is_board ? "Board" : "Stick");
            if (random() % 2 == 0) mesh.tell(region, "Shape", is_board ? "Stick" : "Board", false);
        }
        for (int a = 0; a < regions; ++a)
            for (int b = a + 1; b < regions; ++b)
                if (random() % 2 == 0) mesh.known.connected.emplace_back(a, b);
        ASSERT_EQ(mesh.domain.regions.variables[0].iri, owl::core_prefix + std::string("Shape"));
        const BruteReasons brute(mesh);
        for (int region = -1; region < regions; ++region) {
            const Iri iri = region < 0 ? "urn:t#Wood" : "urn:t#C";
            const std::set<std::vector<std::size_t>> expected = brute.sets(iri, region);
            if (expected.empty()) {
                EXPECT_THROW((void)explain(mesh.domain, mesh.known, iri, region), std::invalid_argument);
                continue;
            }
            const Explanations all = all_explanations(mesh.domain, mesh.known, iri, region);
            ASSERT_TRUE(all.is_complete);
            std::set<std::vector<std::size_t>> found;
            for (const Explanation& each : all.sets) found.insert(each.answers);
            std::erase_if(found, [&](const auto& set) {  // another one does with fewer answers, and more axioms
                return std::ranges::any_of(all.sets, [&](const Explanation& less) {
                    return less.answers.size() < set.size() && std::ranges::includes(set, less.answers);
                });
            });
            EXPECT_EQ(found, expected) << iri << " " << region;
            const Explanation one = explain(mesh.domain, mesh.known, iri, region);
            EXPECT_TRUE(expected.contains(one.answers)) << iri << " " << region;
            ++explained;
            several += expected.size() > 1;
        }
    }
    EXPECT_GT(explained, 10);
    EXPECT_GT(several, 3);
}

TEST(MeshWorld, WhatBelongsToACompositePartMustBeKnowable) {
    const std::string wooden = "ObjectIntersectionOf(:Leg ObjectSomeValuesFrom(:p :Wood))";
    const std::string refused = refusal(
        "EquivalentClasses(:A ObjectIntersectionOf(core:CompositePart "
        "ObjectMinCardinality(2 core:hasPart " +
        wooden + ")))");
    EXPECT_NE(refused.find("t:"), std::string::npos);
    EXPECT_NE(refused.find("what belongs to an A hangs on \"p some Wood\""), std::string::npos) << refused;
    // A concept below one that names what belongs by features may ask for it.
    const Mesh mesh(
        "EquivalentClasses(:A ObjectIntersectionOf(core:CompositePart ObjectMinCardinality(2 core:hasPart :Leg))) "
        "EquivalentClasses(:B ObjectIntersectionOf(:A ObjectSomeValuesFrom(core:hasPart " +
        wooden + ")))");
    EXPECT_EQ(mesh.domain.composites.size(), 1U);
    const std::string outer =
        "EquivalentClasses(:A ObjectIntersectionOf(core:CompositePart ObjectMinCardinality(1 core:hasPart :Leg))) "
        "EquivalentClasses(:C ObjectIntersectionOf(core:CompositePart ObjectSomeValuesFrom(core:hasPart "
        "ObjectIntersectionOf(:A ObjectHasSelf(:q)))))";
    EXPECT_NE(refusal(outer).find("what belongs to a C hangs on"), std::string::npos) << refusal(outer);
}

TEST(MeshWorld, RulesSayWhatADiagnosisIsAbout) {
    const Mesh mesh = table(
        "SubClassOf(:A core:Incompatible) DLSafeRule(Body(ClassAtom(:Table Variable(:t)) "
        "ObjectPropertyAtom(core:hasPart Variable(:t) Variable(:a)) ObjectPropertyAtom(core:hasPart Variable(:t) "
        "Variable(:b)) ClassAtom(:Leg Variable(:a)) ClassAtom(:Leg Variable(:b)) DifferentIndividualsAtom(Variable(:a) "
        "Variable(:b))) Head(ClassAtom(:A Variable(:t))))");
    EXPECT_EQ(mesh.classes(), "A Table");
    for (const Finding& each : lint(mesh.domain)) EXPECT_NE(each.kind, FindingKind::unprovable) << each.what;
    EXPECT_TRUE(mesh.domain.object_warnings().empty());
}

TEST(MeshWorld, WhatIsExportedReadsBack) {
    const Mesh mesh = table(
        "InverseObjectProperties(:isPartOf core:hasPart) DisjointUnion(:A :Leg :B) SubClassOf(:A core:Region) "
        "EquivalentClasses(:C ObjectIntersectionOf(core:Object ObjectHasValue(:p :one))) ClassAssertion(:C :two)");
    const owl::Ontology closed = closed_ontology(make_mesh_world(mesh.domain, mesh.known).world);
    for (const std::string& text :
         {owl::write_turtle(closed, {.merge_imports = true}), owl::write_functional(closed, {.merge_imports = true})})
        EXPECT_EQ(owl::parse_ontology(text, "t").axioms.size(), closed.axioms.size());
}

TEST(MeshWorld, HermitAgrees) {
    if (!hermit::is_there()) GTEST_SKIP() << "no HermiT: run ./dev setup";
    const std::string open = "EquivalentClasses(:A ObjectIntersectionOf(core:Region ";
    const std::vector<std::string> axioms{
        open +
            "ObjectSomeValuesFrom(ObjectInverseOf(core:hasPart) :Table))) InverseObjectProperties(:isPartOf "
            "core:hasPart) EquivalentClasses(:B ObjectIntersectionOf(:Leg ObjectSomeValuesFrom(:isPartOf :Table)))",
        "SubObjectPropertyOf(:hasLeg core:hasPart) ObjectPropertyRange(:hasLeg :Leg) SubClassOf(:Table "
        "ObjectMinCardinality(2 :hasLeg)) EquivalentClasses(:A ObjectIntersectionOf(:Leg "
        "ObjectSomeValuesFrom(ObjectInverseOf(:hasLeg) owl:Thing)))",
        "SubObjectPropertyOf(ObjectPropertyChain(ObjectInverseOf(core:hasPart) core:hasPart) :p) " + open +
            "ObjectSomeValuesFrom(:p :Leg)))",
        open +
            "ObjectHasSelf(:q))) SubClassOf(:Leg ObjectHasSelf(:q)) AsymmetricObjectProperty(:r) "
            "EquivalentClasses(:B ObjectIntersectionOf(core:Region ObjectComplementOf(ObjectHasSelf(:r))))",
        "DLSafeRule(Body(ObjectPropertyAtom(core:hasPart Variable(:x) Variable(:y)) ClassAtom(:Leg Variable(:y))) "
        "Head(ObjectPropertyAtom(:p Variable(:x) Variable(:y)))) EquivalentClasses(:A "
        "ObjectIntersectionOf(core:Object ObjectMinCardinality(2 :p)))",
        "EquivalentClasses(:A ObjectIntersectionOf(core:Object ObjectHasValue(:p :one))) SubClassOf(:Table "
        "ObjectHasValue(:p :two)) SameIndividual(:one :two) ObjectPropertyAssertion(:q :one :three)",
        "EquivalentClasses(:A ObjectIntersectionOf(core:Object DataSomeValuesFrom(:d DatatypeRestriction(xsd:integer "
        "xsd:minInclusive \"3\"^^xsd:integer)))) SubClassOf(:Table DataHasValue(:d \"4\"^^xsd:integer))",
        "SubClassOf(:B core:Feature) FunctionalObjectProperty(:hasMaterial) ObjectPropertyRange(:hasMaterial :B) "
        "EquivalentClasses(:B ObjectOneOf(:oak :steel)) SubClassOf(:Leg ObjectHasValue(:hasMaterial :oak)) " +
            open + "ObjectComplementOf(ObjectHasValue(:hasMaterial :steel))))"};
    std::vector<Mesh> meshes{framed()};
    for (const std::string& each : axioms) meshes.push_back(table(each));
    std::vector<std::string> texts;
    for (const Mesh& mesh : meshes)
        texts.push_back(owl::write_functional(
            closed_ontology(
                make_mesh_world(mesh.domain, mesh.known, *composites_for_world(mesh.domain, mesh.known)).world),
            {.merge_imports = true}));
    const std::vector<std::string> lines = hermit::judge(texts, "object part");
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Mesh& mesh = meshes[i];
        std::set<std::string> theirs, ours;
        std::istringstream words(lines[i]);
        std::string word;
        words >> word;
        EXPECT_EQ(word, "consistent") << lines[i];
        while (words >> word) {
            const owl::Iri iri = "urn:t#" + word.substr(0, word.find('('));
            if (mesh.domain.objects().find(iri) || mesh.domain.regions.find(iri)) theirs.insert(word);
        }
        for (int region = -1; region < mesh.known.region_count; ++region) {
            std::istringstream names(mesh.classes(region));
            while (names >> word)
                ours.insert(word + (region < 0 ? "(object)" : "(part" + std::to_string(region + 1) + ")"));
        }
        EXPECT_EQ(ours, theirs) << (i == 0 ? frames : axioms[i - 1]);
    }
}

/// Where configuration spaces say all, the closed world of the mesh says the same.
TEST(MeshWorld, AgreesWithTheSpaces) {
    int checked = 0, contradictions = 0;
    for (unsigned seed = 5000; seed < 5250; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const brute::Random ontology(random, seed % 3 == 0);
        Domain domain;
        try {
            domain = compile(ontology.ontology.result);
        } catch (const OntologyError&) {
            continue;
        }
        Knowledge knowledge = brute::random_knowledge(random, ontology);
        knowledge.complete = true;
        EXPECT_FALSE(needs_mesh_world(domain, knowledge));
        const Conclusions spaces = conclude(domain, knowledge);
        const MeshWorld mesh = make_mesh_world(domain, knowledge);
        ClosedReasoner reasoner(mesh.world);
        ++checked;
        contradictions += spaces.contradiction ? 1 : 0;
        ASSERT_EQ(reasoner.is_consistent(), !spaces.contradiction);
        if (spaces.contradiction) continue;
        const auto follows = [&](const Iri& individual, const Concept& each) {
            return std::ranges::binary_search(reasoner.types(individual), each.iri);
        };
        for (const Concept& each : spaces.objects->concepts)
            EXPECT_EQ(follows(mesh.object, each), spaces.object.is_subset_of(each.where)) << each.iri;
        // What the object is may tell what a region is, which spaces do not look at.
        for (std::size_t r = 0; r < mesh.regions.size(); ++r)
            for (const Concept& each : domain.regions.concepts)
                EXPECT_TRUE(!spaces.regions[r].is_subset_of(each.where) || follows(mesh.regions[r], each))
                    << each.iri << " of part " << r + 1;
    }
    EXPECT_GT(checked, 150);
    EXPECT_GT(contradictions, 10);
}

TEST(MeshWorld, TooLargeAMeshIsToldAndNotGuessedAt) {
    const std::string axioms =
        "SubObjectPropertyOf(ObjectPropertyChain(:p :q :r) :p) "
        "EquivalentClasses(:A ObjectIntersectionOf(:Leg ObjectSomeValuesFrom(:p :Leg))) ";
    Mesh small(axioms, 3), large(axioms, 400);
    for (int region = 0; region < 400; ++region) large.tell(region, "Shape", "Stick");
    for (int region = 0; region < 3; ++region) small.tell(region, "Shape", "Stick");
    EXPECT_TRUE(conclude(small.domain, small.known).left_aside.empty());
    const Conclusions concluded = conclude(large.domain, large.known);
    EXPECT_NE(concluded.left_aside.find("more than 8000000 clauses"), std::string::npos) << concluded.left_aside;
    const ConceptId leg = *large.domain.regions.find("urn:t#Leg"), a = *large.domain.regions.find("urn:t#A");
    const std::vector<ConceptId> told = entailed(large.domain.regions, concluded.regions[0]);
    EXPECT_NE(std::ranges::find(told, leg), told.end());
    EXPECT_EQ(std::ranges::find(told, a), told.end());
}
