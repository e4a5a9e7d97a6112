#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstdint>
#include <string>

#include "owl/ontology.h"

// Inside the closed-world reasoner: what a literal denotes.

namespace partonomy::knowledge::closed {

/// The parts of OWL 2's data domain; values of different families are different.
enum class Family {
    number,         ///< owl:real and all below it
    double_number,  ///< xsd:double, disjoint from owl:real
    float_number,   ///< xsd:float, disjoint from both
    text,           ///< xsd:string: sequences of characters
    tagged_text,    ///< rdf:langString: with a language
    truth,          ///< xsd:boolean
    other,          ///< of a datatype of which only equality is known: xsd:anyURI …
};

/// Where a number stands among the numbers that are not integers.
enum class NumberKind { integer, decimal, rational, irrational };

struct DataValue {
    Family family = Family::text;
    mpq_class number;  ///< of Family::number
    double real = 0;   ///< of double_number and float_number
    std::string text;  ///< of text, tagged_text; canonical form of truth and other
    std::string tag;   ///< language in lower case, or the datatype of `other`
};

/// Equal for identical values only: -0.0 is not 0.0, NaN is NaN.
[[nodiscard]] std::string key_of(const DataValue& value);

/// What is known about a named datatype.
struct Datatype {
    enum class Known { everything, numbers, doubles, floats, texts, all_texts, tagged_texts, truths, others } known;
    NumberKind kind = NumberKind::irrational;  ///< of numbers: the widest kind in it
    const char* lowest = nullptr;              ///< of bounded integers
    const char* highest = nullptr;
    const char* pattern = nullptr;  ///< of the types derived from xsd:string: what their values look like
};

/// What cannot be grounded, and why: "xsd:duration is not supported". Whoever knows the axiom adds it.
struct CannotGround {
    std::string why;
};

/// Throws CannotGround for a datatype that OWL 2 does not have.
[[nodiscard]] Datatype datatype_of(const owl::Iri& iri);

/// Throws CannotGround when the lexical form is none of its datatype.
[[nodiscard]] DataValue value_of(const owl::Literal& literal);

/// The same number in another numeric family, rounded to nearest: facets may be written as 0.4 for an xsd:double.
[[nodiscard]] DataValue converted(const DataValue& value, Family family);

[[nodiscard]] NumberKind kind_of(const mpq_class& number);

/// The place of a double (or float) among all of its kind: neighbours differ by 1, -0.0 comes right before 0.0.
[[nodiscard]] std::int64_t ordinal_of(const DataValue& value);

/// How XPath compares two numbers (a double beside a decimal turns the decimal into a double); unordered when one is
/// no number, or NaN.
[[nodiscard]] std::partial_ordering compare_numbers(const DataValue& a, const DataValue& b);

}  // namespace partonomy::knowledge::closed
