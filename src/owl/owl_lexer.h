#pragma once

#include <map>
#include <string>
#include <string_view>

#include "owl/ontology.h"

namespace partonomy::owl {

enum class OwlToken {
    end,
    iri,       ///< text: between the brackets
    word,      ///< a keyword, name, prefixed name, _:label or number, as it stands; text: all of it
    string,    ///< text: the value, escapes resolved
    language,  ///< @en; text: "en"
    mark,      ///< ( ) { } [ ] , ? = < > <= >= ^^ ->
};

/// Cuts functional or Manchester syntax (valid UTF-8) into tokens. Throws OntologyError at the line of a token that is
/// none.
class OwlLexer {
public:
    OwlLexer(std::string_view document, const std::string& file) : text_(document), file_(file) {}

    void next();

    OwlToken kind = OwlToken::end;
    std::string text;
    long line = 1;  ///< where the token begins

    [[nodiscard]] bool is_mark(std::string_view mark) const { return kind == OwlToken::mark && text == mark; }
    [[nodiscard]] bool is_word(std::string_view word) const { return kind == OwlToken::word && text == word; }
    /// How an error sentence names the present token.
    [[nodiscard]] std::string shown() const;
    [[noreturn]] void fail(long where, const std::string& sentence) const;

private:
    [[nodiscard]] char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
    void read_iri();
    void read_string();
    void read_language();
    void read_word();
    bool read_mark();

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::size_t begin_ = 0;
    long at_line_ = 1;
};

/// The prefixes that a document declares, and those that OWL 2 declares for all.
class OwlPrefixes {
public:
    explicit OwlPrefixes(std::string base);

    /// `name` with its ':'.
    void declare(const std::string& name, const std::string& iri) { prefixes_[name] = iri; }
    /// The IRI that the lexer's token (iri or word) names. A word without ':' has the prefix ':'. Throws OntologyError.
    [[nodiscard]] Iri expand(const OwlLexer& lexer) const;
    [[nodiscard]] const std::string& base() const { return base_; }

private:
    [[nodiscard]] std::string right_prefix(const std::string& prefix, const std::string& local) const;
    std::string base_;
    std::map<std::string, std::string, std::less<>> prefixes_;
};

/// Whether a word begins as numbers do.
[[nodiscard]] bool is_number_word(std::string_view word);

}  // namespace partonomy::owl
