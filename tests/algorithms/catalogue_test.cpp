#include "algorithms/catalogue.h"

#include <gtest/gtest.h>

#include <string>

#include "base/errors.h"

namespace partonomy {
namespace {

const knowledge::Domain& furniture() {
    static const knowledge::Domain domain =
        knowledge::compile(owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/paper-furniture.ttl"));
    return domain;
}

const Catalogue& catalogue() {
    static const Catalogue made = make_catalogue(furniture());
    return made;
}

knowledge::Question question(const std::string& range, const std::string& value) {
    const knowledge::Space& space = furniture().regions;
    const auto variable = space.find_variable(owl::core_prefix + range);
    EXPECT_TRUE(variable) << range;
    const auto& values = space.variables[static_cast<std::size_t>(*variable)].values;
    for (int i = 0; i < static_cast<int>(values.size()); ++i)
        if (values[static_cast<std::size_t>(i)] == value) return {*variable, i};
    ADD_FAILURE() << value;
    return {};
}

double score(const std::string& range, const std::string& value, const RegionMeasurements& region) {
    Object object;
    object.low = 0;
    object.high = 1;
    return is_a(furniture(), catalogue(), question(range, value), object, region).value();
}

RegionMeasurements with_lengths(double l0, double l1, double l2) {
    RegionMeasurements region;
    region.lengths = Vec3(l0, l1, l2);
    return region;
}

TEST(Catalogue, TwelveConceptsOfThePaper) {
    int find_all = 0, derived = 0, concepts = 0, numbers = 0;
    for (const ElementaryAlgorithm& algorithm : catalogue().algorithms) {
        const auto& variable = furniture().regions.variables[static_cast<std::size_t>(algorithm.question.variable)];
        if (algorithm.signature == Signature::find_all && algorithm.origin == Origin::derived)
            ++derived;
        else if (algorithm.signature == Signature::find_all)
            ++find_all;
        else if (variable.kind == knowledge::VariableKind::range)
            ++concepts;
        else
            ++numbers;
        EXPECT_GT(algorithm.cost, 0);
    }
    EXPECT_EQ(find_all, 3);
    EXPECT_EQ(derived, 9);  // of the concepts that have no own one
    EXPECT_EQ(concepts, 12);
    EXPECT_EQ(numbers, 2);  // height <= 0.55, width <= 0.55
}

TEST(Catalogue, ShapesFromLengths) {
    EXPECT_EQ(score("Shape", "Board", with_lengths(4, 3, 0.2)), 1);
    EXPECT_EQ(score("Shape", "Stick", with_lengths(4, 3, 0.2)), 0);
    EXPECT_EQ(score("Shape", "Stick", with_lengths(4, 0.3, 0.25)), 1);
    EXPECT_EQ(score("Shape", "Cube", with_lengths(1, 0.9, 0.9)), 1);
    EXPECT_DOUBLE_EQ(score("Shape", "Board", with_lengths(4, 2, 1)), 0.5);  // half way between block and board
}

/// Whatever the lengths, one shape is at least as likely as not, and two only at a border.
TEST(Catalogue, ShapesCoverAllBoxes) {
    for (double r0 = 1; r0 < 4; r0 += 0.07)
        for (double r1 = 1; r1 < 4; r1 += 0.07) {
            const RegionMeasurements region = with_lengths(r0 * r1, r1, 1);
            int likely = 0;
            for (const char* shape : {"Board", "Stick", "Cube"}) likely += score("Shape", shape, region) > 0.5;
            EXPECT_LE(likely, 1) << r0 << " " << r1;
            EXPECT_GE(
                score("Shape", "Board", region) + score("Shape", "Stick", region) + score("Shape", "Cube", region), 0.5)
                << r0 << " " << r1;
        }
}

TEST(Catalogue, WithoutUnitQuestionsOfSizeAreUnanswerable) {
    Object object;
    object.high = 1;
    object.placement.metres_per_unit = std::nullopt;
    EXPECT_EQ(is_a(furniture(), catalogue(), question("Modular", "M27"), object, with_lengths(1, 1, 1)), std::nullopt);
    EXPECT_NE(is_a(furniture(), catalogue(), question("Position", "Up"), object, with_lengths(1, 1, 1)), std::nullopt);
}

TEST(Catalogue, UnknownMeasureNamesTheNearestOne) {
    std::string text = owl::core_ontology_text();
    const std::string right = "core:measure \"inclination\"";
    text.replace(text.find(right), right.size(), "core:measure \"inclinatoin\"");
    text =
        "@prefix : <http://example.org/#> .\n<http://example.org/> a owl:Ontology .\n:Thing2 a owl:Class ; "
        "rdfs:subClassOf core:Object ; "
        "owl:equivalentClass [ a owl:Restriction ; owl:onProperty core:hasPart ; owl:someValuesFrom core:Region ] .\n" +
        text;
    text =
        "@prefix core: <https://w3id.org/partonomy/core#> .\n@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
        "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n" +
        text;
    const knowledge::Domain domain = knowledge::compile(owl::parse_ontology(text, "typo.ttl"));
    try {
        static_cast<void>(make_catalogue(domain));
        FAIL() << "a measure that does not exist was accepted";
    } catch (const OntologyError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean \"inclination\""), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("typo.ttl:"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace partonomy
