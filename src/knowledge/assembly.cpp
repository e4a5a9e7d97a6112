#include "knowledge/assembly.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/errors.h"

// What composite parts, and objects made of them, can be. As for objects of regions only (object_space.cpp), it is
// enough to know which vectors of capped counts some set of parts realises. A composite part is itself such a vector,
// over what it counts; but its regions are regions of the object as well, so "has a Back" and "has a Backrest" hang
// together. Hence a walk that counts for several *observers* at once: all that a group can be is walked with the group
// itself and everything around it as observers, one region after the other; each vector that is reached is one way to
// add a whole group in a single step of the walk around it. Groups inside of groups are the same again.
//
// A region is in exactly one group of a kind when some of its features put it there, so an object's walk may not add it
// alone. Two kinds with a claim to the same regions would have to be walked together; instead, the later kind does not
// *own* its regions: its composite parts are added without them. That allows a little more than there is, and is never
// needed for one mesh, whose groups are known (put_together.cpp).
//
// Cost: (vectors of all observers together) x (steps); a Back of Backrest and Headrest on top of furniture: 6 vectors
// of a back, 19 ways to add one.

namespace partonomy::knowledge {
namespace {

using State = std::vector<Counts>;  ///< by observer

class Walk {
public:
    Walk(const Theory& theory, const std::vector<CompositeLayer>& composites, ConfigurationSet among,
         bool only_possible, std::size_t limit)
        : theory_(theory),
          composites_(composites),
          among_(std::move(among)),
          only_possible_(only_possible),
          limit_(limit) {}

    /// What one group may count in the eyes of its observers, the first of which are its own parts.
    [[nodiscard]] std::vector<State> run(int group, const std::vector<const Parts*>& observers) const {
        const std::vector<State> steps = all_steps(group, observers);
        std::set<State> seen;
        std::vector<State> reached{State(observers.size(), 0)};
        for (std::size_t next = 0; next < reached.size(); ++next)
            for (const State& step : steps) {
                State more = add(observers, reached[next], step);
                if (!seen.insert(more).second) continue;
                reached.push_back(std::move(more));
                if (reached.size() > limit_)
                    throw OntologyError("composite parts combine in more than " + std::to_string(limit_) +
                                        " ways; count fewer classes of parts, or to lower numbers");
            }
        return {seen.begin(), seen.end()};
    }

    /// What the object may count.
    [[nodiscard]] std::vector<Counts> run(const Parts& object) const {
        std::vector<Counts> steps;
        for (const State& step : all_steps(-1, {&object})) steps.push_back(step[0]);
        return with_any_steps(object, {0}, steps, limit_);
    }

private:
    [[nodiscard]] static State add(const std::vector<const Parts*>& observers, const State& a, const State& b) {
        State sum(a.size());
        for (std::size_t k = 0; k < a.size(); ++k) sum[k] = observers[k]->sum(a[k], b[k]);
        return sum;
    }

    [[nodiscard]] std::vector<std::size_t> inner(int group) const {
        std::vector<std::size_t> groups;
        for (std::size_t g = 0; g < composites_.size(); ++g)
            if (composites_[g].is_used &&
                (group < 0 ||
                 std::ranges::count(theory_.groups[static_cast<std::size_t>(group)].inner, static_cast<int>(g)) > 0))
                groups.push_back(g);
        return groups;
    }

    /// Regions, and whole groups, that may be added.
    [[nodiscard]] std::vector<State> all_steps(int group, const std::vector<const Parts*>& observers) const {
        std::vector<const ConfigurationSet*> sets;
        for (const Parts* parts : observers)
            for (const Parts::PartClass& part : parts->classes) sets.push_back(&part.where);
        const std::size_t classes = sets.size();
        if (group >= 0) {
            sets.push_back(&composites_[static_cast<std::size_t>(group)].regions);
        } else {
            for (const std::size_t g : inner(group))
                if (composites_[g].owns) sets.push_back(&composites_[g].regions);
        }
        std::set<State> steps;
        for (const Cell& cell : split(among_, sets)) {
            const bool in_group =
                std::find(cell.in.begin() + static_cast<std::ptrdiff_t>(classes), cell.in.end(), 1) != cell.in.end();
            if (in_group == (group >= 0)) steps.insert(step_of(observers, cell));
        }
        for (const std::size_t g : inner(group))
            for (State& step : bundles(g, group, observers)) steps.insert(std::move(step));
        return {steps.begin(), steps.end()};
    }

    /// One more part in the cell: its `in` begins with the classes of each observer, one observer after the other.
    [[nodiscard]] static State step_of(const std::vector<const Parts*>& observers, const Cell& cell) {
        State step;
        std::size_t next = 0;
        for (const Parts* parts : observers) {
            Counts counts = 0;
            for (const Parts::PartClass& part : parts->classes)
                if (cell.in[next++]) counts += Counts{1} << part.shift;
            step.push_back(counts);
        }
        return step;
    }

