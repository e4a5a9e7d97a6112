/* The literals that an ontology can tell apart.

   Each datatype with facets that is mentioned is a condition; two literals that satisfy the same conditions, and
   neither of which is mentioned itself, are interchangeable. So each family of values is cut where a condition or a
   literal cuts it (owl:real into open intervals and points, each by kind: integer, decimal, rational, irrational;
   doubles and floats, of which there are finitely many, at ordinals; strings by text_languages), pieces that satisfy
   the same conditions are put together, and their literals counted: 9 integers between 0 and 10, one double between two
   neighbours' neighbours. All families that nobody mentions are one cell, which is infinite.

   Cost: (constants + 1) × conditions, plus the automaton of the strings. */

#include "knowledge/data_cells.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "owl/words.h"

namespace partonomy::knowledge::closed {
namespace {

using Known = Datatype::Known;
using owl::DataRange;
using owl::DataRangeKind;

constexpr int max_depth = 500;
constexpr std::size_t max_work = 100'000'000;

std::string facet_name(const owl::Iri& facet) { return facet.substr(facet.find_last_of('#') + 1); }

bool is_floating(Known known) { return known == Known::doubles || known == Known::floats; }

Family family_of(Known known) {
    return known == Known::numbers ? Family::number
                                   : (known == Known::doubles ? Family::double_number : Family::float_number);
}

/// The bound that a facet of a numeric datatype gives, in the family of that datatype.
DataValue bound_of(const owl::Iri& facet, const owl::Literal& literal, Known known) {
    const DataValue written = value_of(literal);
    const DataValue bound = converted(written, family_of(known));
    if (bound.family != family_of(known) || std::isnan(bound.real)) {
        throw CannotGround{"the facet xsd:" + facet_name(facet) + " needs a number instead of \"" + literal.value +
                           "\""};
    }
    return bound;
}

std::uint64_t length_of(const owl::Iri& facet, const owl::Literal& literal) {
    const DataValue value = value_of(literal);
    if (value.family != Family::number || kind_of(value.number) != NumberKind::integer || value.number < 0 ||
        value.number > 1'000'000'000)
        throw CannotGround{"the facet xsd:" + facet_name(facet) + " needs a natural number instead of \"" +
                           literal.value + "\""};
    return value.number.get_num().get_ui();
}

[[noreturn]] void refuse_facet(const owl::Iri& facet, const owl::Iri& datatype) {
    throw CannotGround{
        "the facet " + owl::short_name(facet) + " is not supported for " + owl::short_name(datatype) +
        "; use minInclusive, minExclusive, maxInclusive, maxExclusive with numbers, and length, minLength, "
        "maxLength, pattern with xsd:string"};
}

/// The shortest text that reads back as the same double.
std::string shortest(double real) {
    if (std::isinf(real)) return real < 0 ? "-INF" : "INF";
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, real).ptr};
}

/// Places of doubles or floats, first to last.
struct Places {
    std::int64_t first, last;
};

Places all_places(Family family) {
    DataValue infinity;
    infinity.family = family;
    infinity.real = HUGE_VAL;
    const std::int64_t last = ordinal_of(infinity);
    return {-last - 1, last};
}

}  // namespace

struct DataCells::Condition {
    Known known = Known::everything;
    owl::Iri datatype;
    NumberKind kind = NumberKind::irrational;
    struct Bound {
        mpq_class number;
        bool inclusive = true;
    };
    std::vector<Bound> above, below;  ///< of numbers
    Places places{};                  ///< of doubles and floats
    bool nan = false;
    std::vector<std::size_t> languages;  ///< of texts

    Condition(const DataRange& range, TextLanguages& texts) : datatype(range.datatype) {
        const Datatype type = datatype_of(range.datatype);
        known = type.known;
        kind = type.kind;
        if (type.lowest != nullptr) above.push_back({mpq_class(type.lowest), true});
        if (type.highest != nullptr) below.push_back({mpq_class(type.highest), true});
        if (type.pattern != nullptr) languages.push_back(texts.add_pattern(type.pattern));
        if (is_floating(known)) {
            places = all_places(family_of(known));
            nan = range.facets.empty();
        }
        for (const auto& [facet, literal] : range.facets) add_facet(facet, literal, texts);
    }

