#include "knowledge/plan_rows.h"

#include <algorithm>
#include <array>
#include <cstring>

// Counting walks over the rows. A row holds a byte for each question, so that adding a word adds eight counts at once;
// before a byte overflows, they are taken over. Of two halves of a set only the smaller one is counted: the other is
// the rest. Labels are summed up in ascending order, so that a count and a rest give the same numbers to the last bit.
//
// Rows are numbered so that those of one label are neighbours: then a set of one label is one whose first and last row
// have the same. Labels are found by splitting classes by one wanted concept after the other, each in as many steps as
// it has configurations.

namespace partonomy::knowledge {
namespace {

constexpr std::size_t most_in_a_byte = 255;

std::uint64_t scrambled(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31);
}

/// Counts of questions over some rows: eight to a word, then all.
class ByteSums {
public:
    explicit ByteSums(std::size_t words) : words_(words) {
        if (words > few_.size()) many_.resize(words);
        sums_ = many_.empty() ? few_.data() : many_.data();
    }
    void add(const std::uint64_t* row) {
        for (std::size_t w = 0; w < words_; ++w) sums_[w] += row[w];
    }
    void take_over(std::uint32_t* counts, std::size_t questions) {
        for (std::size_t q = 0; q < questions; ++q) counts[q] += reinterpret_cast<const unsigned char*>(sums_)[q];
        std::fill_n(sums_, words_, 0);
    }

private:
    std::size_t words_;
    std::array<std::uint64_t, 16> few_{};
    std::vector<std::uint64_t> many_;
    std::uint64_t* sums_;
};

}  // namespace

PlanRows::PlanRows(std::size_t size, std::span<const ConfigurationSet> wanted,
                   const std::vector<const ConfigurationSet*>& questions)
    : questions_(questions.size()),
      stride_((questions.size() + 7) / 8),
      place_(size),
      label_(size, 0),
      answers_(size * stride_, 0),
      is_yes_(questions.size() * size, 0) {
    codes_.reserve(size);
    std::vector<std::uint32_t> label(size, 0);  // by configuration
    std::vector<std::uint32_t> sizes(1, static_cast<std::uint32_t>(size)), inside(1, 0), finer(1, 0), met;
    for (const ConfigurationSet& where : wanted) {
        met.clear();
        where.for_each([&](std::size_t i) {
            if (inside[label[i]]++ == 0) met.push_back(label[i]);
        });
        for (const std::uint32_t each : met) {
            const bool is_split = inside[each] < sizes[each];
            finer[each] = is_split ? static_cast<std::uint32_t>(sizes.size()) : each;
            if (is_split) {
                sizes.push_back(inside[each]);
                sizes[each] -= inside[each];
                inside.push_back(0);
                finer.push_back(0);
            }
            inside[each] = 0;
        }
        where.for_each([&](std::size_t i) { label[i] = finer[label[i]]; });
    }
    std::vector<std::uint32_t> next(sizes.size(), 0);
    for (std::size_t each = 1; each < sizes.size(); ++each) next[each] = next[each - 1] + sizes[each - 1];
    for (std::size_t i = 0; i < size; ++i) {
        place_[i] = next[label[i]]++;
        label_[place_[i]] = label[i];
        codes_.push_back({scrambled(2 * i + 1), scrambled(~(2 * i))});
    }
    auto* bytes = reinterpret_cast<unsigned char*>(answers_.data());
    for (std::size_t q = 0; q < questions.size(); ++q)
        questions[q]->for_each([&](std::size_t i) {
            bytes[place_[i] * stride_ * 8 + q] = 1;
            is_yes_[q * size + place_[i]] = 1;
        });
}

Rows PlanRows::rows_of(const ConfigurationSet& set) const {
    ConfigurationSet places(place_.size());
    std::size_t count = 0;
    set.for_each([&](std::size_t i) {
        places.insert(place_[i]);
        ++count;
    });
    Rows rows;
    rows.reserve(count);
    places.for_each([&](std::size_t i) { rows.push_back(static_cast<std::uint32_t>(i)); });
    return rows;
}

