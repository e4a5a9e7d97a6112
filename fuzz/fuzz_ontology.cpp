// Whatever the bytes, a reader gives an ontology or throws an Error that names the document; and what it gives can be said
// in Manchester syntax, written in both syntaxes that we write, and read back with as many axioms. FUZZ_READER is the
// reader's name; without it the syntax is recognised, as for files.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>

#include "base/errors.h"
#include "owl/imports.h"
#include "owl/write.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace partonomy::owl {
namespace {

Ontology read(const std::string& text) {
#ifdef FUZZ_READER
    Documents documents;
    documents.graphs.resize(1);
    documents.graphs[0].file = "fuzz";
    FUZZ_READER(text, "file:///fuzz", documents.graphs[0]);
    return merge(std::move(documents));
#else
    return parse_ontology(text, "fuzz");
#endif
}

}  // namespace
}  // namespace partonomy::owl

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace partonomy;
    const std::string text(reinterpret_cast<const char*>(data), size);
#ifdef FUZZ_READER
    if (!owl::is_utf8(text) || text.find('\0') != std::string::npos) return 0;  // refused before any reader
#endif
    owl::Ontology ontology;
    try {
        ontology = owl::read(text);
        for (const owl::Axiom& axiom : ontology.axioms) {
            if (owl::to_manchester(axiom).empty()) std::abort();
        }
    } catch (const Error& error) {
        if (!std::string(error.what()).starts_with("fuzz:")) std::abort();
        return 0;
    }
    const owl::WriteOptions merged = {.merge_imports = true};
    for (const std::string& written : {write_turtle(ontology, merged), write_functional(ontology, merged)}) {
        if (owl::parse_ontology(written, "written").axioms.size() != ontology.axioms.size()) std::abort();
    }
    return 0;
}
