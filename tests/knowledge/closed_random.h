#pragma once

#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "knowledge/closed_world.h"

/// Random closed knowledge bases over every construct of OWL 2, within OWL 2 DL (so that HermiT takes them).
namespace closed_random {

using namespace partonomy;
using namespace partonomy::owl;

/// How often each construct occurs, by name.
using Census = std::map<std::string, int>;

/// What may occur: the signature, and whether built-ins and data may.
struct Shape {
    int individuals = 3, classes = 3, properties = 2, data_properties = 2;
    std::size_t axioms = 6;
    bool built_ins = false;   ///< which HermiT does not know
    bool small_data = false;  ///< integers 0 and 1 only, cardinalities of data to 1, no `t`: for enumeration
};

class Generator {
public:
    Generator(unsigned seed, Shape shape);
    [[nodiscard]] knowledge::ClosedWorld world();

private:
    unsigned below(unsigned n) { return static_cast<unsigned>(random_()) % n; }
    bool chance(unsigned percent) { return below(100) < percent; }
    Iri individual();
    Iri klass();
    PropertyExpression simple(bool with_inverse = true);
    PropertyExpression any_property();
    PropertyExpression data_property();
    std::vector<Iri> some_individuals(unsigned least, unsigned most);
    std::string numeric_datatype();
    Literal number_literal(const std::string& datatype);
    Literal literal();
    DataRange datatype_with_facets();
    DataRange range(int depth);
    ClassPointer expression(int depth);
    ClassPointer data_restriction();
    std::vector<ClassPointer> expressions(unsigned count, int depth);
    Axiom axiom();
    Axiom of_kind(AxiomKind kind);
    void rule(Axiom& axiom);
    Axiom fact(AxiomKind kind, const Iri& about);
    /// Axioms that random ones hardly ever come to together: keys that bind, relations between things, wholes and
    /// parts.
    void key_of_two(std::vector<Axiom>& axioms);
    void relation(std::vector<Axiom>& axioms);
    void whole(std::vector<Axiom>& axioms);

    std::mt19937 random_;
    Shape shape_;
    bool has_definition_ = false;
    std::set<Iri> unions_;  ///< classes that a DisjointUnion defines
};

/// Adds what `world` has to the census.
void count(const knowledge::ClosedWorld& world, Census& census);

/// Names of all constructs that a census should have; with `built_ins` the comparisons of rules too.
[[nodiscard]] std::vector<std::string> all_constructs(bool built_ins);

[[nodiscard]] Iri iri(const std::string& name);

}  // namespace closed_random
