#pragma once

#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace partonomy::knowledge {

class Diagram;

/// A subset of a space's configurations. Sets that meet in an operation belong to the same space.
///
/// In a *listed* space a set has a bit for each configuration. In a *compiled* one (too many to list) it says which
/// literals of the space's diagram hold, and every question to it is a sweep over the diagram. What questions and
/// answers make of sets are such conjunctions; the few operations that would lead out of them throw std::logic_error.
class ConfigurationSet {
public:
    ConfigurationSet() = default;
    explicit ConfigurationSet(std::size_t size, bool full = false);
    /// Of a listed space: the `run` configurations from `first` on, and the same again after each `period` >= first +
    /// run.
    [[nodiscard]] static ConfigurationSet every(std::size_t size, std::size_t first, std::size_t run,
                                                std::size_t period);
    /// Of a compiled space: the configurations in which every literal holds.
    ConfigurationSet(std::shared_ptr<const Diagram> diagram, std::vector<int> literals);

    [[nodiscard]] std::size_t size() const { return size_; }  ///< of the space; 0 for a compiled one
    [[nodiscard]] std::size_t count() const;                  ///< configurations in the set, at most SIZE_MAX
    [[nodiscard]] std::string count_text() const;             ///< exact, however many
    [[nodiscard]] bool is_empty() const;

    [[nodiscard]] bool is_subset_of(const ConfigurationSet& other) const;
    [[nodiscard]] bool intersects(const ConfigurationSet& other) const;
    [[nodiscard]] std::size_t count_common(const ConfigurationSet& other) const;  ///< at most SIZE_MAX
    /// The fraction of this set that lies in `other`; 0 when this set is empty.
    [[nodiscard]] double share(const ConfigurationSet& other) const;
    ConfigurationSet& operator&=(const ConfigurationSet& other);
    /// Compiled: only when one holds the other.
    ConfigurationSet& operator|=(const ConfigurationSet& other);
    /// Compiled: only what is told by one literal can be taken away.
    ConfigurationSet& operator-=(const ConfigurationSet& other);
    [[nodiscard]] ConfigurationSet complement() const;
    [[nodiscard]] std::size_t hash() const;

    /// Of listed spaces only: single configurations, by number.
    [[nodiscard]] bool has(std::size_t i) const { return (words_[i / 64] >> (i % 64)) & 1U; }
    void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
    /// The configuration with the lowest number.
    [[nodiscard]] std::optional<std::size_t> first() const;
    /// Calls `visit(i)` for each configuration in the set, ascending.
    template <typename Visit>
    void for_each(Visit&& visit) const {
        for (std::size_t w = 0; w < words_.size(); ++w)
            for (std::uint64_t word = words_[w]; word != 0; word &= word - 1)
                visit(w * 64 + static_cast<std::size_t>(std::countr_zero(word)));
    }
    /// This set in the smaller space that only has the configurations of `kept`, renumbered in their order.
    [[nodiscard]] ConfigurationSet packed(const ConfigurationSet& kept) const;

    /// Of compiled spaces only.
    [[nodiscard]] const Diagram& diagram() const;
    [[nodiscard]] const std::vector<int>& literals() const;

    friend ConfigurationSet operator&(ConfigurationSet a, const ConfigurationSet& b) { return a &= b; }
    friend ConfigurationSet operator|(ConfigurationSet a, const ConfigurationSet& b) { return a |= b; }
    friend ConfigurationSet operator-(ConfigurationSet a, const ConfigurationSet& b) { return a -= b; }
    friend bool operator==(const ConfigurationSet& a, const ConfigurationSet& b) { return (a <=> b) == 0; }
    friend std::strong_ordering operator<=>(const ConfigurationSet& a, const ConfigurationSet& b);

private:
    struct Conjunction;
    std::vector<std::uint64_t> words_;
    std::size_t size_ = 0;
    std::shared_ptr<const Conjunction> conjunction_;  ///< when compiled; copies share what was computed
};

}  // namespace partonomy::knowledge
