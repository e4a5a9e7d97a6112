#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "knowledge/assembly.h"

// Which composite parts one mesh has, and so what its object counts. When every region is known, the groups are plain
// to see: layer by layer, the regions that belong to a kind of group, and the composite parts of lower layers that do,
// fall into connected sets. Where regions are still open every way to decide them is tried; but only regions that may
// be in a group matter, and of those only what no class of parts tells apart; and what does not touch is independent,
// so ways multiply within a connected set of such regions only. What holds in each of the ways is certain.
//
// A composite part may be open itself, when it has a concept without definition; then each of its readings is a way.

namespace partonomy::knowledge {
namespace {

using Regions = std::vector<int>;  ///< some regions of one connected set, by their places in it; ascending

constexpr std::size_t most_ways = 1U << 16;

Counts counts_of(const Parts& parts, const auto& is_in) {
    Counts counts = 0;
    for (std::size_t c = 0; c < parts.classes.size(); ++c)
        if (is_in(c)) counts += Counts{1} << parts.classes[c].shift;
    return counts;
}

}  // namespace

struct Contributions {
    /// By cell of the configurations of a region.
    std::vector<Cell> cells;
    std::vector<std::vector<Counts>> to_group;  ///< [cell][group]
    std::vector<std::vector<char>> in_group;    ///< [cell][group]: belongs to it
    std::vector<Counts> to_object;              ///< [cell]
    std::vector<char> is_grouped;               ///< [cell]: belongs to some group
    /// By group, then by cell of the configurations of its composite parts.
    std::vector<std::vector<Cell>> composite_cells;
    std::vector<std::vector<std::vector<Counts>>> composite_to_group;  ///< [group][cell][outer group]
    std::vector<std::vector<std::vector<char>>> composite_in_group;    ///< [group][cell][outer group]
    std::vector<std::vector<Counts>> composite_to_object;              ///< [group][cell]
};

std::shared_ptr<const Contributions> find_contributions(const Assembly& assembly, const ConfigurationSet& all) {
    Contributions result;
    const std::size_t groups = assembly.composites.size();
    std::vector<const Parts*> observers;
    for (const CompositeLayer& composite : assembly.composites) observers.push_back(&composite.parts);
    observers.push_back(&assembly.parts);

    std::vector<const ConfigurationSet*> sets;
    for (const Parts* parts : observers)
        for (const Parts::PartClass& part : parts->classes) sets.push_back(&part.where);
    for (const CompositeLayer& composite : assembly.composites)
        if (composite.is_used) sets.push_back(&composite.regions);
    result.cells = split(all, sets);
    for (const Cell& cell : result.cells) {
        std::size_t next = 0;
        std::vector<Counts> counts;
        for (const Parts* parts : observers) {
            counts.push_back(counts_of(*parts, [&](std::size_t c) { return cell.in[next + c] != 0; }));
            next += parts->classes.size();
        }
        result.to_object.push_back(counts.back());
        counts.pop_back();
        result.to_group.push_back(std::move(counts));
        std::vector<char> in(groups, 0);
        for (std::size_t g = 0; g < groups; ++g)
            if (assembly.composites[g].is_used) in[g] = cell.in[next++];
        result.is_grouped.push_back(std::ranges::count(in, 1) > 0);
        result.in_group.push_back(std::move(in));
    }

    result.composite_cells.resize(groups);
    result.composite_to_group.resize(groups);
    result.composite_in_group.resize(groups);
    result.composite_to_object.resize(groups);
    for (std::size_t g = 0; g < groups; ++g) {
        if (!assembly.composites[g].is_used) continue;
        const ConfigurationSet readings = assembly.composites[g].objects.layer.space.all(), none(readings.size());
        const auto set_of = [&](const std::vector<ConfigurationSet>& by_group) {
            return g < by_group.size() && by_group[g].size() > 0 ? &by_group[g] : &none;
        };
        sets.clear();
        for (const Parts* parts : observers)
            for (const Parts::PartClass& part : parts->classes) sets.push_back(set_of(part.composites));
        for (const CompositeLayer& outer : assembly.composites) sets.push_back(set_of(outer.composites));
        result.composite_cells[g] = split(readings, sets);
        for (const Cell& cell : result.composite_cells[g]) {
            std::size_t next = 0;
            std::vector<Counts> counts;
            for (const Parts* parts : observers) {
                counts.push_back(counts_of(*parts, [&](std::size_t c) { return cell.in[next + c] != 0; }));
                next += parts->classes.size();
            }
            result.composite_to_object[g].push_back(counts.back());
            counts.pop_back();
            result.composite_to_group[g].push_back(std::move(counts));
            result.composite_in_group[g].emplace_back(cell.in.begin() + static_cast<std::ptrdiff_t>(next),
                                                      cell.in.end());
        }
    }
    return std::make_shared<const Contributions>(std::move(result));
}

namespace {

/// One connected set of regions that may be in groups.
class Cluster {
public:
    Cluster(const Theory& theory, const Assembly& assembly, const Contributions& all, std::vector<int> regions,
            const std::vector<std::pair<int, int>>& connected)
        : theory_(theory), assembly_(assembly), all_(all), regions_(std::move(regions)), touching_(regions_.size()) {
        for (const auto& [a, b] : connected) {
            const auto i = std::ranges::find(regions_, a) - regions_.begin();
            const auto j = std::ranges::find(regions_, b) - regions_.begin();
            if (static_cast<std::size_t>(i) == regions_.size() || static_cast<std::size_t>(j) == regions_.size())
                continue;
            touching_[static_cast<std::size_t>(i)].push_back(static_cast<int>(j));
            touching_[static_cast<std::size_t>(j)].push_back(static_cast<int>(i));
        }
    }

