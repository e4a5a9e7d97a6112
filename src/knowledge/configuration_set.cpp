/* Sets of configurations, listed or compiled.

   A compiled set is a conjunction of literals. Its shares (how much of it each literal of the diagram holds in) take
   one sweep and answer everything else: it is empty when there is no model, below a literal when that is inferred. Two
   sets are equal when the same literals are inferred in both: each is then told by the other's literals. */

#include "knowledge/configuration_set.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>

#include "knowledge/diagram.h"
#include "knowledge/sampled_models.h"

namespace partonomy::knowledge {
namespace {

std::size_t to_size(const std::string& digits) {
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    if (digits == too_many) return most;
    std::size_t value = 0;
    for (const char digit : digits) {
        const auto d = static_cast<std::size_t>(digit - '0');
        if (value > (most - d) / 10) return most;
        value = value * 10 + d;
    }
    return value;
}

/// Without the instruction that not every processor has; loops over it are done for several words at a time.
std::uint64_t bits_in(std::uint64_t word) {
    word -= (word >> 1) & 0x5555555555555555U;
    word = (word & 0x3333333333333333U) + ((word >> 2) & 0x3333333333333333U);
    word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fU;
    word += word >> 8;
    word += word >> 16;
    return (word + (word >> 32)) & 0x7fU;
}

}  // namespace

struct ConfigurationSet::Conjunction {
    std::shared_ptr<const Diagram> diagram;
    std::vector<int> literals;  ///< ascending

    [[nodiscard]] const Shares& shares() const {
        std::call_once(once_, [&] { shares_ = diagram->remembered_shares(literals); });
        return *shares_;
    }
    [[nodiscard]] bool is_empty() const {
        if (literals.size() == 1 && diagram->sample() == nullptr)  // one sweep tells of every concept
            return !diagram->remembered_shares({})->is_possible(literals[0]);
        return asks_solver() ? !has_model_with({}) : std::isinf(shares().log2_total);
    }
    [[nodiscard]] bool is_possible(int literal) const {
        return asks_solver() ? has_model_with({literal}) : shares().is_possible(literal);
    }
    [[nodiscard]] bool is_inferred(int literal) const { return !is_possible(-literal); }  // or there is no model
    /// All literals that are inferred: the same for equal sets. Nothing for the empty set.
    [[nodiscard]] std::vector<int> closure() const {
        std::vector<int> inferred;
        if (is_empty()) return inferred;
        for (int v = 1; v <= diagram->variable_count(); ++v)
            for (const int literal : {v, -v})
                if (shares().is_inferred(literal)) inferred.push_back(literal);
        return inferred;
    }

private:
    /// A sampled space answers a few questions one by one before it finds out about all literals at once.
    [[nodiscard]] bool asks_solver() const { return diagram->sample() != nullptr && single_questions_++ < 16; }
    [[nodiscard]] bool has_model_with(std::vector<int> evidence) const {
        evidence.insert(evidence.end(), literals.begin(), literals.end());
        return diagram->sample()->has_model(evidence);
    }

