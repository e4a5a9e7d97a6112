/* Instead of a diagram: a solver for what is certain, samples for what is likely.

   Which literals are possible or inferred under some evidence is the backbone of the formula, an exact question to an
   incremental solver (solver.cpp). How likely the others are is estimated from models that the solver finds when it is
   told to try random values first. They are drawn once; when too few of them agree with the evidence, others are drawn
   under it by a solver of their own, so that nothing depends on what was asked before. The sample is not uniform, and
   need not be: it only helps to choose the next question, never to answer one. */

#include "knowledge/sampled_models.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <mutex>
#include <random>

#include "knowledge/solver.h"

namespace partonomy::knowledge {
namespace {

constexpr std::size_t sample_size = 256, enough = 64;

ModelSample draw(Solver& solver, int variables, std::size_t wanted, std::span<const int> evidence) {
    ModelSample sample;
    sample.columns.assign(static_cast<std::size_t>(variables) + 1, {});
    std::mt19937 random(1);
    std::vector<int> preferred(static_cast<std::size_t>(variables));
    for (; sample.size < wanted; ++sample.size) {
        for (int v = 1; v <= variables; ++v) preferred[static_cast<std::size_t>(v) - 1] = random() % 2 == 0 ? v : -v;
        solver.prefer(preferred);
        if (solver.solve(evidence) == Verdict::unsatisfiable) break;
        for (int v = 1; v <= variables; ++v) {
            std::vector<std::uint64_t>& column = sample.columns[static_cast<std::size_t>(v)];
            if (sample.size % 64 == 0) column.push_back(0);
            if (solver.value(v)) column.back() |= std::uint64_t{1} << (sample.size % 64);
        }
    }
    return sample;
}

/// The models of `all` in which the evidence is true.
ModelSample those_with(const ModelSample& all, std::span<const int> evidence) {
    ModelSample sample;
    sample.columns.assign(all.columns.size(), {});
    const auto is_true = [&](int literal, std::size_t m) {
        const bool bit = all.columns[static_cast<std::size_t>(std::abs(literal))][m / 64] >> (m % 64) & 1U;
        return bit == (literal > 0);
    };
    for (std::size_t m = 0; m < all.size; ++m) {
        if (!std::ranges::all_of(evidence, [&](int literal) { return is_true(literal, m); })) continue;
        for (std::size_t v = 1; v < all.columns.size(); ++v) {
            if (sample.size % 64 == 0) sample.columns[v].push_back(0);
            if (is_true(static_cast<int>(v), m)) sample.columns[v].back() |= std::uint64_t{1} << (sample.size % 64);
        }
        ++sample.size;
    }
    return sample;
}

}  // namespace

std::size_t ModelSample::count(int literal, int other) const {
    const auto& a = columns[static_cast<std::size_t>(std::abs(literal))];
    const auto& b = columns[static_cast<std::size_t>(std::abs(other))];
    std::size_t total = 0;
    for (std::size_t w = 0; w < a.size(); ++w) {
        std::uint64_t both = (literal > 0 ? a[w] : ~a[w]) & (other > 0 ? b[w] : ~b[w]);
        if (w + 1 == a.size() && size % 64 != 0) both &= (std::uint64_t{1} << (size % 64)) - 1;
        total += static_cast<std::size_t>(std::popcount(both));
    }
    return total;
}

struct SampledModels::State {
    Clauses clauses;
    std::string why;
    int variables;
    std::vector<int> literals;  ///< both of every variable
    ModelSample sample;
    std::mutex mutex;  ///< of the solver
    Solver solver;

    State(const Clauses& formula, std::string reason, int told)
        : clauses(formula), why(std::move(reason)), variables(told), solver(formula) {
        for (int v = 1; v <= variables; ++v) literals.insert(literals.end(), {v, -v});
        Solver own(clauses);
        sample = draw(own, variables, sample_size, {});
    }
};

SampledModels::SampledModels(const Clauses& clauses, std::string why, int variables)
    : state_(std::make_unique<State>(clauses, std::move(why), variables)) {}
SampledModels::~SampledModels() = default;

int SampledModels::variable_count() const { return state_->variables; }
std::size_t SampledModels::clause_count() const { return state_->clauses.size(); }
const std::string& SampledModels::why() const { return state_->why; }

bool SampledModels::has_model(std::span<const int> evidence) const {
    const std::lock_guard lock(state_->mutex);
    return state_->solver.solve(evidence) == Verdict::satisfiable;
}

ModelSample SampledModels::sample(std::span<const int> evidence) const {
    ModelSample fitting = those_with(state_->sample, evidence);
    if (fitting.size >= enough) return fitting;
    Solver own(state_->clauses);
    return draw(own, variable_count(), enough, evidence);
}

Shares SampledModels::shares(std::span<const int> evidence) const {
    Shares shares;
    shares.each.assign(2 * static_cast<std::size_t>(variable_count()) + 2, 0);
    std::vector<int> inferred;
    {
        const std::lock_guard lock(state_->mutex);
        if (state_->solver.solve(evidence) == Verdict::unsatisfiable) {
            shares.log2_total = -std::numeric_limits<double>::infinity();
            return shares;
        }
        inferred = state_->solver.entailed(state_->literals, evidence);
    }
    const auto place = [](int literal) {
        return static_cast<std::size_t>(literal > 0 ? 2 * literal : 1 - 2 * literal);
    };
    for (const int literal : inferred) shares.each[place(literal)] = 1;
    const ModelSample fitting = those_with(state_->sample, evidence);
    for (int v = 1; v <= variable_count(); ++v) {
        if (shares.each[place(v)] + shares.each[place(-v)] > 0) continue;
        // One imagined model of each kind: no share is 0 or 1 unless that is certain.
        const auto yes = static_cast<double>(fitting.count(v) + 1);
        shares.each[place(v)] = yes / static_cast<double>(fitting.size + 2);
        shares.each[place(-v)] = 1 - shares.each[place(v)];
    }
    return shares;
}

}  // namespace partonomy::knowledge