    /// Tries every choice of one of `cells[i]` for region i.
    void try_all(const std::vector<std::vector<std::size_t>>& cells) {
        choice_.assign(regions_.size(), 0);
        const auto choose = [&](const auto& self, std::size_t i) -> void {
            if (i == regions_.size()) return begin_group(0);
            for (const std::size_t cell : cells[i]) {
                choice_[i] = cell;
                self(self, i + 1);
            }
        };
        choose(choose, 0);
    }

    [[nodiscard]] const std::set<Counts>& counts() const { return counts_; }
    /// Whether every way has the same composite parts; false where there is no way.
    [[nodiscard]] bool is_certain() const {
        return ways_ > 0 && std::ranges::all_of(found_, [&](const auto& each) { return each.second.ways == ways_; });
    }
    [[nodiscard]] std::vector<CompositePart> certain() const {
        std::vector<CompositePart> parts;
        for (const auto& [key, found] : found_) {
            if (found.ways != ways_) continue;
            CompositePart part{static_cast<int>(key.first), {}, found.possible};
            for (const int i : key.second) part.regions.push_back(regions_[static_cast<std::size_t>(i)]);
            parts.push_back(std::move(part));
        }
        return parts;
    }

private:
    struct Item {
        std::size_t group;
        Regions regions;
        std::size_t cell;  ///< of composite_cells
        ConfigurationSet possible;
    };

    void begin_group(std::size_t group) {
        while (group < assembly_.composites.size() && !assembly_.composites[group].is_used) ++group;
        if (group == assembly_.composites.size()) return finish();
        std::vector<char> is_waiting(regions_.size(), 0);
        for (std::size_t i = 0; i < regions_.size(); ++i) is_waiting[i] = all_.in_group[choice_[i]][group];
        for (const Item& item : items_)
            if (all_.composite_in_group[item.group][item.cell][group] != 0)
                for (const int i : item.regions) is_waiting[static_cast<std::size_t>(i)] = 1;
        std::vector<Regions> parts;
        for (std::size_t first = 0; first < regions_.size(); ++first) {
            if (is_waiting[first] == 0) continue;
            is_waiting[first] = 0;
            Regions part{static_cast<int>(first)};
            for (std::size_t at = 0; at < part.size(); ++at)
                for (const int j : touching_[static_cast<std::size_t>(part[at])])
                    if (std::exchange(is_waiting[static_cast<std::size_t>(j)], 0) != 0) part.push_back(j);
            std::ranges::sort(part);
            parts.push_back(std::move(part));
        }
        add_parts(group, parts, 0);
    }

    /// Makes a composite part of each set of regions, in each of its readings.
    void add_parts(std::size_t group, const std::vector<Regions>& parts, std::size_t next) {
        if (next == parts.size()) return begin_group(group + 1);
        const CompositeLayer& composite = assembly_.composites[group];
        Counts counts = 0;
        for (const int i : parts[next])
            counts = composite.parts.sum(counts, all_.to_group[choice_[static_cast<std::size_t>(i)]][group]);
        const std::vector<int>& inner = theory_.groups[group].inner;
        for (const Item& item : items_)
            if (std::ranges::includes(parts[next], item.regions) &&
                std::ranges::binary_search(inner, static_cast<int>(item.group)))
                counts = composite.parts.sum(counts, all_.composite_to_group[item.group][item.cell][group]);
        if (!std::ranges::binary_search(composite.objects.counts, counts))
            throw std::logic_error("put_together: a composite part that nothing foresaw");
        const ConfigurationSet possible = composite.objects.of({counts});
        const std::vector<Cell>& cells = all_.composite_cells[group];
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            if (!cells[cell].where.intersects(possible)) continue;
            items_.push_back({group, parts[next], cell, cells[cell].where & possible});
            add_parts(group, parts, next + 1);
            items_.pop_back();
        }
    }

