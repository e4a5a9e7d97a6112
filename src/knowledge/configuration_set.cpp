#include "knowledge/configuration_set.h"

namespace partonomy::knowledge {

ConfigurationSet::ConfigurationSet(std::size_t size, bool full)
    : words_((size + 63) / 64, full ? ~std::uint64_t{0} : 0), size_(size) {
    if (full && size % 64 != 0) words_.back() = (std::uint64_t{1} << (size % 64)) - 1;
}

std::size_t ConfigurationSet::count() const {
    std::size_t total = 0;
    for (const std::uint64_t word : words_) total += static_cast<std::size_t>(std::popcount(word));
    return total;
}

bool ConfigurationSet::is_empty() const {
    for (const std::uint64_t word : words_)
        if (word != 0) return false;
    return true;
}

bool ConfigurationSet::is_subset_of(const ConfigurationSet& other) const {
    for (std::size_t i = 0; i < words_.size(); ++i)
        if ((words_[i] & ~other.words_[i]) != 0) return false;
    return true;
}

bool ConfigurationSet::intersects(const ConfigurationSet& other) const {
    for (std::size_t i = 0; i < words_.size(); ++i)
        if ((words_[i] & other.words_[i]) != 0) return true;
    return false;
}

std::size_t ConfigurationSet::count_common(const ConfigurationSet& other) const {
    std::size_t total = 0;
    for (std::size_t i = 0; i < words_.size(); ++i)
        total += static_cast<std::size_t>(std::popcount(words_[i] & other.words_[i]));
    return total;
}

ConfigurationSet& ConfigurationSet::operator&=(const ConfigurationSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
}

ConfigurationSet& ConfigurationSet::operator|=(const ConfigurationSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    return *this;
}

ConfigurationSet& ConfigurationSet::operator-=(const ConfigurationSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= ~other.words_[i];
    return *this;
}

ConfigurationSet ConfigurationSet::complement() const { return ConfigurationSet(size_, true) -= *this; }

ConfigurationSet ConfigurationSet::packed(const ConfigurationSet& kept) const {
    ConfigurationSet result(kept.count());
    std::size_t next = 0;
    kept.for_each([&](std::size_t i) {
        if (has(i)) result.insert(next);
        ++next;
    });
    return result;
}

std::size_t ConfigurationSet::hash() const {
    std::uint64_t hash = size_;
    for (const std::uint64_t word : words_) {
        hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
}

}  // namespace partonomy::knowledge