    void add_facet(const owl::Iri& facet, const owl::Literal& literal, TextLanguages& texts) {
        const std::string name = facet.starts_with(owl::xsd_prefix) ? facet_name(facet) : "";
        const bool is_minimum = name == "minInclusive" || name == "minExclusive";
        const bool is_bound = is_minimum || name == "maxInclusive" || name == "maxExclusive";
        const bool is_inclusive = name == "minInclusive" || name == "maxInclusive";
        if (is_bound && known == Known::numbers) {
            (is_minimum ? above : below).push_back({bound_of(facet, literal, known).number, is_inclusive});
        } else if (is_bound && is_floating(known)) {
            DataValue bound = bound_of(facet, literal, known);
            // Both zeros are equal here: an inclusive bound takes both, an exclusive one neither.
            if (bound.real == 0) bound.real = is_minimum == is_inclusive ? -0.0 : 0.0;
            const std::int64_t place = ordinal_of(bound);
            if (is_minimum) places.first = std::max(places.first, is_inclusive ? place : place + 1);
            if (!is_minimum) places.last = std::min(places.last, is_inclusive ? place : place - 1);
        } else if (known == Known::texts && name == "pattern") {
            languages.push_back(texts.add_pattern(literal.value));
        } else if (known == Known::texts && name == "length") {
            languages.push_back(texts.add_length(length_of(facet, literal), length_of(facet, literal)));
        } else if (known == Known::texts && name == "minLength") {
            languages.push_back(texts.add_length(length_of(facet, literal), uncountable));
        } else if (known == Known::texts && name == "maxLength") {
            languages.push_back(texts.add_length(0, length_of(facet, literal)));
        } else {
            refuse_facet(facet, datatype);
        }
    }
};

/// Collects cells, family by family.
struct DataCells::Cutter {
    std::vector<Condition> conditions;
    const std::vector<DataValue>& values;
    TextLanguages& texts;
    std::vector<Cell> cells = {};
    std::vector<std::vector<bool>> inside = {};  ///< by cell, then condition
    std::map<std::vector<bool>, std::size_t> anonymous = {};

    /// A piece of the literals; pieces without a value of their own that satisfy the same conditions are one cell.
    void add(std::uint64_t capacity, const std::vector<bool>& satisfied, std::optional<DataValue> value) {
        if (capacity == 0) return;
        if (!value) {
            const auto [found, is_new] = anonymous.try_emplace(satisfied, cells.size());
            if (!is_new) {
                cells[found->second].capacity = saturating_sum(cells[found->second].capacity, capacity);
                return;
            }
        }
        cells.push_back({capacity, std::move(value)});
        inside.push_back(satisfied);
    }

    template <class Test>
    std::vector<bool> satisfied(Test test) const {
        std::vector<bool> result;
        for (const Condition& condition : conditions)
            result.push_back(condition.known == Known::everything || test(condition));
        return result;
    }

    [[nodiscard]] bool mentions(Family family, Known known) const {
        return std::ranges::any_of(conditions, [&](const Condition& each) { return each.known == known; }) ||
               std::ranges::any_of(values, [&](const DataValue& each) { return each.family == family; });
    }

    void limit(std::size_t pieces) const {
        if (pieces * conditions.size() > max_work) {
            throw CannotGround{"there are too many different data ranges (" + std::to_string(conditions.size()) +
                               ") over one data property; use fewer thresholds"};
        }
    }

