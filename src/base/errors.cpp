#include "base/errors.h"

namespace partonomy {

std::string at(const std::string& file, long line, const std::string& sentence) {
    if (file.empty()) return sentence;  // nothing to name: an ontology of text alone
    if (line > 0) return file + ":" + std::to_string(line) + ": " + sentence;
    return file + ": " + sentence;
}

}  // namespace partonomy