    void finish() {
        ++ways_;
        Counts counts = 0;
        for (const std::size_t cell : choice_) counts = assembly_.parts.sum(counts, all_.to_object[cell]);
        for (const Item& item : items_) {
            counts = assembly_.parts.sum(counts, all_.composite_to_object[item.group][item.cell]);
            auto [at, is_new] = found_.try_emplace({item.group, item.regions}, Found{0, item.possible});
            ++at->second.ways;
            if (!is_new) at->second.possible |= item.possible;
        }
        counts_.insert(counts);
    }

    struct Found {
        std::size_t ways;
        ConfigurationSet possible;
    };
    const Theory& theory_;
    const Assembly& assembly_;
    const Contributions& all_;
    std::vector<int> regions_;
    std::vector<Regions> touching_;  ///< by region
    std::vector<std::size_t> choice_;
    std::vector<Item> items_;
    std::set<Counts> counts_;
    std::map<std::pair<std::size_t, Regions>, Found> found_;
    std::size_t ways_ = 0;
};

/// The regions of `members`, in connected sets; ascending.
std::vector<std::vector<int>> connected_sets(const std::vector<char>& members,
                                             const std::vector<std::pair<int, int>>& connected) {
    std::vector<int> set_of(members.size());
    for (std::size_t i = 0; i < members.size(); ++i) set_of[i] = static_cast<int>(i);
    const auto find = [&](int i) {
        while (set_of[static_cast<std::size_t>(i)] != i) i = set_of[static_cast<std::size_t>(i)];
        return i;
    };
    for (const auto& [a, b] : connected) {
        if (!members[static_cast<std::size_t>(a)] || !members[static_cast<std::size_t>(b)]) continue;
        const int x = find(a), y = find(b);
        set_of[static_cast<std::size_t>(std::max(x, y))] = std::min(x, y);
    }
    std::map<int, std::vector<int>> sets;
    for (std::size_t i = 0; i < members.size(); ++i)
        if (members[i]) sets[find(static_cast<int>(i))].push_back(static_cast<int>(i));
    std::vector<std::vector<int>> result;
    for (auto& [first, set] : sets) result.push_back(std::move(set));
    return result;
}

}  // namespace

std::optional<Assembled> put_together(const Theory& theory, const Assembly& assembly,
                                      const Contributions& contributions, const std::vector<ConfigurationSet>& regions,
                                      const std::vector<std::pair<int, int>>& connected) {
    std::vector<std::vector<std::size_t>> cells(regions.size());
    std::vector<char> may_be_grouped(regions.size(), 0);
    std::set<Counts> counts{0};
    const auto combine = [&](const std::set<Counts>& more) {
        std::set<Counts> sums;
        for (const Counts a : counts)
            for (const Counts b : more) sums.insert(assembly.parts.sum(a, b));
        counts = std::move(sums);
    };
    for (std::size_t r = 0; r < regions.size(); ++r) {
        const bool is_any = regions[r].is_empty();
        std::set<Counts> alone;
        for (std::size_t c = 0; c < contributions.cells.size(); ++c)
            if (is_any || contributions.cells[c].where.intersects(regions[r])) {
                cells[r].push_back(c);
                may_be_grouped[r] |= contributions.is_grouped[c];
                alone.insert(contributions.to_object[c]);
            }
        if (!may_be_grouped[r]) combine(alone);
    }
    Assembled result;
    for (const std::vector<int>& set : connected_sets(may_be_grouped, connected)) {
        std::size_t ways = 1;
        std::vector<std::vector<std::size_t>> choices;
        for (const int r : set) {
            choices.push_back(cells[static_cast<std::size_t>(r)]);
            ways *= choices.back().size();
            if (ways > most_ways) return std::nullopt;
        }
        Cluster cluster(theory, assembly, contributions, set, connected);
        cluster.try_all(choices);
        combine(cluster.counts());
        result.is_certain &= cluster.is_certain();
        for (CompositePart& part : cluster.certain()) result.composites.push_back(std::move(part));
    }
    std::ranges::sort(result.composites, {},
                      [](const CompositePart& part) { return std::pair(part.group, part.regions); });
    result.counts.assign(counts.begin(), counts.end());
    return result;
}

}  // namespace partonomy::knowledge