void PlanRows::count(RowSpan rows, RowCounts& counts) const {
    counts.count = rows.size();
    counts.labels.clear();
    counts.sizes.clear();
    counts.yes.clear();
    counts.yes_in_all.assign(questions_, 0);
    ByteSums sums(stride_);
    for (std::size_t i = 0; i < rows.size();) {
        const std::uint32_t label = label_[rows[i]];
        const std::size_t begin = i, at = counts.yes.size();
        counts.yes.resize(at + questions_, 0);
        while (i < rows.size() && label_[rows[i]] == label) {
            const std::size_t end = std::min(rows.size(), i + most_in_a_byte);
            for (; i < end && label_[rows[i]] == label; ++i) sums.add(&answers_[rows[i] * stride_]);
            sums.take_over(&counts.yes[at], questions_);
        }
        counts.labels.push_back(label);
        counts.sizes.push_back(static_cast<std::uint32_t>(i - begin));
        for (std::size_t q = 0; q < questions_; ++q) counts.yes_in_all[q] += counts.yes[at + q];
    }
}

void PlanRows::subtract(const RowCounts& whole, const RowCounts& part, RowCounts& rest) const {
    const std::size_t width = questions_;
    rest.count = whole.count - part.count;
    rest.labels.clear();
    rest.sizes.clear();
    rest.yes.resize(whole.yes.size());
    std::size_t of_part = 0;
    for (std::size_t label = 0; label < whole.labels.size(); ++label) {
        const std::uint32_t* from = &whole.yes[label * width];
        std::uint32_t* to = &rest.yes[rest.labels.size() * width];
        const bool is_shared = of_part < part.labels.size() && part.labels[of_part] == whole.labels[label];
        const std::uint32_t* minus = is_shared ? &part.yes[of_part * width] : nullptr;
        const std::uint32_t size = whole.sizes[label] - (is_shared ? part.sizes[of_part] : 0);
        of_part += is_shared;
        if (size == 0) continue;
        rest.labels.push_back(whole.labels[label]);
        rest.sizes.push_back(size);
        for (std::size_t q = 0; q < width; ++q) to[q] = from[q] - (minus ? minus[q] : 0);
    }
    rest.yes.resize(rest.labels.size() * width);
    rest.yes_in_all.resize(width);
    for (std::size_t q = 0; q < width; ++q) rest.yes_in_all[q] = whole.yes_in_all[q] - part.yes_in_all[q];
}

std::vector<std::uint32_t> PlanRows::count_yes(const ConfigurationSet& set) const {
    std::vector<std::uint32_t> counts(questions_, 0);
    ByteSums sums(stride_);
    std::size_t added = 0;
    set.for_each([&](std::size_t i) {
        sums.add(&answers_[place_[i] * stride_]);
        if (++added % most_in_a_byte == 0) sums.take_over(counts.data(), questions_);
    });
    sums.take_over(counts.data(), questions_);
    return counts;
}

bool PlanRows::has_one_label(RowSpan rows) const { return rows.empty() || label_[rows.front()] == label_[rows.back()]; }

RowSum PlanRows::sum(RowSpan rows) const {
    RowSum result;
    for (const std::uint32_t row : rows) {
        result.first += codes_[row].first;
        result.second += codes_[row].second;
    }
    return result;
}

std::size_t PlanRows::split(std::span<std::uint32_t> rows, std::size_t question, Rows& scratch) const {
    scratch.resize(rows.size());
    const unsigned char* is_yes = &is_yes_[question * place_.size()];
    std::uint32_t* const out = scratch.data();
    std::size_t inside = 0, outside = 0;
    for (const std::uint32_t row : rows) {  // without a branch, since nobody can guess it
        const std::size_t is_in = is_yes[row];
        out[outside] = rows[inside] = row;
        inside += is_in;
        outside += 1 - is_in;
    }
    std::copy_n(scratch.begin(), outside, rows.begin() + static_cast<std::ptrdiff_t>(inside));
    return inside;
}

RowTable::Entry& RowTable::place_of(RowSum set) {
    std::size_t place = set.first & (entries_.size() - 1);
    while (entries_[place].is_used && entries_[place].set != set) place = (place + 1) & (entries_.size() - 1);
    return entries_[place];
}

std::optional<double>& RowTable::value(RowSum set) {
    if (used_ * 2 >= entries_.size()) {
        std::vector<Entry> old(std::max<std::size_t>(entries_.size() * 2, 256));
        old.swap(entries_);
        for (const Entry& entry : old)
            if (entry.is_used) place_of(entry.set) = entry;
    }
    Entry& entry = place_of(set);
    used_ += !entry.is_used;
    entry.set = set;
    entry.is_used = true;
    return entry.value;
}

}  // namespace partonomy::knowledge