    void cut_numbers() {
        std::vector<mpq_class> points;
        std::set<std::size_t> known;  // points that are values
        for (const Condition& condition : conditions) {
            for (const auto& bound : condition.above) points.push_back(bound.number);
            for (const auto& bound : condition.below) points.push_back(bound.number);
        }
        for (const DataValue& value : values)
            if (value.family == Family::number) points.push_back(value.number);
        std::ranges::sort(points, [](const mpq_class& a, const mpq_class& b) { return a < b; });
        points.erase(std::unique(points.begin(), points.end()), points.end());
        limit(8 * points.size() + 4);
        const auto index = [&](const mpq_class& number) {
            const auto found = std::lower_bound(points.begin(), points.end(), number);
            return static_cast<std::size_t>(found - points.begin());
        };
        for (const DataValue& value : values)
            if (value.family == Family::number) known.insert(index(value.number));

        // Place 2i + 1 is point i, place 2i the gap before it.
        std::vector<std::pair<std::size_t, std::size_t>> places;
        for (const Condition& condition : conditions) {
            std::size_t first = 0, last = 2 * points.size();
            for (const auto& [number, inclusive] : condition.above)
                first = std::max(first, 2 * index(number) + (inclusive ? 1 : 2));
            for (const auto& [number, inclusive] : condition.below)
                last = std::min(last, 2 * index(number) + (inclusive ? 1 : 0));
            places.emplace_back(first, last);
        }
        const auto satisfied_at = [&](std::size_t place, NumberKind kind) {
            return satisfied([&](const Condition& condition) {
                const auto& [first, last] = places[static_cast<std::size_t>(&condition - conditions.data())];
                return condition.known == Known::numbers && kind <= condition.kind && first <= place && place <= last;
            });
        };
        for (std::size_t i = 0; i <= points.size(); ++i) {
            add(integers_between(points, i), satisfied_at(2 * i, NumberKind::integer), std::nullopt);
            for (const NumberKind kind : {NumberKind::decimal, NumberKind::rational, NumberKind::irrational})
                add(uncountable, satisfied_at(2 * i, kind), std::nullopt);
            if (i == points.size()) break;
            std::optional<DataValue> value;
            if (known.contains(i)) {
                value.emplace().family = Family::number;
                value->number = points[i];
            }
            add(1, satisfied_at(2 * i + 1, kind_of(points[i])), std::move(value));
        }
    }

    /// How many integers lie strictly between point i - 1 and point i.
    static std::uint64_t integers_between(const std::vector<mpq_class>& points, std::size_t i) {
        if (i == 0 || i == points.size()) return uncountable;
        mpz_class first, last;
        mpz_fdiv_q(first.get_mpz_t(), points[i - 1].get_num_mpz_t(), points[i - 1].get_den_mpz_t());
        mpz_cdiv_q(last.get_mpz_t(), points[i].get_num_mpz_t(), points[i].get_den_mpz_t());
        const mpz_class count = last - first - 1;
        return count.fits_ulong_p() ? count.get_ui() : uncountable;
    }

