// Whatever the bytes, parse_ontology returns an ontology or throws an Error that names the document; and what it
// returns can be said in Manchester syntax.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/errors.h"
#include "owl/ontology.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace partonomy;
    try {
        const owl::Ontology ontology =
            owl::parse_ontology(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
        for (const owl::Axiom& axiom : ontology.axioms) {
            if (owl::to_manchester(axiom).empty()) std::abort();
        }
    } catch (const Error& error) {
        if (!std::string(error.what()).starts_with("fuzz:")) std::abort();
    }
    return 0;
}
