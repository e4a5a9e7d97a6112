# cmake -DINPUT=core.ttl -DOUTPUT=core_ontology_text.cpp -P embed_text.cmake
# Writes a C++ file whose core_ontology_text() holds the bytes of INPUT. The text goes into an array of numbers: string
# literals have a length limit and escapes to get wrong.
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," numbers "${bytes}")
string(REGEX REPLACE "((0x..,){24})" "\\1\n    " numbers "${numbers}")
get_filename_component(name ${INPUT} NAME)
file(WRITE ${OUTPUT} "// Made from ${name} by embed_text.cmake.
#include \"owl/ontology.h\"

namespace partonomy::owl {
namespace {

constexpr unsigned char bytes[] = {
    ${numbers}
};

}  // namespace

const std::string& core_ontology_text() {
    static const std::string text(reinterpret_cast<const char*>(bytes), sizeof bytes);
    return text;
}

}  // namespace partonomy::owl
")