    void cut_floating(Family family, Known known) {
        std::vector<std::int64_t> cuts;  // before this place
        const auto [first, last] = all_places(family);
        cuts.insert(cuts.end(), {first, last + 1});
        for (const Condition& condition : conditions)
            if (condition.known == known && condition.places.first <= condition.places.last)
                cuts.insert(cuts.end(), {condition.places.first, condition.places.last + 1});
        std::map<std::int64_t, const DataValue*> known_values;
        const DataValue* nan = nullptr;
        for (const DataValue& value : values) {
            if (value.family != family) continue;
            if (std::isnan(value.real)) {
                nan = &value;
                continue;
            }
            known_values[ordinal_of(value)] = &value;
            cuts.insert(cuts.end(), {ordinal_of(value), ordinal_of(value) + 1});
        }
        std::ranges::sort(cuts);
        cuts.erase(std::ranges::unique(cuts).begin(), cuts.end());
        limit(cuts.size());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const auto found = known_values.find(cuts[i]);
            add(static_cast<std::uint64_t>(cuts[i + 1]) - static_cast<std::uint64_t>(cuts[i]),
                satisfied([&](const Condition& condition) {
                    return condition.known == known && condition.places.first <= cuts[i] &&
                           cuts[i] <= condition.places.last;
                }),
                found == known_values.end() ? std::nullopt : std::optional(*found->second));
        }
        add(1, satisfied([&](const Condition& condition) { return condition.known == known && condition.nan; }),
            nan == nullptr ? std::nullopt : std::optional(*nan));
    }

    void cut_texts() {
        std::vector<TextLanguages::Cell> cells_of_texts = texts.cut();
        const auto conditions_of = [&](const std::vector<bool>& inside_languages) {
            return satisfied([&](const Condition& condition) {
                if (condition.known == Known::all_texts) return true;
                return condition.known == Known::texts &&
                       std::ranges::all_of(condition.languages, [&](std::size_t i) { return inside_languages[i]; });
            });
        };
        for (const DataValue& value : values) {
            if (value.family != Family::text) continue;
            const std::vector<bool> languages = texts.inside(value.text);
            const auto cell = std::ranges::find(cells_of_texts, languages, &TextLanguages::Cell::inside);
            if (cell != cells_of_texts.end() && cell->capacity != uncountable) --cell->capacity;
            add(1, conditions_of(languages), value);
        }
        for (const TextLanguages::Cell& cell : cells_of_texts)
            add(cell.capacity, conditions_of(cell.inside), std::nullopt);
    }

    /// A family of which only the values mentioned are known; `rest` is how many more there are.
    template <class Belongs, class Test>
    void cut_by_values(Belongs belongs, std::uint64_t rest, Test test) {
        for (const DataValue& value : values)
            if (belongs(value)) add(1, satisfied(test), value);
        add(rest, satisfied(test), std::nullopt);
    }

    void cut_all() {
        if (mentions(Family::number, Known::numbers)) cut_numbers();
        if (mentions(Family::double_number, Known::doubles)) cut_floating(Family::double_number, Known::doubles);
        if (mentions(Family::float_number, Known::floats)) cut_floating(Family::float_number, Known::floats);
        const bool any_text = mentions(Family::text, Known::all_texts);
        if (any_text || mentions(Family::text, Known::texts)) cut_texts();
        if (any_text || mentions(Family::tagged_text, Known::tagged_texts)) {
            cut_by_values([](const DataValue& value) { return value.family == Family::tagged_text; }, uncountable,
                          [](const Condition& condition) {
                              return condition.known == Known::all_texts || condition.known == Known::tagged_texts;
                          });
        }
        if (mentions(Family::truth, Known::truths)) {
            const auto is_truth = [](const DataValue& value) { return value.family == Family::truth; };
            cut_by_values(is_truth, 2 - static_cast<std::uint64_t>(std::ranges::count_if(values, is_truth)),
                          [](const Condition& condition) { return condition.known == Known::truths; });
        }
        std::set<owl::Iri> others;
        for (const Condition& condition : conditions)
            if (condition.known == Known::others) others.insert(condition.datatype);
        for (const DataValue& value : values)
            if (value.family == Family::other) others.insert(value.tag);
        for (const owl::Iri& datatype : others) {
            cut_by_values(
                [&](const DataValue& value) { return value.family == Family::other && value.tag == datatype; },
                uncountable,
                [&](const Condition& condition) {
                    return condition.known == Known::others && condition.datatype == datatype;
                });
        }
        add(uncountable, satisfied([](const Condition&) { return false; }), std::nullopt);
    }
};

