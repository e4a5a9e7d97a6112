/* Combinations of measures in annotations.
 *
 * Names of measures have blanks and signs in them ("top height", "l0/l1"), so a name is the longest measure that the
 * text goes on with and that ends where a word ends; only then signs are operations. The usual precedence, by recursive
 * descent, into steps for a stack: parsed once, when the catalogue is made.
 *
 * Measures between regions are combined in the same way (relation_formula.cpp), so the parser (formula_parser.h) knows
 * no more of a measure than its name and its unit.
 *
 * Units are powers of metres and degrees, and of the object's diagonal and height, of which measures between regions
 * are fractions. They multiply and divide freely; to be added they must be the same. A plain
 * number takes the unit of what it is added to: in "top height - 0.1" it is 0.1 m, so that formula needs a unit, while
 * "length / width" has the same value in any. */

#include "algorithms/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "algorithms/formula_parser.h"
#include "algorithms/relations.h"
#include "base/spelling.h"

namespace partonomy {

FormulaUnit formula_unit(std::string_view word) {
    if (word == "degrees") return {.degrees = 1};
    if (word == "m") return {.metres = 1};
    if (word == "m2") return {.metres = 2};
    if (word == "m3") return {.metres = 3};
    if (word == "diagonal") return {.diagonals = 1};
    if (word == "height") return {.heights = 1};
    return {};
}

std::string to_text(const FormulaUnit& unit) {
    std::string above, below;
    for (const auto& [word, exponent] : {std::pair("m", unit.metres),
                                         {"degrees", unit.degrees},
                                         {"diagonal", unit.diagonals},
                                         {"height", unit.heights}}) {
        if (exponent == 0) continue;
        std::string& side = exponent > 0 ? above : below;
        const int power = std::abs(exponent);
        side += fmt::format("{}{}{}", side.empty() ? "" : " ", word, power == 1 ? "" : std::to_string(power));
    }
    return fmt::format("{}{}{}", above.empty() ? "1" : above, below.empty() ? "" : "/", below);
}

void fail_at_word(const std::string& word, const std::string& text, std::span<const std::string> names,
                  const std::string& why) {
    // "l0/l3" and "length-share" hold a sign themselves: what the word is a part of may be what is misspelt.
    const std::size_t at = text.find(word), before = text.find_last_of("+*/(", at);
    const std::size_t from = before == std::string::npos ? 0 : before + 1, to = text.find_first_of("+*/)", at);
    const std::vector<std::string> written{text, text.substr(from, to == std::string::npos ? to : to - from), word};
    for (const std::string& phrase : written)
        for (const std::string& name : names)
            if (is_spelled_alike(phrase, name))
                throw OntologyError(fmt::format("there is no measure \"{}\"{}", phrase, did_you_mean({phrase}, names)));
    if (!why.empty()) throw OntologyError(why);
    throw OntologyError(fmt::format("there is no measure \"{}\"{}", word, did_you_mean(written, names, Nearness::any)));
}

void fail_at_phrase(const std::string& phrase, const std::string& word, std::span<const std::string> names) {
    const auto nearest = [&](const std::string& written) {
        std::size_t least = std::numeric_limits<std::size_t>::max();
        for (const std::string& name : names) least = std::min(least, distance_in_words(written, name));
        return least;
    };
    constexpr std::size_t longest = 150;
    if (phrase.size() > longest || nearest(phrase) > nearest(word)) return;
    if (const std::string meant = did_you_mean({phrase}, names); !meant.empty())
        throw OntologyError(fmt::format("there is no measure \"{}\"{}", phrase, meant));
}

namespace {

std::optional<double> value_of(const Formula& formula, const Object& object, const RegionMeasurements& region) {
    return run(formula, [&](const Measure& measure) { return measure_once(measure, object, region); });
}

}  // namespace

Formula parse_formula(const std::string& text) {
    const auto elsewhere = [](const std::string& word) {
        const RelationMeasure* between = find_relation_measure(word);
        return between ? fmt::format(
                             "\"{}\" is measured between {} regions; name it in a core:criterion of a relation, "
                             "or measure one region",
                             word, between->arity)
                       : std::string();
    };
    return FormulaParser<Measure>(text, all_measures(), elsewhere).parse();
}

std::optional<double> evaluate(const Formula& formula, const Object& object, const RegionMeasurements& region) {
    if (formula.needs_metres && !object.placement.metres_per_unit) return std::nullopt;
    const std::optional<double> value = value_of(formula, object, region);
    if (!value || std::isnan(*value)) return std::nullopt;
    if (formula.steps.size() > 1) region.asked[formula.text] = *value;
    return value;
}

}  // namespace partonomy
