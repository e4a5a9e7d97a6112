#include "owl/source_text.h"

#include <algorithm>

#include "owl/words.h"

namespace partonomy::owl {

std::size_t skip_blanks(std::string_view text, std::size_t at, long& line) {
    while (at < text.size()) {
        const char c = text[at];
        if (c == '\n') ++line;
        if (c == '#')
            at = std::min(text.find('\n', at), text.size());
        else if (c == ' ' || c == '\t' || c == '\r' || c == '\n')
            ++at;
        else
            break;
    }
    return at;
}

std::string quoted_token(std::string_view text, std::size_t begin, std::size_t end) {
    std::size_t length = std::min<std::size_t>(end - begin, 40);
    if (const auto stop = text.substr(begin, length).find('\n'); stop != std::string_view::npos) length = stop;
    while (length > 0 && begin + length < text.size() && (text[begin + length] & 0xC0) == 0x80) --length;
    return between("'", std::string(text.substr(begin, length)), begin + length < end ? "…'" : "'");
}

}  // namespace partonomy::owl