void DataCells::mention(const DataRange& range, int depth) {
    if (depth > max_depth)
        throw CannotGround{"its data ranges are nested too deep, or a datatype is defined by itself"};
    if (range.kind == DataRangeKind::datatype) {
        const auto defined = definitions_->find(range.datatype);
        if (defined != definitions_->end()) {
            if (!range.facets.empty()) {
                throw CannotGround{"the datatype " + owl::short_name(range.datatype) +
                                   " is a defined one, so it cannot have facets; put them into its definition"};
            }
            return mention(*defined->second, depth + 1);
        }
        TextLanguages scratch;
        (void)Condition(range, scratch);  // says what is wrong while the axiom is known
        conditions_.try_emplace(range, conditions_.size());
    }
    for (const owl::Literal& literal : range.values) mention(literal);
    for (const DataRange& operand : range.operands) mention(operand, depth + 1);
}

void DataCells::mention(const owl::Literal& literal) {
    DataValue value = value_of(literal);
    const char* pattern = literal.language.empty() && !literal.datatype.empty() && value.family == Family::text
                              ? datatype_of(literal.datatype).pattern
                              : nullptr;
    if (pattern != nullptr) {
        TextLanguages check;
        (void)check.add_pattern(pattern);
        if (!check.inside(value.text)[0]) {
            throw CannotGround{"\"" + literal.value + "\" is no " + owl::short_name(literal.datatype) +
                               "; use xsd:string, or a text that is one"};
        }
    }
    if (value_ids_.try_emplace(key_of(value), values_.size()).second) values_.push_back(std::move(value));
}

void DataCells::cut() {
    TextLanguages texts;
    std::vector<const DataRange*> ranges(conditions_.size());
    for (const auto& [range, id] : conditions_) ranges[id] = &range;
    std::vector<Condition> conditions;
    for (const DataRange* range : ranges) conditions.emplace_back(*range, texts);
    Cutter cutter{std::move(conditions), values_, texts};
    cutter.cut_all();
    cells_ = std::move(cutter.cells);
    for (const auto& [range, id] : conditions_) {
        std::vector<bool>& inside = inside_[range];
        for (const auto& satisfied : cutter.inside) inside.push_back(satisfied[id]);
    }
    value_cells_.resize(values_.size());
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
        if (cells_[cell].value) value_cells_[value_ids_.at(key_of(*cells_[cell].value))] = cell;
}

std::optional<std::size_t> DataCells::find(const owl::Literal& literal) const {
    const auto found = value_ids_.find(key_of(value_of(literal)));
    if (found == value_ids_.end()) return std::nullopt;
    return value_cells_.at(found->second);
}

std::vector<bool> DataCells::inside(const DataRange& range) const {
    std::vector<bool> result(cells_.size(), range.kind == DataRangeKind::intersection_of);
    switch (range.kind) {
        case DataRangeKind::datatype: {
            const auto defined = definitions_->find(range.datatype);
            return defined != definitions_->end() ? inside(*defined->second) : inside_.at(range);
        }
        case DataRangeKind::one_of:
            for (const owl::Literal& literal : range.values) result[find(literal).value()] = true;
            break;
        case DataRangeKind::complement_of:
            result = inside(range.operands.at(0));
            result.flip();
            break;
        case DataRangeKind::intersection_of:
        case DataRangeKind::union_of:
            for (const DataRange& operand : range.operands) {
                const std::vector<bool> other = inside(operand);
                for (std::size_t i = 0; i < result.size(); ++i)
                    result[i] = range.kind == DataRangeKind::union_of ? result[i] || other[i] : result[i] && other[i];
            }
            break;
    }
    return result;
}

DataRange with_typed_facets(const DataRange& range) {
    DataRange result = range;
    for (DataRange& operand : result.operands) operand = with_typed_facets(operand);
    if (range.kind != DataRangeKind::datatype || range.facets.empty()) return result;
    const Datatype type = datatype_of(range.datatype);
    if (!is_floating(type.known)) return result;
    for (auto& [facet, literal] : result.facets) {
        const bool is_written_exactly = datatype_of(literal.datatype).known == Known::numbers;
        const double real = bound_of(facet, literal, type.known).real;
        literal = {is_written_exactly ? literal.value : shortest(real), range.datatype, ""};
    }
    return result;
}

}  // namespace partonomy::knowledge::closed
