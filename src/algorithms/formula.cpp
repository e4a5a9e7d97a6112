/* Combinations of measures in annotations.
 *
 * Names of measures have blanks and signs in them ("top height", "l0/l1"), so a name is the longest measure that the
 * text goes on with and that ends where a word ends; only then signs are operations. The usual precedence, by recursive
 * descent, into steps for a stack: parsed once, when the catalogue is made.
 *
 * Units are powers of metres and degrees. They multiply and divide freely; to be added they must be the same. A plain
 * number takes the unit of what it is added to: in "top height - 0.1" it is 0.1 m, so that formula needs a unit, while
 * "length / width" has the same value in any. */

#include "algorithms/formula.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "algorithms/measures.h"
#include "algorithms/relations.h"
#include "base/errors.h"
#include "base/spelling.h"

namespace partonomy {
namespace {

using Operation = Formula::Operation;

struct Unit {
    int metres = 0, degrees = 0;
    bool is_number = false;  ///< of no unit so far: takes any
    bool operator==(const Unit&) const = default;
};

Unit unit_of(std::string_view word) {
    if (word == "degrees") return {0, 1};
    if (word == "m") return {1, 0};
    if (word == "m2") return {2, 0};
    if (word == "m3") return {3, 0};
    return {};
}

std::string power(const char* word, int exponent) {
    return exponent <= 0 ? "" : exponent == 1 ? word : fmt::format("{}{}", word, exponent);
}

std::string to_text(const Unit& unit) {
    const auto both = [](const std::string& a, const std::string& b) {
        return fmt::format("{}{}{}", a, a.empty() || b.empty() ? "" : " ", b);
    };
    const std::string above = both(power("m", unit.metres), power("degrees", unit.degrees));
    const std::string below = both(power("m", -unit.metres), power("degrees", -unit.degrees));
    return fmt::format("{}{}{}", above.empty() ? "1" : above, below.empty() ? "" : "/", below);
}

bool is_part_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

class Parser {
public:
    explicit Parser(const std::string& text) : text_(text) { formula_.text = text; }

    Formula parse() {
        const Unit unit = sum();
        skip_blanks();
        if (at_ < text_.size()) fail(fmt::format("there should be + - * / before \"{}\"", text_.substr(at_)));
        formula_.unit = to_text(unit);
        formula_.needs_metres |= unit.metres != 0;
        return std::move(formula_);
    }

private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw OntologyError(fmt::format("the measure \"{}\" cannot be read: {}", text_, problem));
    }

    void skip_blanks() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    }

