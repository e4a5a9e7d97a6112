#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "knowledge/configuration_set.h"

namespace partonomy::knowledge {

/// Some configurations of a listed space by their numbers, ascending. Deep in a tree few are left of many, and a list
/// of those is shorter than a bit for each.
using Rows = std::vector<std::uint32_t>;
using RowSpan = std::span<const std::uint32_t>;

/// How many of a set's configurations have each label, and how many of those answer each question with yes. Labels that
/// do not occur are left out.
struct RowCounts {
    std::size_t count = 0;
    std::vector<std::uint32_t> labels;      ///< ascending
    std::vector<std::uint32_t> sizes;       ///< by label
    std::vector<std::uint32_t> yes;         ///< by label, then question
    std::vector<std::uint32_t> yes_in_all;  ///< by question
    std::vector<std::uint32_t> place;       ///< of a label's yes, while counting
};

/// A listed space row by row: which label each configuration has, and which questions it answers with yes.
class PlanRows {
public:
    /// Every configuration is in one of `labels`; none means that all have the same.
    PlanRows(std::size_t size, const std::vector<ConfigurationSet>& labels,
             const std::vector<const ConfigurationSet*>& questions);

    void count(RowSpan rows, RowCounts& counts) const;
    /// What is left of `whole` without `part`; not one of the two.
    void subtract(const RowCounts& whole, const RowCounts& part, RowCounts& rest) const;
    /// Only RowCounts::yes_in_all.
    [[nodiscard]] std::vector<std::uint32_t> count_yes(const ConfigurationSet& set) const;
    [[nodiscard]] bool has_one_label(RowSpan rows) const;

private:
    std::size_t questions_, labels_;
    std::vector<std::uint32_t> label_, first_, yes_;  ///< of row i the questions yes_[first_[i]] to yes_[first_[i + 1]]
};

/// Numbers the sets that it is shown, and keeps a value for each.
class RowTable {
public:
    /// The same number for the same set, which is ascending and not empty; a new one has no value.
    [[nodiscard]] std::size_t number_of(RowSpan rows);
    [[nodiscard]] std::optional<double>& value(std::size_t number) { return values_[number]; }

private:
    struct Entry {
        std::uint64_t hash = 0;
        std::size_t first = 0, size = 0;  ///< in rows_; no size: a free place
        std::size_t number = 0;
    };
    [[nodiscard]] Entry& place_of(std::uint64_t hash, RowSpan rows);
    [[nodiscard]] std::uint64_t hash_of(RowSpan rows);

    std::vector<Entry> entries_;  ///< a power of two of them, at most half in use
    Rows rows_;
    std::vector<std::uint64_t> codes_;  ///< by row: scrambled, to be summed up
    std::vector<std::optional<double>> values_;
};

/// Puts those that are in `yes` first, and says how many these are; the order is kept otherwise.
std::size_t split(std::span<std::uint32_t> rows, const ConfigurationSet& yes, Rows& scratch);

[[nodiscard]] Rows rows_of(const ConfigurationSet& set);

}  // namespace partonomy::knowledge
