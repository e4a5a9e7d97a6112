#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/formula.h"
#include "base/errors.h"

namespace partonomy {

/// Powers of what a value is counted in; fractions of the object's diagonal or height are no plain numbers.
struct FormulaUnit {
    int metres = 0, degrees = 0, diagonals = 0, heights = 0;
    bool is_number = false;  ///< of no unit so far: takes any
    bool operator==(const FormulaUnit&) const = default;
};
[[nodiscard]] FormulaUnit formula_unit(std::string_view word);
[[nodiscard]] std::string to_text(const FormulaUnit& unit);

/// Throws what is thrown for a word that is no measure: why it cannot stand here, where `why` says so, or the nearest
/// right names.
[[noreturn]] void fail_at_word(const std::string& word, const std::string& text, std::span<const std::string> names,
                               const std::string& why);

/// Throws what is thrown for a phrase that begins with a measure and goes on with a word, where the phrase comes at
/// least as near to a measure as the word alone does: "length inclinaton". Nothing where a sign is missing between two
/// measures.
void fail_at_phrase(const std::string& phrase, const std::string& word, std::span<const std::string> names);

/// Reads formulas over measures of one kind; see formula.cpp.
template <typename M>
class FormulaParser {
public:
    /// `elsewhere` says why a word that names no such measure cannot stand here; empty: it is misspelt.
    FormulaParser(const std::string& text, std::span<const M> measures,
                  std::function<std::string(const std::string&)> elsewhere)
        : text_(text), measures_(measures), elsewhere_(std::move(elsewhere)) {
        formula_.text = text;
    }

    FormulaOver<M> parse() {
        const FormulaUnit unit = sum();
        skip_blanks();
        fail_if_name_goes_on();
        if (at_ < text_.size()) fail(fmt::format("there should be + - * / before \"{}\"", text_.substr(at_)));
        formula_.unit = to_text(unit);
        formula_.needs_metres |= unit.metres != 0;
        return std::move(formula_);
    }

    [[noreturn]] void fail(const std::string& problem) const {
        throw OntologyError(fmt::format("the measure \"{}\" cannot be read: {}", text_, problem));
    }

private:
    using Operation = FormulaOperation;

    void skip_blanks() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    }

    bool take(char c) {
        skip_blanks();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    FormulaUnit sum() {
        FormulaUnit unit = product();
        while (true) {
            const bool add = take('+');
            if (!add && !take('-')) return unit;
            const FormulaUnit other = product();
            if (!unit.is_number && !other.is_number && unit != other)
                fail(fmt::format("it {} {} and {}", add ? "adds" : "subtracts", to_text(unit), to_text(other)));
            if (unit.is_number != other.is_number && (unit.metres != 0 || other.metres != 0))
                formula_.needs_metres = true;  // the number is one of metres
            if (unit.is_number) unit = other;
            formula_.steps.push_back({add ? Operation::add : Operation::subtract});
        }
    }

    FormulaUnit product() {
        FormulaUnit unit = factor();
        while (true) {
            const bool multiply = take('*');
            if (!multiply && !take('/')) return unit;
            const FormulaUnit other = factor();
            const int sign = multiply ? 1 : -1;
            unit = {unit.metres + sign * other.metres, unit.degrees + sign * other.degrees,
                    unit.diagonals + sign * other.diagonals, unit.heights + sign * other.heights,
                    unit.is_number && other.is_number};
            formula_.steps.push_back({multiply ? Operation::multiply : Operation::divide});
        }
    }

    FormulaUnit factor() {
        if (++depth_ > 100) fail("it is nested too deeply");
        FormulaUnit unit;
        if (take('-')) {
            unit = factor();
            formula_.steps.push_back({Operation::negate});
        } else if (take('(')) {
            unit = sum();
            if (!take(')')) {
                fail_if_name_goes_on();
                fail("a ) is missing");
            }
        } else if (const M* measure = name()) {
            formula_.steps.push_back({Operation::measure, measure});
            unit = formula_unit(measure->unit);
        } else {
            formula_.steps.push_back({Operation::number, nullptr, number()});
            unit.is_number = true;
        }
        --depth_;
        return unit;
    }

    static bool is_part_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

    /// The longest name of a measure here.
    const M* name() {
        skip_blanks();
        const std::string_view rest = std::string_view(text_).substr(at_);
        const M* longest = nullptr;
        for (const M& measure : measures_) {
            const std::string_view word = measure.name;
            if (rest.starts_with(word) && (rest.size() == word.size() || !is_part_of_word(rest[word.size()])) &&
                (!longest || word.size() > std::string_view(longest->name).size()))
                longest = &measure;
        }
        if (longest) {
            name_begins_ = at_;
            name_ends_ = at_ += std::string_view(longest->name).size();
        }
        return longest;
    }

    /// "length inclinaton" is not the measure "length" without a sign behind it.
    void fail_if_name_goes_on() {
        skip_blanks();
        if (at_ >= text_.size() || !is_part_of_word(text_[at_]) || name_ends_ == 0 ||
            text_.find_first_not_of(" \t\n\r", name_ends_) != at_)
            return;
        std::size_t end = std::min(text_.find_first_of("+-*/()", at_), text_.size());
        while (std::isspace(static_cast<unsigned char>(text_[end - 1]))) --end;
        const std::string word = text_.substr(at_, end - at_);
        fail_at_phrase(text_.substr(name_begins_, name_ends_ - name_begins_) + " " + word, word, names());
    }
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const M& measure : measures_) found.push_back(measure.name);
        return found;
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
        fail_at_word(word, text_, names(), elsewhere_(word));
    }

    const std::string& text_;
    std::span<const M> measures_;
    std::function<std::string(const std::string&)> elsewhere_;
    std::size_t at_ = 0;
    std::size_t name_begins_ = 0, name_ends_ = 0;  ///< of the last measure that was read
    int depth_ = 0;
    FormulaOver<M> formula_;
};

/// The value of a formula; nullopt when nothing can tell: where `value_of` cannot tell a measure's, or at a division by
/// zero.
template <typename M, typename ValueOf>
std::optional<double> run(const FormulaOver<M>& formula, const ValueOf& value_of) {
    using Operation = FormulaOperation;
    std::vector<double> stack;
    for (const auto& step : formula.steps) {
        if (step.operation == Operation::number) {
            stack.push_back(step.number);
            continue;
        }
        if (step.operation == Operation::measure) {
            const std::optional<double> x = value_of(*step.measure);
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

}  // namespace partonomy
