/* Literals as values: numbers of the owl:real family are exact rationals (GMP), whatever datatype they are written
   with, so that "1"^^xsd:integer and "1.00"^^xsd:decimal are one value, as OWL 2 (Structural Specification §4) says. */

#include "knowledge/data_value.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "owl/words.h"

namespace partonomy::knowledge::closed {
namespace {

using Known = Datatype::Known;

const std::map<std::string, Datatype>& datatypes() {
    constexpr const char* name_start = "[\\i-[:]][\\c-[:]]*";
    const auto numbers = [](NumberKind kind, const char* lowest = nullptr, const char* highest = nullptr) {
        return Datatype{Known::numbers, kind, lowest, highest, nullptr};
    };
    const auto integers = [&](const char* lowest, const char* highest) {
        return numbers(NumberKind::integer, lowest, highest);
    };
    const auto texts = [](const char* pattern) {
        return Datatype{Known::texts, NumberKind::irrational, nullptr, nullptr, pattern};
    };
    const auto plain = [](Known known) { return Datatype{known, NumberKind::irrational, nullptr, nullptr, nullptr}; };
    static const std::map<std::string, Datatype> table = [&] {
        std::map<std::string, Datatype> result;
        const std::string xsd = owl::xsd_prefix, owl_ = owl::owl_prefix, rdf = owl::rdf_prefix;
        result[std::string(owl::rdfs_prefix) + "Literal"] = plain(Known::everything);
        result[owl_ + "real"] = numbers(NumberKind::irrational);
        result[owl_ + "rational"] = numbers(NumberKind::rational);
        result[xsd + "decimal"] = numbers(NumberKind::decimal);
        result[xsd + "integer"] = integers(nullptr, nullptr);
        result[xsd + "nonNegativeInteger"] = integers("0", nullptr);
        result[xsd + "nonPositiveInteger"] = integers(nullptr, "0");
        result[xsd + "positiveInteger"] = integers("1", nullptr);
        result[xsd + "negativeInteger"] = integers(nullptr, "-1");
        result[xsd + "long"] = integers("-9223372036854775808", "9223372036854775807");
        result[xsd + "int"] = integers("-2147483648", "2147483647");
        result[xsd + "short"] = integers("-32768", "32767");
        result[xsd + "byte"] = integers("-128", "127");
        result[xsd + "unsignedLong"] = integers("0", "18446744073709551615");
        result[xsd + "unsignedInt"] = integers("0", "4294967295");
        result[xsd + "unsignedShort"] = integers("0", "65535");
        result[xsd + "unsignedByte"] = integers("0", "255");
        result[xsd + "double"] = plain(Known::doubles);
        result[xsd + "float"] = plain(Known::floats);
        result[xsd + "string"] = texts(nullptr);
        result[xsd + "normalizedString"] = texts("[^\\r\\n\\t]*");
        result[xsd + "token"] = texts("([^\\s]+( [^\\s]+)*)?");
        result[xsd + "language"] = texts("[a-zA-Z]{1,8}(-[a-zA-Z0-9]{1,8})*");
        result[xsd + "Name"] = texts("\\i\\c*");
        result[xsd + "NCName"] = texts(name_start);
        result[xsd + "NMTOKEN"] = texts("\\c+");
        result[rdf + "PlainLiteral"] = plain(Known::all_texts);
        result[rdf + "langString"] = plain(Known::tagged_texts);
        result[xsd + "boolean"] = plain(Known::truths);
        for (const char* name : {"anyURI", "hexBinary", "base64Binary", "dateTime"})
            result[xsd + name] = plain(Known::others);
        result[rdf + "XMLLiteral"] = plain(Known::others);
        return result;
    }();
    return table;
}

std::string trimmed(const std::string& text) {
    const char* space = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(space);
    return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(space) - begin + 1);
}

[[noreturn]] void refuse(const owl::Literal& literal, const std::string& example) {
    throw CannotGround{"\"" + literal.value + "\" is no " + owl::short_name(literal.datatype) + "; write it like " +
                       example};
}

/// White space as the types derived from xsd:string see it.
std::string normalized(const owl::Literal& literal) {
    std::string result;
    const bool is_collapsed = owl::local_name(literal.datatype) != "normalizedString";
    for (const char c : literal.value) {
        const bool is_space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
        if (!is_space) result += c;
        if (is_space && !(is_collapsed && (result.empty() || result.back() == ' '))) result += ' ';
    }
    if (is_collapsed && result.ends_with(' ')) result.pop_back();
    return result;
}

bool all_digits(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// [+-]digits[.digits], at least one digit; the point only where `with_point`.
mpq_class exact_number(const owl::Literal& literal, const std::string& text, bool with_point) {
    std::string_view rest = text;
    const bool is_negative = rest.starts_with('-');
    if (is_negative || rest.starts_with('+')) rest.remove_prefix(1);
    const std::size_t point = with_point ? rest.find('.') : std::string_view::npos;
    const std::string_view whole = rest.substr(0, point);
    const std::string_view fraction = point == std::string_view::npos ? std::string_view{} : rest.substr(point + 1);
    if (whole.size() + fraction.size() == 0 || !all_digits(whole) || !all_digits(fraction))
        refuse(literal, with_point ? "12 or 0.45" : "12");
    mpz_class top(std::string(whole) + std::string(fraction), 10), bottom;
    mpz_ui_pow_ui(bottom.get_mpz_t(), 10, fraction.size());
    mpq_class result(is_negative ? mpz_class(-top) : top, bottom);
    result.canonicalize();
    return result;
}

mpq_class rational_number(const owl::Literal& literal, const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return exact_number(literal, text, false);
    const mpq_class top = exact_number(literal, trimmed(text.substr(0, slash)), false);
    const std::string below = trimmed(text.substr(slash + 1));
    const mpq_class bottom = exact_number(literal, below, false);
    if (bottom <= 0 || below.starts_with('+')) refuse(literal, "1/3");
    return top / bottom;
}

template <class Real>
double floating_number(const owl::Literal& literal, std::string text) {
    if (text == "INF" || text == "+INF") return std::numeric_limits<double>::infinity();
    if (text == "-INF") return -std::numeric_limits<double>::infinity();
    if (text == "NaN") return std::numeric_limits<double>::quiet_NaN();
    if (text.starts_with('+')) text.erase(0, 1);
    if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos)
        refuse(literal, "0.45 or 4.5E-1");
    Real value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range && end == text.data() + text.size()) {
        const bool is_small = text.find("e-") != std::string::npos || text.find("E-") != std::string::npos;
        const double size = is_small ? 0.0 : std::numeric_limits<double>::infinity();
        return text.starts_with('-') ? -size : size;
    }
    if (error != std::errc{} || end != text.data() + text.size()) refuse(literal, "0.45 or 4.5E-1");
    return static_cast<double>(value);
}

