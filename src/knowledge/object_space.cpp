#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <span>

#include "base/errors.h"
#include "knowledge/theory.h"

// What an object can be made of. Object concepts only count parts of certain classes, so the atoms "at least k parts
// are C" are the features of an object; but not every combination of them exists: whoever has 2 seats has 1, and
// whoever has a compact seat has a seat. Which combinations some set of parts realises is found without listing such
// sets. Configurations of a region that no part class tells apart are one *type* of part. Counts per class matter up to
// the highest threshold only, so a vector of capped counts fits a word, and adding parts one after the other reaches
// all the vectors there are; since the order does not matter, all of one type come before all of the next. Cost: at
// most (reachable vectors) x (types) x (classes of a type).

namespace partonomy::knowledge {
namespace {

/// Counts seen so far; a hash table in one piece.
class CountSet {
public:
    /// False when it was there already.
    bool insert(Counts counts) {
        if (2 * (size_ + 1) > slots_.size()) grow();
        if (!place(counts)) return false;
        ++size_;
        return true;
    }

private:
    static constexpr Counts free = ~Counts{0};  // no count is as high as that in all classes

    bool place(Counts counts) {
        std::size_t at = static_cast<std::size_t>(counts * 0x9E3779B97F4A7C15U >> shift_);
        for (; slots_[at] != free; at = at + 1 == slots_.size() ? 0 : at + 1)
            if (slots_[at] == counts) return false;
        slots_[at] = counts;
        return true;
    }
    void grow() {
        const std::vector<Counts> old = std::move(slots_);
        slots_.assign(old.empty() ? 64 : 2 * old.size(), free);
        shift_ = 64 - std::countr_zero(slots_.size());
        for (const Counts counts : old)
            if (counts != free) place(counts);
    }