    /// What a whole group adds to those around it: `container` (-1: the object) and its observers.
    [[nodiscard]] std::vector<State> bundles(std::size_t group, int container,
                                             const std::vector<const Parts*>& observers) const {
        const CompositeLayer& composite = composites_[group];
        const ConfigurationSet all = only_possible_ ? composite.possible : composite.objects.layer.space.all();
        std::vector<const ConfigurationSet*> sets;
        const ConfigurationSet none(all.size());
        for (const Parts* parts : observers)
            for (const Parts::PartClass& part : parts->classes)
                sets.push_back(group < part.composites.size() && part.composites[group].size() > 0
                                   ? &part.composites[group]
                                   : &none);
        if (container >= 0) sets.push_back(&composites_[static_cast<std::size_t>(container)].composites[group]);
        std::vector<Cell> cells = split(all, sets);
        if (container >= 0) std::erase_if(cells, [](const Cell& cell) { return !cell.in.back(); });

        std::vector<State> steps;
        if (!composite.owns) {
            for (const Cell& cell : cells) steps.push_back(step_of(observers, cell));
            return steps;
        }
        std::vector<const Parts*> inside{&composite.parts};
        inside.insert(inside.end(), observers.begin(), observers.end());
        for (const State& state : run(static_cast<int>(group), inside)) {
            const ConfigurationSet configurations = composite.objects.of({state[0]});
            const State regions(state.begin() + 1, state.end());
            for (const Cell& cell : cells)
                if (cell.where.intersects(configurations))
                    steps.push_back(add(observers, regions, step_of(observers, cell)));
        }
        return steps;
    }

    const Theory& theory_;
    const std::vector<CompositeLayer>& composites_;
    ConfigurationSet among_;
    bool only_possible_;
    std::size_t limit_;
};

}  // namespace

bool Assembly::has_composites() const {
    return std::ranges::any_of(composites, [](const CompositeLayer& each) { return each.is_used; });
}

std::vector<Cell> split(const ConfigurationSet& all, const std::vector<const ConfigurationSet*>& sets) {
    std::vector<Cell> cells{{{}, all}};
    for (const ConfigurationSet* set : sets) {
        std::vector<Cell> finer;
        for (Cell& cell : cells) {
            Cell inside{cell.in, cell.where & *set};
            inside.in.push_back(1);
            cell.in.push_back(0);
            cell.where -= *set;
            if (!cell.where.is_empty()) finer.push_back(std::move(cell));
            if (!inside.where.is_empty()) finer.push_back(std::move(inside));
        }
        cells = std::move(finer);
    }
    std::erase_if(cells, [](const Cell& cell) { return cell.where.is_empty(); });
    return cells;
}

Assembly assemble(const Theory& theory, const Scope& scope, const Layer& regions, std::size_t limit) {
    Assembly assembly;
    std::vector<CompositeLayer>& composites = assembly.composites;
    composites.resize(theory.groups.size());
    for (std::size_t id = 0; id < theory.concepts.size(); ++id)
        if (theory.concepts[id].group >= 0 && scope.concepts[id])
            composites[static_cast<std::size_t>(theory.concepts[id].group)].is_used = true;
    for (std::size_t g = 0; g < composites.size(); ++g) {
        CompositeLayer& composite = composites[g];
        if (!composite.is_used) continue;
        const Group& group = theory.groups[g];
        const Subject subject{Level::composite, static_cast<int>(g)};
        std::vector<const Layer*> layers(composites.size(), nullptr);
        for (const int i : group.inner)
            layers[static_cast<std::size_t>(i)] = &composites[static_cast<std::size_t>(i)].objects.layer;
        composite.parts = find_parts(theory, scope, subject, regions, layers);
        composite.regions = evaluate(theory, regions, group.regions);
        composite.composites.resize(composites.size());
        for (const int i : group.inner)
            composite.composites[static_cast<std::size_t>(i)] =
                evaluate(theory, *layers[static_cast<std::size_t>(i)], group.composites);
        for (std::size_t other = 0; other < g; ++other)
            if (composites[other].is_used && composites[other].owns &&
                composites[other].regions.intersects(composite.regions))
                composite.owns = false;
        std::vector<Counts> counts;
        for (const State& state :
             Walk(theory, composites, regions.space.all(), false, limit).run(static_cast<int>(g), {&composite.parts}))
            counts.push_back(state[0]);
        composite.objects = build_objects(theory, scope, subject, composite.parts, std::move(counts), limit);
        const Layer& layer = composite.objects.layer;
        composite.possible = layer.space.all();
        for (std::size_t id = 0; id < theory.concepts.size(); ++id)
            if (theory.concepts[id].incompatible && scope.concepts[id] && subject.has(theory.concepts[id]))
                composite.possible -= layer.concepts[id];
    }
    std::vector<const Layer*> layers;
    for (const CompositeLayer& composite : composites)
        layers.push_back(composite.is_used ? &composite.objects.layer : nullptr);
    assembly.parts = find_parts(theory, scope, {}, regions, layers);
    return assembly;
}

std::vector<Counts> possible_counts(const Theory& theory, const Assembly& assembly, const ConfigurationSet& among,
                                    bool only_possible, std::size_t limit) {
    if (!assembly.has_composites())
        return with_any_more(assembly.parts, {0}, types_within(assembly.parts, among), limit);
    return Walk(theory, assembly.composites, among, only_possible, limit).run(assembly.parts);
}

std::vector<Counts> with_any_composites(const Parts& parts, const std::vector<Counts>& all_counts,
                                        const std::vector<Counts>& some, bool or_more) {
    std::vector<Counts> result;
    for (const Counts each : all_counts) {
        const bool fits = std::ranges::any_of(some, [&](Counts known) {
            return std::ranges::all_of(parts.classes, [&](const Parts::PartClass& part) {
                const Counts mask = (Counts{1} << std::bit_width(part.cap)) - 1;
                const Counts a = (each >> part.shift) & mask, b = (known >> part.shift) & mask;
                return !part.composites.empty() || (or_more ? a >= b : a == b);
            });
        });
        if (fits) result.push_back(each);
    }
    return result;
}

}  // namespace partonomy::knowledge