    bool take(char c) {
        skip_blanks();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    Unit sum() {
        Unit unit = product();
        while (true) {
            const bool add = take('+');
            if (!add && !take('-')) return unit;
            const Unit other = product();
            if (!unit.is_number && !other.is_number && unit != other)
                fail(fmt::format("it {} {} and {}", add ? "adds" : "subtracts", to_text(unit), to_text(other)));
            if (unit.is_number != other.is_number && (unit.metres != 0 || other.metres != 0))
                formula_.needs_metres = true;  // the number is one of metres
            if (unit.is_number) unit = other;
            formula_.steps.push_back({add ? Operation::add : Operation::subtract});
        }
    }

    Unit product() {
        Unit unit = factor();
        while (true) {
            const bool multiply = take('*');
            if (!multiply && !take('/')) return unit;
            const Unit other = factor();
            const int sign = multiply ? 1 : -1;
            unit = {unit.metres + sign * other.metres, unit.degrees + sign * other.degrees,
                    unit.is_number && other.is_number};
            formula_.steps.push_back({multiply ? Operation::multiply : Operation::divide});
        }
    }

    Unit factor() {
        if (++depth_ > 100) fail("it is nested too deeply");
        Unit unit;
        if (take('-')) {
            unit = factor();
            formula_.steps.push_back({Operation::negate});
        } else if (take('(')) {
            unit = sum();
            if (!take(')')) fail("a ) is missing");
        } else if (const Measure* measure = name()) {
            formula_.steps.push_back({Operation::measure, measure});
            unit = unit_of(measure->unit);
        } else {
            formula_.steps.push_back({Operation::number, nullptr, number()});
            unit.is_number = true;
        }
        --depth_;
        return unit;
    }

    /// The longest name of a measure here.
    const Measure* name() {
        skip_blanks();
        const std::string_view rest = std::string_view(text_).substr(at_);
        const Measure* longest = nullptr;
        for (const Measure& measure : all_measures()) {
            const std::string_view word = measure.name;
            if (rest.starts_with(word) && (rest.size() == word.size() || !is_part_of_word(rest[word.size()])) &&
                (!longest || word.size() > std::string_view(longest->name).size()))
                longest = &measure;
        }
        if (longest) at_ += std::string_view(longest->name).size();
        return longest;
    }

    double number() {
        double value = 0;
        const char* begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error == std::errc() && std::isfinite(value) && (at_ < text_.size() && !std::isalpha(text_[at_]))) {
            at_ += static_cast<std::size_t>(end - begin);
            return value;
        }
        std::string word = text_.substr(at_, text_.find_first_of("+-*/()", at_) - at_);
        while (!word.empty() && word.back() == ' ') word.pop_back();
        if (word.empty())
            fail(at_ < text_.size() ? fmt::format("a measure or a number should stand before \"{}\"", text_.substr(at_))
                                    : std::string("it ends where a measure or a number should stand"));
        if (const RelationMeasure* between = find_relation_measure(word))
            throw OntologyError(
                fmt::format("\"{}\" is measured between {} regions; name it in a core:criterion of a relation, or "
                            "measure one region",
                            word, between->arity));
        std::string nearest;  // all that are as near
        std::size_t distance = std::string::npos;
        for (const Measure& measure : all_measures()) {
            // "l0/l3" holds a sign itself: the whole text may be what is misspelt.
            for (const std::string& written : {word, text_})
                if (const std::size_t d = distance_in_words(written, measure.name); d <= distance) {
                    const std::string quoted = fmt::format("\"{}\"", measure.name);
                    if (d < distance) nearest.clear();
                    if (nearest.find(quoted) == std::string::npos) nearest += (nearest.empty() ? "" : " or ") + quoted;
                    distance = d;
                }
        }
        throw OntologyError(fmt::format("there is no measure \"{}\"; did you mean {}?", word, nearest));
    }

    const std::string& text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    Formula formula_;
};

std::optional<double> value_of(const Formula& formula, const Object& object, const RegionMeasurements& region) {
    std::vector<double> stack;
    for (const Formula::Step& step : formula.steps) {
        if (step.operation == Operation::number) {
            stack.push_back(step.number);
            continue;
        }
        if (step.operation == Operation::measure) {
            const std::optional<double> x = measure_once(*step.measure, object, region);
            if (!x) return std::nullopt;
            stack.push_back(*x);
            continue;
        }
        if (step.operation == Operation::negate) {
            stack.back() = -stack.back();
            continue;
        }
        const double b = stack.back();
        stack.pop_back();
        double& a = stack.back();
        switch (step.operation) {
            case Operation::add:
                a += b;
                break;
            case Operation::subtract:
                a -= b;
                break;
            case Operation::multiply:
                a *= b;
                break;
            default:
                if (b == 0) return std::nullopt;
                a /= b;
        }
    }
    return stack.back();
}

}  // namespace

Formula parse_formula(const std::string& text) { return Parser(text).parse(); }

std::optional<double> evaluate(const Formula& formula, const Object& object, const RegionMeasurements& region) {
    if (formula.needs_metres && !object.placement.metres_per_unit) return std::nullopt;
    const std::optional<double> value = value_of(formula, object, region);
    if (!value || std::isnan(*value)) return std::nullopt;
    if (formula.steps.size() > 1) region.asked[formula.text] = *value;
    return value;
}

}  // namespace partonomy
