#pragma once

#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace partonomy::knowledge {

/// A subset of a space's configurations: a bit for each. Sets that meet in an operation belong to the same space.
class ConfigurationSet {
public:
    ConfigurationSet() = default;
    explicit ConfigurationSet(std::size_t size, bool full = false);

    [[nodiscard]] std::size_t size() const { return size_; }  ///< of the space
    [[nodiscard]] std::size_t count() const;                  ///< configurations in the set
    [[nodiscard]] bool is_empty() const;
    [[nodiscard]] bool has(std::size_t i) const { return (words_[i / 64] >> (i % 64)) & 1U; }
    void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }

    [[nodiscard]] bool is_subset_of(const ConfigurationSet& other) const;
    [[nodiscard]] bool intersects(const ConfigurationSet& other) const;
    [[nodiscard]] std::size_t count_common(const ConfigurationSet& other) const;
    ConfigurationSet& operator&=(const ConfigurationSet& other);
    ConfigurationSet& operator|=(const ConfigurationSet& other);
    ConfigurationSet& operator-=(const ConfigurationSet& other);
    [[nodiscard]] ConfigurationSet complement() const;

    /// Calls `visit(i)` for each configuration in the set, ascending.
    template <typename Visit>
    void for_each(Visit&& visit) const {
        for (std::size_t w = 0; w < words_.size(); ++w)
            for (std::uint64_t word = words_[w]; word != 0; word &= word - 1)
                visit(w * 64 + static_cast<std::size_t>(std::countr_zero(word)));
    }
    /// This set in the smaller space that only has the configurations of `kept`, renumbered in their order.
    [[nodiscard]] ConfigurationSet packed(const ConfigurationSet& kept) const;
    [[nodiscard]] std::size_t hash() const;

    friend ConfigurationSet operator&(ConfigurationSet a, const ConfigurationSet& b) { return a &= b; }
    friend ConfigurationSet operator|(ConfigurationSet a, const ConfigurationSet& b) { return a |= b; }
    friend ConfigurationSet operator-(ConfigurationSet a, const ConfigurationSet& b) { return a -= b; }
    friend auto operator<=>(const ConfigurationSet&, const ConfigurationSet&) = default;

private:
    std::vector<std::uint64_t> words_;
    std::size_t size_ = 0;
};

}  // namespace partonomy::knowledge