    mutable std::once_flag once_;
    mutable std::shared_ptr<const Shares> shares_;
    mutable std::atomic<int> single_questions_ = 0;
};

ConfigurationSet::ConfigurationSet(std::size_t size, bool full)
    : words_((size + 63) / 64, full ? ~std::uint64_t{0} : 0), size_(size) {
    if (full && size % 64 != 0) words_.back() = (std::uint64_t{1} << (size % 64)) - 1;
}

ConfigurationSet::ConfigurationSet(std::shared_ptr<const Diagram> diagram, std::vector<int> literals) {
    std::ranges::sort(literals);
    literals.erase(std::unique(literals.begin(), literals.end()), literals.end());
    auto conjunction = std::make_shared<Conjunction>();
    conjunction->diagram = std::move(diagram);
    conjunction->literals = std::move(literals);
    conjunction_ = std::move(conjunction);
}

const Diagram& ConfigurationSet::diagram() const { return *conjunction_->diagram; }
const std::vector<int>& ConfigurationSet::literals() const { return conjunction_->literals; }

std::size_t ConfigurationSet::count() const {
    if (conjunction_) return to_size(count_text());
    std::size_t total = 0;
    for (const std::uint64_t word : words_) total += bits_in(word);
    return total;
}

std::string ConfigurationSet::count_text() const {
    return conjunction_ ? diagram().count(literals()).digits : std::to_string(count());
}

namespace {

/// Whether any of `count` words is not zero, looked at in blocks that the compiler takes several words of at a time.
template <typename Word>
bool any_word(std::size_t count, const Word& word) {
    constexpr std::size_t block = 8;
    std::size_t i = 0;
    for (; i + block <= count; i += block) {
        std::uint64_t any = 0;
        for (std::size_t k = 0; k < block; ++k) any |= word(i + k);
        if (any != 0) return true;
    }
    for (; i < count; ++i)
        if (word(i) != 0) return true;
    return false;
}

}  // namespace

bool ConfigurationSet::is_empty() const {
    if (conjunction_) return conjunction_->is_empty();
    return !any_word(words_.size(), [&](std::size_t i) { return words_[i]; });
}

std::optional<std::size_t> ConfigurationSet::first() const {
    for (std::size_t w = 0; w < words_.size(); ++w)
        if (words_[w] != 0) return w * 64 + static_cast<std::size_t>(std::countr_zero(words_[w]));
    return std::nullopt;
}

bool ConfigurationSet::is_subset_of(const ConfigurationSet& other) const {
    if (conjunction_)
        return std::ranges::all_of(other.literals(), [&](int literal) { return conjunction_->is_inferred(literal); });
    return !any_word(words_.size(), [&](std::size_t i) { return words_[i] & ~other.words_[i]; });
}

bool ConfigurationSet::intersects(const ConfigurationSet& other) const {
    if (conjunction_) {
        // What this set's own shares tell is known for all later questions; a sweep for both sets together is not.
        std::size_t open = 0;
        for (const int literal : other.literals()) {
            if (!conjunction_->is_possible(literal)) return false;
            open += !conjunction_->is_inferred(literal);
        }
        if (open == 0) return !is_empty();
        return open == 1 || !(*this & other).is_empty();
    }
    return any_word(words_.size(), [&](std::size_t i) { return words_[i] & other.words_[i]; });
}

std::size_t ConfigurationSet::count_common(const ConfigurationSet& other) const {
    if (conjunction_) return (*this & other).count();
    std::size_t total = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) total += bits_in(words_[i] & other.words_[i]);
    return total;
}

double ConfigurationSet::share(const ConfigurationSet& other) const {
    if (!conjunction_) {
        const std::size_t all = count();
        return all == 0 ? 0 : static_cast<double>(count_common(other)) / static_cast<double>(all);
    }
    if (is_empty()) return 0;
    if (other.literals().size() == 1) return conjunction_->shares().of(other.literals()[0]);
    if (diagram().sample() != nullptr) return is_subset_of(other) ? 1 : intersects(other) ? 0.5 : 0;
    return std::exp2((*this & other).conjunction_->shares().log2_total - conjunction_->shares().log2_total);
}

ConfigurationSet& ConfigurationSet::operator&=(const ConfigurationSet& other) {
    if (conjunction_) {
        if (std::ranges::includes(literals(), other.literals())) return *this;
        std::vector<int> both = literals();
        both.insert(both.end(), other.literals().begin(), other.literals().end());
        return *this = ConfigurationSet(conjunction_->diagram, std::move(both));
    }
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= other.words_[i];
    return *this;
}

ConfigurationSet& ConfigurationSet::operator|=(const ConfigurationSet& other) {
    if (conjunction_) {
        if (is_subset_of(other)) return *this = other;
        if (!other.is_subset_of(*this))
            throw std::logic_error("ConfigurationSet: the union of two compiled sets is none");
        return *this;
    }
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    return *this;
}

ConfigurationSet& ConfigurationSet::operator-=(const ConfigurationSet& other) {
    if (conjunction_) {
        std::vector<int> missing;  // what `other` asks for beyond this set
        std::ranges::set_difference(other.literals(), literals(), std::back_inserter(missing));
        if (missing.size() != 1) {
            if (!intersects(other)) return *this;
            std::erase_if(missing, [&](int literal) { return conjunction_->is_inferred(literal); });
        }
        if (missing.size() > 1)
            throw std::logic_error("ConfigurationSet: the difference of these two compiled sets is none");
        std::vector<int> rest = literals();
        if (missing.empty())
            rest.insert(rest.end(), {1, -1});  // nothing is left
        else
            rest.push_back(-missing[0]);
        return *this = ConfigurationSet(conjunction_->diagram, std::move(rest));
    }
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= ~other.words_[i];
    return *this;
}