std::string lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

DataValue number_value(mpq_class number) {
    DataValue result;
    result.family = Family::number;
    result.number = std::move(number);
    return result;
}

DataValue real_value(Family family, double real) {
    DataValue result;
    result.family = family;
    result.real = real;
    return result;
}

double nearest(const mpq_class& number, Family family) {
    // mpq_get_d truncates; its neighbours show which of them is nearest. Halfway cases go to the even one.
    const double low = number.get_d();
    double best = low;
    const auto distance = [&](double d) { return mpq_class(abs(mpq_class(d) - number)); };
    for (const double other : {std::nextafter(low, -HUGE_VAL), std::nextafter(low, HUGE_VAL)}) {
        if (!std::isfinite(other)) continue;
        const int order = cmp(distance(other), distance(best));
        if (order < 0 || (order == 0 && (std::bit_cast<std::uint64_t>(other) & 1U) == 0)) best = other;
    }
    return family == Family::float_number ? static_cast<double>(static_cast<float>(best)) : best;
}

}  // namespace

std::string key_of(const DataValue& value) {
    std::string key(1, static_cast<char>('a' + static_cast<int>(value.family)));
    if (value.family == Family::number) return key + value.number.get_str();
    if (value.family == Family::double_number || value.family == Family::float_number)
        return key + (std::isnan(value.real) ? "NaN" : std::to_string(ordinal_of(value)));
    return key + value.tag + "@" + value.text;  // no tag has an @
}

Datatype datatype_of(const owl::Iri& iri) {
    const auto found = datatypes().find(iri);
    if (found == datatypes().end()) {
        throw CannotGround{"the datatype " + owl::short_name(iri) +
                           " has no definition and is none of those that OWL 2 and this program know; use a numeric "
                           "datatype, xsd:string or xsd:boolean, or define it"};
    }
    return found->second;
}

