#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "owl/write_names.h"

namespace partonomy::owl {

/// The pieces one after the other. In a chain of + GCC 12 sees an overlap that is not there.
[[nodiscard]] std::string glued(std::initializer_list<std::string_view> pieces);

/// Expressions, ranges, literals and the atoms of rules as Turtle: a name, a literal, "[ … ]" or "( … )".
class TurtleExpressions {
public:
    explicit TurtleExpressions(WriteNames& names) : names_(names) {}

protected:
    [[nodiscard]] std::string show(const ClassExpression& expression);
    [[nodiscard]] std::string show(const DataRange& range);
    [[nodiscard]] std::string show(const PropertyExpression& property);
    [[nodiscard]] std::string show(const Literal& literal) { return literal_text(literal, names_, true); }
    [[nodiscard]] std::string show(const Iri& iri) { return names_(iri); }
    [[nodiscard]] std::string show(const RuleTerm& term);
    [[nodiscard]] std::string show(const RuleAtom& atom);
    /// The items from `from` on.
    template <typename Items>
    [[nodiscard]] std::string list(const Items& items, std::size_t from = 0) {
        std::string text = "(";
        for (std::size_t i = from; i < items.size(); ++i) text += glued({" ", show_item(items[i])});
        return text + " )";
    }
    [[nodiscard]] std::string show_item(const ClassPointer& item) { return show(*item); }
    template <typename Item>
    [[nodiscard]] std::string show_item(const Item& item) {
        return show(item);
    }

    WriteNames& names_;

private:
    [[nodiscard]] std::string restriction(const ClassExpression& expression, const char* word);
    [[nodiscard]] std::string cardinality(const ClassExpression& expression, const char* word, const char* qualified);
};

}  // namespace partonomy::owl
