#include "owl/owl_lexer.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/errors.h"
#include "base/spelling.h"
#include "owl/rdf_graph.h"
#include "owl/source_text.h"

namespace partonomy::owl {
namespace {

bool is_one_of(char c, const char* set) { return c != '\0' && std::strchr(set, c) != nullptr; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_control(char c) { return (static_cast<unsigned char>(c) < ' ' && !is_one_of(c, "\t\r\n")) || c == 127; }

}  // namespace

void OwlLexer::fail(long where, const std::string& sentence) const { throw OntologyError(at(file_, where, sentence)); }

std::string OwlLexer::shown() const {
    return kind == OwlToken::end ? "the end of the file" : quoted_token(text_, begin_, at_);
}

void OwlLexer::next() {
    if (at_ == 0 && text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    at_ = skip_blanks(text_, at_, at_line_);
    begin_ = at_;
    line = at_line_;
    text.clear();
    if (at_ >= text_.size()) {
        kind = OwlToken::end;
        return;
    }
    const char c = peek(0);
    if (is_control(c)) fail(line, "a control character stands where a name should be");
    if (c == '"') return read_string();
    if (c == '@') return read_language();
    if (read_mark()) return;
    if (c == '<') return read_iri();
    read_word();
}

bool OwlLexer::read_mark() {
    const char c = peek(0);
    const char after = peek(1);
    std::size_t length = 0;
    if (is_one_of(c, "(){}[],?=")) length = 1;
    if (c == '^') {
        if (after != '^') fail(line, "'^' alone has no meaning; a datatype is written '^^xsd:double'");
        length = 2;
    }
    if (c == '>') length = after == '=' ? 2 : 1;
    if (c == '<' && after == '=') length = 2;
    if (c == '<' && (is_digit(after) || is_one_of(after, " \t\r\n+-.\""))) length = 1;  // no IRI begins so
    if (c == '-' && after == '>') length = 2;
    if (length == 0) return false;
    kind = OwlToken::mark;
    text = std::string(text_.substr(at_, length));
    at_ += length;
    return true;
}

void OwlLexer::read_iri() {
    kind = OwlToken::iri;
    for (std::size_t end = at_ + 1;; ++end) {
        const char c = end < text_.size() ? text_[end] : '\n';
        if (c == '>') {
            text = std::string(text_.substr(at_ + 1, end - at_ - 1));
            at_ = end + 1;
            return;
        }
        if (c == '\n') fail(line, "the IRI that begins with '<' is not closed by '>' on its line");
        if (is_one_of(c, " \t\r<\"{}|\\^`") || is_control(c))
            fail(line, is_one_of(c, " \t\r") ? "an IRI cannot hold a space; write %20"
                                             : between("an IRI cannot hold '", std::string(1, c), "'"));
    }
}

/// A backslash hides a quotation mark or a backslash; before anything else it stands for itself, as the OWL API has it.
void OwlLexer::read_string() {
    kind = OwlToken::string;
    for (++at_;; ++at_) {
        if (at_ >= text_.size()) fail(line, "the string that begins here is never closed");
        char c = text_[at_];
        if (c == '"') break;
        if (c == '\n') ++at_line_;
        if (c == '\\' && is_one_of(peek(1), "\"\\")) c = text_[++at_];
        text += c;
    }
    ++at_;
}

void OwlLexer::read_language() {
    kind = OwlToken::language;
    std::size_t end = at_ + 1;
    while (end < text_.size() &&
           (is_digit(text_[end]) || text_[end] == '-' || ((text_[end] | 0x20) >= 'a' && (text_[end] | 0x20) <= 'z')))
        ++end;
    text = std::string(text_.substr(at_ + 1, end - at_ - 1));
    at_ = end;
    if (text.empty() || text.front() == '-' || text.back() == '-') fail(line, "'@' begins a language such as @en");
}

void OwlLexer::read_word() {
    kind = OwlToken::word;
    std::size_t end = at_;
    while (end < text_.size() && !is_one_of(text_[end], " \t\r\n(){}[]<>\"=,?^@#") && !is_control(text_[end])) {
        if (text_[end] == '\\' && end + 1 < text_.size()) ++end;
        ++end;
    }
    text = std::string(text_.substr(at_, end - at_));
    at_ = end;
}

OwlPrefixes::OwlPrefixes(std::string base) : base_(std::move(base)) {
    declare("owl:", owl_prefix);
    declare("rdf:", rdf_prefix);
    declare("rdfs:", rdfs_prefix);
    declare("xsd:", xsd_prefix);
    declare("swrl:", swrl_prefix);
    declare("swrlb:", swrlb_prefix);
}

/// What should stand there: a declared prefix that is spelled nearly so, or the one of core for a name of core.
std::string OwlPrefixes::right_prefix(const std::string& prefix, const std::string& local) const {
    const std::string how = "; declare it above as a Prefix, or write the name in full, <https://…>";
    if (local.empty()) return how;
    const bool is_of_core = core_ontology_text().find("\ncore:" + local + " a ") != std::string::npos;
    std::vector<std::string> names;
    for (const auto& [name, iri] : prefixes_) {
        if (is_of_core && iri == core_prefix) return "; did you mean \"" + name + local + "\"?";
        if (name.size() > 1) names.push_back(name);
    }
    if (is_of_core) return how + "; " + core_prefix + " is what core: stands for";
    const std::string meant = prefix.size() > 1 ? did_you_mean({prefix}, names) : "";
    return meant.empty() ? how : meant;
}

Iri OwlPrefixes::expand(const OwlLexer& lexer) const {
    if (lexer.kind == OwlToken::iri) return resolve_iri(base_, lexer.text);
    const std::string_view word = lexer.text;
    const std::size_t colon = word.find(':');
    const std::string prefix(colon == std::string_view::npos ? ":" : word.substr(0, colon + 1));
    const auto found = prefixes_.find(prefix);
    if (found == prefixes_.end()) {
        const std::string local(colon == std::string_view::npos ? word : word.substr(colon + 1));
        lexer.fail(lexer.line, "the prefix '" + prefix + "' of " + lexer.shown() + " is not declared" +
                                   right_prefix(prefix, local));
    }
    std::string iri = found->second;
    const std::string_view local = colon == std::string_view::npos ? word : word.substr(colon + 1);
    for (std::size_t i = 0; i < local.size(); ++i) {
        if (local[i] == '\\' && i + 1 < local.size()) ++i;
        iri += local[i];
    }
    return iri;
}

bool is_number_word(std::string_view word) {
    const std::size_t begin = !word.empty() && is_one_of(word[0], "+-") ? 1 : 0;
    return begin < word.size() &&
           (is_digit(word[begin]) || (word[begin] == '.' && begin + 1 < word.size() && is_digit(word[begin + 1])));
}

}  // namespace partonomy::owl