    std::vector<Counts> slots_;
    int shift_ = 0;
    std::size_t size_ = 0;
};

/// Adds the same counts again and again.
class Adder {
public:
    Adder(const Parts& parts, Counts added) {
        for (const Parts::PartClass& part : parts.classes) {
            const Counts mask = ((Counts{1} << std::bit_width(part.cap)) - 1) << part.shift;
            if ((added & mask) != 0) fields_.push_back({mask, Counts{part.cap} << part.shift, added & mask});
        }
    }
    Counts operator()(Counts counts) const {
        for (const Field& field : fields_) counts += std::min(field.full - (counts & field.mask), field.added);
        return counts;
    }

private:
    struct Field {
        Counts mask, full, added;
    };
    std::vector<Field> fields_;
};

constexpr std::size_t most_types = 20'000;  // where a solver has to do without counts

}  // namespace

std::string too_many_classes(const Parts& parts) {
    return "the concepts of one layer count " + std::to_string(parts.classes.size()) +
           " classes of parts, more than can be combined; count fewer classes, or to lower numbers";
}

Variable part_variable(const Parts::Atom& atom, bool of_composites) {
    Variable variable{};
    variable.kind = VariableKind::parts;
    variable.values = {"yes", "no"};
    variable.part_class = atom.as_written;
    variable.threshold = atom.threshold;
    variable.of_composites = of_composites;
    return variable;
}

Counts Parts::add(Counts counts, const Type& type) const {
    for (const std::size_t c : type.classes) {
        const PartClass& part = classes[c];
        const Counts mask = (Counts{1} << std::bit_width(part.cap)) - 1;
        if (((counts >> part.shift) & mask) < part.cap) counts += Counts{1} << part.shift;
    }
    return counts;
}

bool Parts::holds(Counts counts, const Atom& atom) const {
    const PartClass& part = classes[atom.part];
    const Counts mask = (Counts{1} << std::bit_width(part.cap)) - 1;
    return ((counts >> part.shift) & mask) >= atom.threshold;
}

Counts Parts::sum(Counts a, Counts b) const {
    Counts result = 0;
    for (const PartClass& part : classes) {
        const Counts mask = (Counts{1} << std::bit_width(part.cap)) - 1;
        const Counts total = ((a >> part.shift) & mask) + ((b >> part.shift) & mask);
        result |= std::min<Counts>(total, part.cap) << part.shift;
    }
    return result;
}

Parts find_parts(const Theory& theory, const Scope& scope, Subject subject, const Layer& regions,
                 std::span<const Layer* const> groups) {
    Parts parts;
    parts.atom_of.assign(theory.formulas.size(), -1);
    const auto visit = [&](const auto& self, FormulaId id) -> void {
        const Formula& formula = theory.formulas[id];
        for (const FormulaId operand : formula.operands) self(self, operand);
        if (formula.kind != Formula::Kind::parts) return;
        const bool of_regions = formula.part_level == Level::region;
        Parts::PartClass wanted{of_regions ? evaluate(theory, regions, formula.index) : regions.space.none(), {}, 0, 0};
        bool is_empty = wanted.where.is_empty();
        for (std::size_t g = 0; !of_regions && g < groups.size(); ++g) {
            wanted.composites.push_back(groups[g] ? evaluate(theory, *groups[g], formula.index) : ConfigurationSet());
            is_empty &= wanted.composites.back().is_empty();
        }
        if (is_empty) return;
        auto part = std::ranges::find_if(parts.classes, [&](const Parts::PartClass& each) {
            return each.where == wanted.where && each.composites == wanted.composites;
        });
        if (part == parts.classes.end()) part = parts.classes.insert(part, std::move(wanted));
        part->cap = std::max(part->cap, formula.threshold);
        const auto index = static_cast<std::size_t>(part - parts.classes.begin());
        const auto atom = std::ranges::find_if(
            parts.atoms, [&](const Parts::Atom& a) { return a.part == index && a.threshold == formula.threshold; });
        parts.atom_of[id] = static_cast<int>(atom - parts.atoms.begin());
        if (atom == parts.atoms.end()) parts.atoms.push_back({index, formula.threshold, formula.part_class});
    };
    std::vector<std::pair<std::size_t, FormulaId>> formulas, around;  // in the order in which they were written
    for (std::size_t id = 0; id < theory.concepts.size(); ++id) {
        const NamedConcept& named = theory.concepts[id];
        if (named.definition < 0 || !scope.concepts[id] || !scope.axioms[named.axiom]) continue;
        (subject.has(named) ? formulas : around).emplace_back(named.axiom, named.definition);
    }
    for (const Constraint& constraint : theory.constraints)
        if (scope.axioms[constraint.axiom])
            (constraint.level == subject.level ? formulas : around).emplace_back(constraint.axiom, constraint.formula);
    std::ranges::sort(formulas);
    for (const auto& [axiom, formula] : formulas) visit(visit, formula);
    // What others ask of a composite part: hasPart some (Back and hasPart some Headrest).
    const auto look_inside = [&](const auto& self, FormulaId id) -> void {
        const Formula& formula = theory.formulas[id];
        for (const FormulaId operand : formula.operands) self(self, operand);
        if (formula.kind != Formula::Kind::parts || formula.part_level != Level::composite) return;
        visit(visit, formula.index);
        self(self, formula.index);
    };
    std::ranges::sort(around);
    if (subject.level == Level::composite)
        for (const auto& [axiom, formula] : around) look_inside(look_inside, formula);

    unsigned shift = 0;
    for (Parts::PartClass& part : parts.classes) {
        part.shift = shift;
        shift += static_cast<unsigned>(std::bit_width(part.cap));
    }
    parts.fits = shift <= 64;
    if (!parts.fits && (subject.level != Level::object || !groups.empty()))
        throw OntologyError(too_many_classes(parts));

    parts.types.push_back({{}, regions.space.all()});
    for (std::size_t c = 0; c < parts.classes.size(); ++c) {
        if (!parts.classes[c].composites.empty()) continue;
        std::vector<Parts::Type> finer;
        for (Parts::Type& type : parts.types) {
            Parts::Type inside{type.classes, type.where & parts.classes[c].where};
            inside.classes.push_back(c);
            type.where -= parts.classes[c].where;
            if (!type.where.is_empty()) finer.push_back(std::move(type));
            if (!inside.where.is_empty()) finer.push_back(std::move(inside));
        }
        parts.types = std::move(finer);
        if (!parts.fits && parts.types.size() > most_types) throw OntologyError(too_many_classes(parts));
    }
    std::erase_if(parts.types, [](const Parts::Type& type) { return type.where.is_empty(); });
    return parts;
}

std::vector<std::size_t> types_within(const Parts& parts, const ConfigurationSet& regions) {
    std::vector<std::size_t> types;
    for (std::size_t t = 0; t < parts.types.size(); ++t)
        if (parts.types[t].where.intersects(regions)) types.push_back(t);
    return types;
}

std::vector<Counts> with_one_more(const Parts& parts, const std::vector<Counts>& counts,
                                  const std::vector<std::size_t>& types) {
    if (counts.size() == 1 && types.size() == 1) return {parts.add(counts[0], parts.types[types[0]])};
    std::vector<Counts> result;
    CountSet seen;
    for (const std::size_t t : types) {
        const Adder adder(parts, parts.add(0, parts.types[t]));
        for (const Counts each : counts)
            if (const Counts more = adder(each); seen.insert(more)) result.push_back(more);
    }
    std::ranges::sort(result);
    return result;
}

std::vector<Counts> with_any_more(const Parts& parts, const std::vector<Counts>& counts,
                                  const std::vector<std::size_t>& types, std::size_t limit) {
    std::vector<Counts> steps;
    for (const std::size_t t : types) steps.push_back(parts.add(0, parts.types[t]));
    return with_any_steps(parts, counts, steps, limit);
}

std::vector<Counts> with_any_steps(const Parts& parts, const std::vector<Counts>& counts,
                                   const std::vector<Counts>& steps, std::size_t limit) {
    // They can be added in any order: the first as often as one likes, then the second …
    std::vector<Counts> reached = counts;
    CountSet seen;
    for (const Counts each : counts) seen.insert(each);
    for (const Counts step : steps) {
        const Adder adder(parts, step);
        for (std::size_t next = 0; next < reached.size(); ++next) {
            const Counts more = adder(reached[next]);
            if (more == reached[next] || !seen.insert(more)) continue;
            reached.push_back(more);
            if (reached.size() > limit)
                throw OntologyError("the parts of an object combine in more than " + std::to_string(limit) +
                                    " ways; count fewer classes of parts, or to lower numbers");
        }
    }
    std::ranges::sort(reached);
    return reached;
}

std::vector<Counts> reachable_counts(const Parts& parts, const std::vector<ConfigurationSet>& regions) {
    std::vector<std::vector<std::size_t>> types;
    for (const ConfigurationSet& region : regions)
        types.push_back(types_within(parts, region.is_empty() ? region.complement() : region));
    std::ranges::sort(types, [](const auto& a, const auto& b) {  // the sure ones keep the set small
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    });
    std::vector<Counts> counts{0};
    for (std::size_t i = 0; i < types.size(); ++i) {
        std::vector<Counts> more = with_one_more(parts, counts, types[i]);
        if (more == counts)  // nor would another such part change anything
            while (i + 1 < types.size() && types[i + 1] == types[i]) ++i;
        counts = std::move(more);
    }
    return counts;
}

ConfigurationSet ObjectLayer::of(const std::vector<Counts>& some) const {
    ConfigurationSet result(layer.space.size);
    std::vector<char> wanted(configurations.size(), 0);
    for (const Counts each : some) {
        const auto found = std::ranges::lower_bound(counts, each);
        if (found != counts.end() && *found == each) wanted[row[static_cast<std::size_t>(found - counts.begin())]] = 1;
    }
    for (std::size_t r = 0; r < wanted.size(); ++r)
        if (wanted[r])
            for (std::size_t i = configurations[r].first; i < configurations[r].second; ++i) result.insert(i);
    return result;
}

ObjectLayer build_objects(const Theory& theory, const Scope& scope, Subject subject, const Parts& parts,
                          std::vector<Counts> counts, std::size_t limit) {
    ObjectLayer objects;
    objects.counts = std::move(counts);
    // "No" of each atom, so that a yes sorts first; the bits of one assignment after those of the other.
    const std::size_t atoms = parts.atoms.size(), words = (atoms + 63) / 64;
    std::vector<std::uint64_t> bits(objects.counts.size() * words, 0);
    for (std::size_t i = 0; i < objects.counts.size(); ++i)
        for (std::size_t a = 0; a < atoms; ++a)
            if (!parts.holds(objects.counts[i], parts.atoms[a]))
                bits[i * words + a / 64] |= std::uint64_t{1} << (63 - a % 64);
    const auto assignment = [&](std::size_t i) { return std::span(bits).subspan(i * words, words); };
    std::vector<std::size_t> order(objects.counts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return words == 1 ? bits[a] < bits[b] : std::ranges::lexicographical_compare(assignment(a), assignment(b));
    });
    std::vector<std::size_t> assignments;  // by row: one of the counts that have it
    objects.row.resize(objects.counts.size());
    for (const std::size_t i : order) {
        if (assignments.empty() || !std::ranges::equal(assignment(i), assignment(assignments.back())))
            assignments.push_back(i);
        objects.row[i] = assignments.size() - 1;
    }

