/* How many literals data ranges have, worked out by hand: d has at least n values in R is satisfiable exactly when R
   has n literals. And what patterns mean. */

#include <gtest/gtest.h>

#include "closed_text.h"
#include "knowledge/data_cells.h"

using namespace closed_text;
using knowledge::closed::CannotGround;
using knowledge::closed::code_points;
using knowledge::closed::TextLanguages;
using knowledge::closed::uncountable;

namespace {

bool can_have(int number, const std::string& range) {
    const std::string text = "ClassAssertion(DataMinCardinality(" + std::to_string(number) + " :d " + range + ") :a)";
    return knowledge::ClosedReasoner(world(text)).is_consistent();
}

void expect_size(int number, const std::string& range) {
    EXPECT_TRUE(can_have(number, range)) << range;
    EXPECT_FALSE(can_have(number + 1, range)) << range;
}

std::string between(const std::string& type, const std::string& low, const std::string& high,
                    const char* ends = "Inclusive") {
    const auto facet = [&](const char* side, const std::string& value) {
        return std::string(" xsd:") + side + ends + " \"" + value + "\"^^xsd:" + type;
    };
    return "DatatypeRestriction(xsd:" + type + facet("min", low) + facet("max", high) + ")";
}

/// How many strings match the pattern, and whether `text` does.
std::pair<std::uint64_t, bool> matches(const std::string& pattern, const std::string& text) {
    TextLanguages languages;
    (void)languages.add_pattern(pattern);
    std::uint64_t count = 0;
    for (const TextLanguages::Cell& cell : languages.cut())
        if (cell.inside[0]) count = knowledge::closed::saturating_sum(count, cell.capacity);
    return {count, languages.inside(text)[0]};
}

}  // namespace

TEST(ClosedData, CountsNumbers) {
    expect_size(3, between("integer", "2", "4"));
    expect_size(1, between("integer", "2", "4", "Exclusive"));
    expect_size(0, between("integer", "3", "2"));
    expect_size(256, "xsd:byte");
    expect_size(6, "DataIntersectionOf(xsd:byte xsd:nonNegativeInteger " + between("decimal", "-2.5", "5.5") + ")");
    EXPECT_TRUE(can_have(50, between("decimal", "0", "0.001")));
    EXPECT_TRUE(can_have(50, "DataIntersectionOf(owl:real DataComplementOf(owl:rational))"));
    expect_size(0, "DataIntersectionOf(xsd:decimal xsd:double)");
    expect_size(2, "DataOneOf(\"1\"^^xsd:integer \"1.0\"^^xsd:decimal \"1\"^^xsd:double)");
}

TEST(ClosedData, CountsDoubles) {
    expect_size(3, between("double", "0.1", "0.10000000000000003"));  // neighbours: …01, …015, …03
    expect_size(2, between("double", "-0.0", "0.0"));                 // both zeros
    expect_size(2, between("double", "0.0", "-0.0"));                 // which are equal, so no order between them
    expect_size(2, between("double", "-4.9E-324", "4.9E-324", "Exclusive"));
    expect_size(0, between("double", "INF", "INF", "Exclusive"));
    expect_size(1, "DataIntersectionOf(xsd:double DataComplementOf(" + between("double", "-INF", "INF") + "))");  // NaN
    expect_size(2, between("float", "1.0", "1.0000001"));
    EXPECT_TRUE(can_have(100, between("float", "1.0", "2.0")));
}

TEST(ClosedData, CountsOthers) {
    expect_size(2, "xsd:boolean");
    expect_size(
        0, "DataIntersectionOf(xsd:boolean DataComplementOf(DataOneOf(\"1\"^^xsd:boolean \"false\"^^xsd:boolean)))");
    EXPECT_TRUE(can_have(20, "DataComplementOf(xsd:string)"));
    expect_size(0, "DataIntersectionOf(xsd:string DataComplementOf(rdfs:Literal))");
    expect_size(2, "DataOneOf(\"seat\"@en \"seat\"@EN \"seat\")");
    expect_size(6, "DatatypeRestriction(xsd:string xsd:pattern \"[ab]{1,2}\")");
    expect_size(4, "DatatypeRestriction(xsd:string xsd:pattern \"[ab]*\" xsd:length \"2\"^^xsd:integer)");
    expect_size(1, "DatatypeRestriction(xsd:string xsd:maxLength \"0\"^^xsd:integer)");
    expect_size(0, "DataIntersectionOf(xsd:NCName DatatypeRestriction(xsd:string xsd:pattern \"[0-9]+\"))");
}

TEST(ClosedData, Patterns) {
    using Result = std::pair<std::uint64_t, bool>;
    EXPECT_EQ(matches("a|bc?", "bc"), (Result{3, true}));
    EXPECT_EQ(matches("(a|b){2}", "ab"), (Result{4, true}));
    EXPECT_EQ(matches("", ""), (Result{1, true}));
    EXPECT_EQ(matches("a{0}b", "b"), (Result{1, true}));
    EXPECT_EQ(matches("(a?b?)+", "bab"), (Result{uncountable, true}));
    EXPECT_EQ(matches("a{2,}", "a"), (Result{uncountable, false}));
    EXPECT_EQ(matches("a{1,3}", "aaaa"), (Result{3, false}));
    EXPECT_EQ(matches("[a-z-[aeiou]]", "e"), (Result{21, false}));
    EXPECT_EQ(matches("[^a-z]x", "ax").second, false);
    EXPECT_EQ(matches("[\\-+.]", "-"), (Result{3, true}));
    EXPECT_EQ(matches(".", "\n").second, false);
    EXPECT_EQ(matches("\\d\\.\\d", "4.5").second, true);
    EXPECT_EQ(matches("\\i\\c*", "x-1").second, true);
    EXPECT_EQ(matches("\\s\\S", " x").second, true);
    EXPECT_EQ(matches("\xC3\xA9+", "\xC3\xA9\xC3\xA9").second, true);  // é
    EXPECT_EQ(matches("a*a*a*b", "aab"), (Result{uncountable, true}));
    for (const char* broken :
         {"a)", "(a", "[a", "a{2", "a{3,2}", "*", "\\w", "\\p{L}", "[z-a]", "a\\", "((((a{99}){99}){99}){99})"})
        EXPECT_THROW((void)matches(broken, ""), CannotGround) << broken;
    EXPECT_EQ(code_points("a\xC3\xA9\xF0\x9F\x98\x80\xFF"), (std::u32string{'a', 0xE9, 0x1F600, 0xFFFD}));
}