DataValue value_of(const owl::Literal& literal) {
    DataValue result;
    if (!literal.language.empty()) {
        result.family = Family::tagged_text;
        result.text = literal.value;
        result.tag = lower_case(literal.language);
        return result;
    }
    result.text = literal.value;
    if (literal.datatype.empty()) return result;
    const Datatype type = datatype_of(literal.datatype);
    const std::string text = trimmed(literal.value);
    switch (type.known) {
        case Known::numbers: {
            const bool is_rational = type.kind == NumberKind::rational;
            if (type.kind == NumberKind::irrational) refuse(literal, "0.45, and give it the type xsd:decimal");
            mpq_class number = is_rational ? rational_number(literal, text)
                                           : exact_number(literal, text, type.kind == NumberKind::decimal);
            if ((type.lowest != nullptr && number < mpq_class(type.lowest)) ||
                (type.highest != nullptr && number > mpq_class(type.highest)))
                refuse(literal, std::string(type.lowest != nullptr ? type.lowest : type.highest));
            return number_value(std::move(number));
        }
        case Known::doubles:
            return real_value(Family::double_number, floating_number<double>(literal, text));
        case Known::floats:
            return real_value(Family::float_number, floating_number<float>(literal, text));
        case Known::truths:
            if (text != "true" && text != "false" && text != "1" && text != "0") refuse(literal, "true or false");
            result.family = Family::truth;
            result.text = text == "true" || text == "1" ? "true" : "false";
            return result;
        case Known::tagged_texts:
            refuse(literal, "\"seat\"@en");
        case Known::all_texts: {  // "seat@en", or "seat@" without a language
            const std::size_t mark = literal.value.rfind('@');
            if (mark == std::string::npos) refuse(literal, "\"seat@en\"");
            result.text = literal.value.substr(0, mark);
            result.tag = lower_case(literal.value.substr(mark + 1));
            if (!result.tag.empty()) result.family = Family::tagged_text;
            return result;
        }
        case Known::texts:
            if (type.pattern != nullptr) result.text = normalized(literal);
            return result;
        case Known::others:
        case Known::everything:
            break;
    }
    result.family = Family::other;
    result.text = text;
    result.tag = literal.datatype;
    return result;
}

DataValue converted(const DataValue& value, Family family) {
    const bool is_real = value.family == Family::double_number || value.family == Family::float_number;
    if (value.family == family || (!is_real && value.family != Family::number)) return value;
    if (family == Family::number) return std::isfinite(value.real) ? number_value(mpq_class(value.real)) : value;
    if (family != Family::double_number && family != Family::float_number) return value;
    if (is_real)
        return real_value(family, family == Family::float_number ? static_cast<float>(value.real) : value.real);
    return real_value(family, nearest(value.number, family));
}

NumberKind kind_of(const mpq_class& number) {
    mpz_class bottom = number.get_den();
    if (bottom == 1) return NumberKind::integer;
    for (const unsigned long factor : {2UL, 5UL})
        while (mpz_divisible_ui_p(bottom.get_mpz_t(), factor) != 0) bottom /= factor;
    return bottom == 1 ? NumberKind::decimal : NumberKind::rational;
}

std::int64_t ordinal_of(const DataValue& value) {
    if (value.family == Family::float_number) {
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value.real));
        const auto size = static_cast<std::int64_t>(bits & 0x7FFFFFFFU);
        return (bits >> 31) != 0 ? -size - 1 : size;
    }
    const auto bits = std::bit_cast<std::uint64_t>(value.real);
    const auto size = static_cast<std::int64_t>(bits & 0x7FFFFFFFFFFFFFFFU);
    return (bits >> 63) != 0 ? -size - 1 : size;
}

std::partial_ordering compare_numbers(const DataValue& a, const DataValue& b) {
    const auto is_number = [](const DataValue& value) {
        return value.family == Family::number || value.family == Family::double_number ||
               value.family == Family::float_number;
    };
    if (!is_number(a) || !is_number(b)) return std::partial_ordering::unordered;
    if (a.family == Family::number && b.family == Family::number) {
        const int order = cmp(a.number, b.number);
        return order < 0 ? std::partial_ordering::less
                         : (order > 0 ? std::partial_ordering::greater : std::partial_ordering::equivalent);
    }
    const bool has_double = a.family == Family::double_number || b.family == Family::double_number;
    const Family family = has_double ? Family::double_number : Family::float_number;
    return converted(a, family).real <=> converted(b, family).real;
}

}  // namespace partonomy::knowledge::closed
