#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "knowledge/data_value.h"
#include "knowledge/text_languages.h"

// Inside the closed-world reasoner: the infinitely many literals, cut into finitely many cells.

namespace partonomy::knowledge::closed {

/// All literals of OWL 2, cut so finely that each of the data ranges mentioned is a union of cells and each literal
/// mentioned is a cell of its own; but no finer than the datatypes mentioned need.
class DataCells {
public:
    struct Cell {
        std::uint64_t capacity = 0;  ///< how many literals it has; `uncountable`: at least as many as anybody asks for
        std::optional<DataValue> value;  ///< the literal, of a cell that is one that was mentioned
    };

    /// Defined datatypes; those who mention a range expand it by them.
    using Definitions = std::map<owl::Iri, const owl::DataRange*>;
    explicit DataCells(const Definitions& definitions) : definitions_(&definitions) {}

    /// Both throw CannotGround.
    void mention(const owl::DataRange& range) { mention(range, 0); }
    void mention(const owl::Literal& literal);

    /// After everything is mentioned; throws CannotGround when there would be too many cells.
    void cut();

    [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
    /// The cell of a literal that was mentioned, nothing for others.
    [[nodiscard]] std::optional<std::size_t> find(const owl::Literal& literal) const;
    /// For each cell whether the range has its literals.
    [[nodiscard]] std::vector<bool> inside(const owl::DataRange& range) const;

private:
    /// A datatype with facets, as a condition on each family.
    struct Condition;
    struct Cutter;
    void mention(const owl::DataRange& range, int depth);

    const Definitions* definitions_;
    std::map<owl::DataRange, std::size_t> conditions_;  ///< datatypes with facets
    std::vector<DataValue> values_;
    std::map<std::string, std::size_t> value_ids_;  ///< by key_of
    std::vector<Cell> cells_;
    std::map<owl::DataRange, std::vector<bool>> inside_;
    std::vector<std::size_t> value_cells_;  ///< by values_
};

/// The facets as OWL 2 wants them: numbers as literals of the datatype restricted, "0.4"^^xsd:double for 0.4 in
/// xsd:double[>= 0.4].
[[nodiscard]] owl::DataRange with_typed_facets(const owl::DataRange& range);

}  // namespace partonomy::knowledge::closed