    Layer& layer = objects.layer;
    Space& space = layer.space;
    layer.atoms = parts.atom_of;
    for (const Parts::Atom& atom : parts.atoms) {
        space.variables.push_back(part_variable(atom, !parts.classes[atom.part].composites.empty()));
    }
    const std::size_t primitives = add_primitives(theory, scope, subject, layer);
    const std::size_t copies = primitives < 63 ? std::size_t{1} << primitives : std::numeric_limits<std::size_t>::max();
    if (copies > limit / std::max<std::size_t>(1, assignments.size()))
        throw OntologyError("the parts of an object combine in more than " + std::to_string(limit) + " ways, with " +
                            std::to_string(primitives) + " concepts without definition; give them an EquivalentTo");
    space.product = space.variables.size() < 64 ? std::size_t{1} << space.variables.size()
                                                : std::numeric_limits<std::size_t>::max();
    space.size = assignments.size() * copies;
    space.holds.assign(space.variables.size(), std::vector<ConfigurationSet>(2, ConfigurationSet(space.size)));
    for (std::size_t i = 0; i < space.size; ++i) {
        const auto no = assignment(assignments[i / copies]);
        for (std::size_t v = 0; v < atoms; ++v) space.holds[v][no[v / 64] >> (63 - v % 64) & 1].insert(i);
        for (std::size_t p = 0; p < primitives; ++p)
            space.holds[atoms + p][(i % copies) >> (primitives - 1 - p) & 1].insert(i);
    }
    const ConfigurationSet allowed = close_layer(theory, scope, subject, layer);
    std::size_t next = 0;  // configurations that are allowed, numbered anew
    for (std::size_t r = 0; r < assignments.size(); ++r) {
        const std::size_t first = next;
        for (std::size_t i = r * copies; i < (r + 1) * copies; ++i) next += allowed.has(i) ? 1 : 0;
        objects.configurations.emplace_back(first, next);
    }
    return objects;
}

}  // namespace partonomy::knowledge
