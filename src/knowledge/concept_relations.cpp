/* How the concepts of one layer relate: which are the same, which overlap.

   In a listed space their sets are compared. A compiled one is looked at through models that a SAT solver finds, one
   for each concept at least: concepts that differ in a model differ, and those that never did are asked about pair by
   pair, each answer that they differ being one more model for all (as in SAT sweeping of circuits: Kuehlmann et al.
   2002). Objects that only a solver knows are sets again, of which few are compared. */

#include "knowledge/concept_relations.h"

#include <algorithm>
#include <map>
#include <optional>

#include "knowledge/object_clauses.h"
#include "knowledge/solver.h"

namespace partonomy::knowledge {
namespace {

ConceptRelations relate_listed(const Space& space, const std::vector<std::size_t>& concepts) {
    ConceptRelations relations;
    const auto where = [&](std::size_t c) -> const ConfigurationSet& { return space.concepts[c].where; };
    std::map<ConfigurationSet, std::vector<std::size_t>> groups;
    for (const std::size_t c : concepts) groups[where(c)].push_back(c);
    const ConfigurationSet all = space.all();
    for (const auto& [set, group] : groups) {
        if (set == all)
            relations.universal.insert(relations.universal.end(), group.begin(), group.end());
        else if (group.size() > 1)
            relations.alike.push_back(group);
    }
    for (std::size_t i = 0; i < concepts.size(); ++i) {
        std::vector<std::size_t> others;
        for (std::size_t j = i + 1; j < concepts.size(); ++j) {
            const ConfigurationSet &a = where(concepts[i]), &b = where(concepts[j]);
            if (a.intersects(b) && !a.is_subset_of(b) && !b.is_subset_of(a)) others.push_back(concepts[j]);
        }
        if (!others.empty()) relations.overlapping.emplace_back(concepts[i], std::move(others));
    }
    return relations;
}

/// Models of one region, as a column of bits for each concept.
class Sampler {
public:
    Sampler(const Theory& theory, const Space& space, const std::vector<std::size_t>& concepts)
        : object_(theory, false), concepts_(concepts), columns_(concepts.size()) {
        const std::size_t part = object_.add_region();
        for (const std::size_t c : concepts)
            literals_.push_back(object_.region_concept(part, theory.find(space.concepts[c].iri)));
        object_.require_constraints(Level::region);
        solver_.emplace(object_.clauses);
    }

    ConceptRelations run() {
        for (std::size_t i = 0; i < concepts_.size(); ++i) {
            if (!has_been(i, true)) learn(literals_[i]);
            if (!has_been(i, false)) learn(-literals_[i]);
        }
        ConceptRelations relations;
        std::vector<char> done(concepts_.size(), 0);
        for (std::size_t i = 0; i < concepts_.size(); ++i) {
            if (done[i]) continue;
            if (!has_been(i, false)) {
                relations.universal.push_back(concepts_[i]);
                continue;
            }
            std::vector<std::size_t> group{concepts_[i]};
            for (std::size_t j = i + 1; j < concepts_.size(); ++j)
                if (!done[j] && are_alike(i, j)) {
                    done[j] = 1;
                    group.push_back(concepts_[j]);
                }
            if (group.size() > 1) relations.alike.push_back(std::move(group));
        }
        for (std::size_t i = 0; i < concepts_.size(); ++i) {
            std::vector<std::size_t> others;
            for (std::size_t j = i + 1; j < concepts_.size(); ++j) {
                if (concepts_.size() <= most_to_pair && !overlap(columns_[i], columns_[j]) &&
                    learn(literals_[i], literals_[j]) && learn(literals_[i], -literals_[j]))
                    learn(-literals_[i], literals_[j]);
                if (overlap(columns_[i], columns_[j])) others.push_back(concepts_[j]);
            }
            if (!others.empty()) relations.overlapping.emplace_back(concepts_[i], std::move(others));
        }
        return relations;
    }

private:
    using Column = std::vector<std::uint64_t>;
    static constexpr std::size_t most_to_pair = 64;  ///< of more concepts, only overlaps that a model shows are told

    /// One more model in which both literals are true; false when there is none.
    bool learn(int literal, int other = 0) {
        const std::vector<int> assumptions = other == 0 ? std::vector{literal} : std::vector{literal, other};
        if (solver_->solve(assumptions) == Verdict::unsatisfiable) return false;
        if (models_ % 64 == 0)
            for (Column& column : columns_) column.push_back(0);
        for (std::size_t i = 0; i < literals_.size(); ++i)
            if (solver_->value(std::abs(literals_[i])) == (literals_[i] > 0))
                columns_[i].back() |= std::uint64_t{1} << (models_ % 64);
        ++models_;
        return true;
    }
    [[nodiscard]] bool has_been(std::size_t i, bool value) const {
        for (std::size_t m = 0; m < models_; ++m)
            if (((columns_[i][m / 64] >> (m % 64) & 1U) != 0) == value) return true;
        return false;
    }
    [[nodiscard]] bool are_alike(std::size_t i, std::size_t j) {
        if (literals_[i] == literals_[j]) return true;
        return columns_[i] == columns_[j] && !learn(literals_[i], -literals_[j]) && !learn(-literals_[i], literals_[j]);
    }
    [[nodiscard]] static bool overlap(const Column& a, const Column& b) {
        std::uint64_t both = 0, only_a = 0, only_b = 0;
        for (std::size_t w = 0; w < a.size(); ++w) {
            both |= a[w] & b[w];
            only_a |= a[w] & ~b[w];
            only_b |= b[w] & ~a[w];
        }
        return both != 0 && only_a != 0 && only_b != 0;
    }

    ObjectClauses object_;
    const std::vector<std::size_t>& concepts_;
    std::vector<int> literals_;
    std::vector<Column> columns_;
    std::size_t models_ = 0;
    std::optional<Solver> solver_;
};

}  // namespace

ConceptRelations relate(const Theory& theory, const Space& space, Level level,
                        const std::vector<std::size_t>& concepts) {
    constexpr std::size_t most_objects = 100;  // concepts whose sets the solver compares
    if (concepts.size() > most_compared) return {};
    if (!space.diagram) return relate_listed(space, concepts);
    if (level != Level::object) return Sampler(theory, space, concepts).run();
    return concepts.size() <= most_objects ? relate_listed(space, concepts) : ConceptRelations{};
}

}  // namespace partonomy::knowledge