ConfigurationSet ConfigurationSet::complement() const {
    if (!conjunction_) return ConfigurationSet(size_, true) -= *this;
    ConfigurationSet all(conjunction_->diagram, {});
    return is_empty() ? all : all -= *this;
}

ConfigurationSet ConfigurationSet::every(std::size_t size, std::size_t first, std::size_t run, std::size_t period) {
    ConfigurationSet result(size);
    std::vector<std::uint64_t>& words = result.words_;
    for (std::size_t i = first, end = std::min(first + run, size); i < end;) {
        const std::size_t bits = std::min(end - i, 64 - i % 64);
        words[i / 64] |= (bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1) << (i % 64);
        i += bits;
    }
    for (std::size_t filled = period; filled < size; filled *= 2) {  // what is there once more, behind itself
        const std::size_t shift = filled % 64, words_filled = (filled + 63) / 64;
        for (std::size_t w = words_filled; w-- > 0;) {
            const std::size_t to = w + filled / 64;
            if (shift > 0 && to + 1 < words.size()) words[to + 1] |= words[w] >> (64 - shift);
            if (to < words.size()) words[to] |= words[w] << shift;
        }
    }
    if (size % 64 != 0) words.back() &= (std::uint64_t{1} << (size % 64)) - 1;
    return result;
}

ConfigurationSet ConfigurationSet::packed(const ConfigurationSet& kept) const {
    ConfigurationSet result(kept.count());
    std::size_t next = 0;
    const auto append = [&](std::uint64_t bits, std::size_t count) {  // bits beyond `count` are 0
        if (count == 0) return;
        result.words_[next / 64] |= bits << (next % 64);
        if (next % 64 + count > 64) result.words_[next / 64 + 1] |= bits >> (64 - next % 64);
        next += count;
    };
    for (std::size_t w = 0; w < words_.size(); ++w) {
        std::uint64_t bits = words_[w], mask = kept.words_[w];
        while (mask != 0) {  // runs of neighbours that are kept
            const int gap = std::countr_zero(mask);
            bits >>= gap;
            mask >>= gap;
            const int run = std::countr_one(mask);
            const std::uint64_t ones = run == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << run) - 1;
            append(bits & ones, static_cast<std::size_t>(run));
            bits = run == 64 ? 0 : bits >> run;
            mask = run == 64 ? 0 : mask >> run;
        }
    }
    return result;
}

std::size_t ConfigurationSet::hash() const {
    std::uint64_t hash = size_;
    const auto mix = [&](std::uint64_t word) {
        hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 29;
    };
    for (const std::uint64_t word : words_) mix(word);
    if (conjunction_)
        for (const int literal : conjunction_->closure()) mix(static_cast<std::uint64_t>(literal));
    return static_cast<std::size_t>(hash);
}

std::strong_ordering operator<=>(const ConfigurationSet& a, const ConfigurationSet& b) {
    if (!a.conjunction_ || !b.conjunction_) {
        if (const auto order = a.words_ <=> b.words_; order != 0) return order;
        return a.size_ <=> b.size_;
    }
    if (a.literals() == b.literals()) return std::strong_ordering::equal;
    const bool a_empty = a.is_empty(), b_empty = b.is_empty();
    if (a_empty || b_empty) return b_empty <=> a_empty;
    if (a.diagram().sample() != nullptr) return a.conjunction_->closure() <=> b.conjunction_->closure();
    const double a_size = a.conjunction_->shares().log2_total, b_size = b.conjunction_->shares().log2_total;
    if (std::abs(a_size - b_size) > 1e-6)
        return a_size < b_size ? std::strong_ordering::less : std::strong_ordering::greater;
    return a.conjunction_->closure() <=> b.conjunction_->closure();
}

}  // namespace partonomy::knowledge
