#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "knowledge/configuration_set.h"

namespace partonomy::knowledge {

/// Some configurations of a listed space, ascending by their places in PlanRows. Deep in a tree few are left of many,
/// and a list of those is shorter than a bit for each.
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
};

/// Two sums over a set's configurations that stand for the set: what is left of a set has the difference. Two sets are
/// as likely to have the same as two numbers of 128 bits that were drawn at random.
struct RowSum {
    std::uint64_t first = 0, second = 0;
    bool operator==(const RowSum&) const = default;
    friend RowSum operator-(RowSum a, RowSum b) { return {a.first - b.first, a.second - b.second}; }
};

/// A listed space row by row: which label each configuration has, and which questions it answers with yes. Rows of one
/// label are neighbours.
class PlanRows {
public:
    /// Configurations that agree on each of `wanted` have the same label.
    PlanRows(std::size_t size, std::span<const ConfigurationSet> wanted,
             const std::vector<const ConfigurationSet*>& questions);

    [[nodiscard]] Rows rows_of(const ConfigurationSet& set) const;
    void count(RowSpan rows, RowCounts& counts) const;
    /// What is left of `whole` without `part`; not one of the two.
    void subtract(const RowCounts& whole, const RowCounts& part, RowCounts& rest) const;
    /// Only RowCounts::yes_in_all.
    [[nodiscard]] std::vector<std::uint32_t> count_yes(const ConfigurationSet& set) const;
    [[nodiscard]] bool has_one_label(RowSpan rows) const;
    [[nodiscard]] RowSum sum(RowSpan rows) const;
    /// Puts those that answer `question` with yes first, and says how many these are; the order is kept otherwise.
    std::size_t split(std::span<std::uint32_t> rows, std::size_t question, Rows& scratch) const;

private:
    std::size_t questions_, stride_;
    std::vector<std::uint32_t> place_;    ///< of each configuration
    std::vector<std::uint32_t> label_;    ///< by place, as all that follows; ascending
    std::vector<std::uint64_t> answers_;  ///< a byte for each question, 1 for yes; `stride_` words a row
    std::vector<unsigned char> is_yes_;   ///< the same, by question
    std::vector<RowSum> codes_;
};

/// Keeps a value for each set that it is shown.
class RowTable {
public:
    /// The place of the set's value, at first without one; until the next call.
    [[nodiscard]] std::optional<double>& value(RowSum set);

private:
    struct Entry {
        RowSum set;
        std::optional<double> value;
        bool is_used = false;
    };
    [[nodiscard]] Entry& place_of(RowSum set);

    std::vector<Entry> entries_;  ///< a power of two of them, at most half in use
    std::size_t used_ = 0;
};

}  // namespace partonomy::knowledge
