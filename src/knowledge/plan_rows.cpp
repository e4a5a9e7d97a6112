#include "knowledge/plan_rows.h"

#include <algorithm>

// Counting walks over the rows, each with the questions that it answers with yes. Of two halves of a set only the
// smaller one is counted: the other is the rest. Labels are summed up in ascending order, so that a count and a rest
// give the same numbers to the last bit.

namespace partonomy::knowledge {

PlanRows::PlanRows(std::size_t size, const std::vector<ConfigurationSet>& labels,
                   const std::vector<const ConfigurationSet*>& questions)
    : questions_(questions.size()),
      labels_(std::max<std::size_t>(labels.size(), 1)),
      label_(size, 0),
      first_(size + 1, 0) {
    for (std::size_t label = 0; label < labels.size(); ++label)
        labels[label].for_each([&](std::size_t i) { label_[i] = static_cast<std::uint32_t>(label); });
    for (const ConfigurationSet* question : questions) question->for_each([&](std::size_t i) { ++first_[i + 1]; });
    for (std::size_t i = 0; i < size; ++i) first_[i + 1] += first_[i];
    yes_.resize(first_[size]);
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t q = 0; q < questions.size(); ++q)
        questions[q]->for_each([&](std::size_t i) { yes_[next[i]++] = static_cast<std::uint32_t>(q); });
}

void PlanRows::count(RowSpan rows, RowCounts& counts) const {
    const std::size_t width = questions_;
    counts.count = rows.size();
    counts.labels.clear();
    counts.sizes.assign(labels_, 0);
    counts.place.resize(labels_);
    for (const std::uint32_t row : rows) ++counts.sizes[label_[row]];
    for (std::size_t label = 0; label < labels_; ++label) {
        if (counts.sizes[label] == 0) continue;
        const std::size_t place = counts.labels.size();
        counts.place[label] = static_cast<std::uint32_t>(place * width);
        counts.sizes[place] = counts.sizes[label];
        counts.labels.push_back(static_cast<std::uint32_t>(label));
    }
    counts.sizes.resize(counts.labels.size());
    counts.yes.assign(counts.labels.size() * width, 0);
    for (const std::uint32_t row : rows) {
        std::uint32_t* inside = &counts.yes[counts.place[label_[row]]];
        for (std::uint32_t at = first_[row]; at < first_[row + 1]; ++at) ++inside[yes_[at]];
    }
    counts.yes_in_all.assign(width, 0);
    for (std::size_t label = 0; label < counts.labels.size(); ++label)
        for (std::size_t q = 0; q < width; ++q) counts.yes_in_all[q] += counts.yes[label * width + q];
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
    set.for_each([&](std::size_t row) {
        for (std::uint32_t at = first_[row]; at < first_[row + 1]; ++at) ++counts[yes_[at]];
    });
    return counts;
}

bool PlanRows::has_one_label(RowSpan rows) const {
    return std::ranges::all_of(rows, [&](std::uint32_t row) { return label_[row] == label_[rows[0]]; });
}

RowTable::Entry& RowTable::place_of(std::uint64_t hash, RowSpan rows) {
    std::size_t place = hash & (entries_.size() - 1);
    for (; entries_[place].size > 0; place = (place + 1) & (entries_.size() - 1))
        if (const Entry& entry = entries_[place];
            entry.hash == hash && std::ranges::equal(rows, RowSpan(rows_).subspan(entry.first, entry.size)))
            break;
    return entries_[place];
}

std::uint64_t RowTable::hash_of(RowSpan rows) {
    while (codes_.size() <= rows.back()) {
        std::uint64_t code = (codes_.size() + 1) * 0x9E3779B97F4A7C15U;
        code = (code ^ (code >> 29)) * 0xBF58476D1CE4E5B9U;
        codes_.push_back(code ^ (code >> 32));
    }
    std::uint64_t sum = rows.size();
    for (const std::uint32_t row : rows) sum += codes_[row];  // no step waits for the one before
    return sum ^ (sum >> 31);
}

std::size_t RowTable::number_of(RowSpan rows) {
    if (values_.size() * 2 >= entries_.size()) {
        std::vector<Entry> old(std::max<std::size_t>(entries_.size() * 2, 256));
        old.swap(entries_);
        for (const Entry& entry : old)
            if (entry.size > 0) place_of(entry.hash, RowSpan(rows_).subspan(entry.first, entry.size)) = entry;
    }
    const std::uint64_t hash = hash_of(rows);
    Entry& entry = place_of(hash, rows);
    if (entry.size == 0) {
        entry = {hash, rows_.size(), rows.size(), values_.size()};
        rows_.insert(rows_.end(), rows.begin(), rows.end());
        values_.emplace_back();
    }
    return entry.number;
}

std::size_t split(std::span<std::uint32_t> rows, const ConfigurationSet& yes, Rows& scratch) {
    scratch.resize(rows.size());
    std::size_t inside = 0, outside = 0;
    for (const std::uint32_t row : rows) {  // without a branch, since nobody can guess it
        const bool is_in = yes.has(row);
        scratch[outside] = rows[inside] = row;
        inside += is_in;
        outside += !is_in;
    }
    std::copy_n(scratch.begin(), outside, rows.begin() + static_cast<std::ptrdiff_t>(inside));
    return inside;
}

Rows rows_of(const ConfigurationSet& set) {
    Rows rows;
    rows.reserve(set.count());
    set.for_each([&](std::size_t i) { rows.push_back(static_cast<std::uint32_t>(i)); });
    return rows;
}

}  // namespace partonomy::knowledge
