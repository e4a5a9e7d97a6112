// docs/elementary-algorithms.md lists every concept of core.ttl and every measure, as they are.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "algorithms/measures.h"
#include "base/files.h"
#include "knowledge/theory.h"

namespace partonomy {
namespace {

std::string label_of(const owl::Ontology& ontology, const owl::Iri& iri, const std::string& language) {
    const auto found = ontology.annotations.find(iri);
    if (found == ontology.annotations.end()) return {};
    for (const owl::Annotation& annotation : found->second)
        if (annotation.property.ends_with("#label") && annotation.literal.language == language)
            return annotation.literal.value;
    return {};
}

std::string row_of(const owl::Ontology& ontology, const knowledge::RangeConcept& range,
                   const knowledge::ElementaryConcept& value) {
    std::string criteria;
    for (const knowledge::Criterion& c : value.criteria)
        criteria += fmt::format("{}`{}` {} {} {} {}", criteria.empty() ? "" : ", ", c.measure, c.a1, c.a2, c.a3, c.a4);
    return fmt::format("| {} | {} | {} | {} | {} |", owl::local_name(range.iri), owl::local_name(value.iri),
                       label_of(ontology, value.iri, "fr"), criteria, value.cost.value_or(1));
}

TEST(Docs, TableOfConceptsIsThatOfCore) {
    const std::string page = read_file(PARTONOMY_SOURCE_DIR "/docs/elementary-algorithms.md");
    const owl::Ontology core = owl::parse_ontology(owl::core_ontology_text(), "core.ttl");
    int count = 0;
    std::string missing;
    for (const knowledge::RangeConcept& range : knowledge::find_ranges(core))
        for (const knowledge::ElementaryConcept& value : range.values) {
            ++count;
            const std::string row = row_of(core, range, value);
            if (page.find(row + "\n") == std::string::npos) missing += row + "\n";
            EXPECT_FALSE(value.criteria.empty()) << value.iri;
            EXPECT_FALSE(value.question.empty()) << value.iri;
            EXPECT_FALSE(label_of(core, value.iri, "en").empty()) << value.iri;
            EXPECT_FALSE(label_of(core, value.iri, "fr").empty()) << value.iri;
        }
    EXPECT_EQ(missing, "") << "these rows are missing";
    int rows = 0;
    for (std::size_t at = page.find("| range concept |"); at != std::string::npos && page[at] == '|';
         at = page.find('\n', at) + 1)
        ++rows;
    EXPECT_EQ(rows, count + 2) << "rows of concepts that core.ttl does not have";
}

TEST(Docs, MeasuresAreListed) {
    const std::string page = read_file(PARTONOMY_SOURCE_DIR "/docs/elementary-algorithms.md") +
                             read_file(PARTONOMY_SOURCE_DIR "/docs/appearance.md");
    for (const Measure& measure : all_measures())
        EXPECT_NE(page.find(fmt::format("`{}`", measure.name)), std::string::npos) << measure.name;
}

}  // namespace
}  // namespace partonomy
