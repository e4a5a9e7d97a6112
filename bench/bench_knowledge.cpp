/* Configuration spaces of growing size: yes/no concepts, and rules of three literals over neighbouring ones that a
 * hidden configuration obeys. The reference is BuDDy, with the concepts in the order in which rules are local: its best
 * one. It counts in doubles, and needs a diagram for each concept where we take one sweep for all. */

#include "bench/bench_knowledge.h"

#include <bdd.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <random>
#include <set>

#include "knowledge/diagram.h"
#include "knowledge/diagram_questions.h"

namespace partonomy::bench {
namespace {

using knowledge::Clauses;
using knowledge::Diagram;

/// `window` = `concepts`: rules over any of them.
Clauses local_rules(int concepts, int rules, int window, std::size_t literals) {
    std::mt19937 random(1);
    Clauses clauses;
    std::vector<bool> hidden{false};
    for (int v = 0; v < concepts; ++v) {
        static_cast<void>(clauses.add_variable());
        hidden.push_back(random() % 2 == 0);
    }
    while (static_cast<int>(clauses.size()) < rules) {
        const int start = 1 + static_cast<int>(random() % static_cast<unsigned>(concepts - window + 1));
        std::set<int> chosen;
        while (chosen.size() < literals)
            chosen.insert(start + static_cast<int>(random() % static_cast<unsigned>(window)));
        std::vector<int> clause;
        bool is_obeyed = false;
        for (const int v : chosen) {
            clause.push_back(random() % 2 == 0 ? v : -v);
            is_obeyed |= (clause.back() > 0) == hidden[static_cast<std::size_t>(v)];
        }
        if (is_obeyed) clauses.add(clause);
    }
    return clauses;
}

double time_ms(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median_of_five(const std::function<void()>& work) {
    std::vector<double> times;
    for (int i = 0; i < 5; ++i) times.push_back(time_ms(work));
    std::ranges::sort(times);
    return times[2];
}

/// Milliseconds to build the diagram, and to count under each concept; once, since its caches would answer the second.
std::pair<double, double> buddy_times(const Clauses& clauses) {
    bdd_init(1'000'000, 100'000);
    bdd_gbc_hook(nullptr);
    bdd_setmaxincrease(1'000'000);
    bdd_setvarnum(clauses.variable_count() + 1);
    bdd all = bddtrue;
    const double build = time_ms([&] {
        for (std::size_t c = 0; c < clauses.size(); ++c) {
            bdd clause = bddfalse;
            for (const int literal : clauses[c]) clause |= literal > 0 ? bdd_ithvar(literal) : bdd_nithvar(-literal);
            all &= clause;
        }
    });
    double sum = 0;
    const double count = time_ms([&] {
        for (int v = 1; v <= clauses.variable_count(); ++v) sum += bdd_satcountln(all & bdd_ithvar(v));
    });
    all = bddfalse;
    bdd_done();
    return {build, sum < 0 ? 0 : count};
}

void bench_space(int concepts, int rules, int window, std::size_t literals = 3) {
    const Clauses clauses = local_rules(concepts, rules, window, literals);
    const double compile = median_of_five([&] { static_cast<void>(Diagram(clauses)); });
    const Diagram diagram(clauses);
    const knowledge::Count count = diagram.count();
    const double sweep = median_of_five([&] { static_cast<void>(diagram.shares()); });
    const double exact = median_of_five([&] { static_cast<void>(diagram.count_each()); });
    std::vector<knowledge::LiteralQuestion> questions;
    for (int v = 1; v <= concepts; ++v) questions.push_back({v});
    knowledge::ChoiceOptions choice;
    choice.wanted = {1, concepts / 2, concepts};
    const double question = median_of_five([&] { static_cast<void>(best_question(diagram, questions, choice)); });
    fmt::print("  {:>5} {:>5} {:>6} {:>8} 2^{:<7.1f} {:>7} {:>8.1f} {:>7.2f} {:>8.2f} {:>8.2f}", concepts, rules,
               window, literals, count.log2, diagram.node_count(), compile, sweep, exact, question);
    if (window == concepts) {  // it has no good order then
        fmt::print(" {:>9} {:>9}\n", "-", "-");
        return;
    }
    const auto [build, counts] = buddy_times(clauses);
    fmt::print(" {:>9.1f} {:>9.1f} {:>8.2f} {:>8.3f}\n", build, counts, compile / build, exact / counts);
}

}  // namespace

void bench_knowledge() {
    fmt::print("\nConfiguration spaces; reference: BuDDy, its diagram and a count under each concept (ms)\n");
    fmt::print("  {:>5} {:>5} {:>6} {:>8} {:<9} {:>7} {:>8} {:>7} {:>8} {:>8} {:>9} {:>9} {:>8} {:>8}\n", "yes/no",
               "rules", "window", "literals", "models", "nodes", "compile", "shares", "counts", "question", "BuDDy",
               "counts", "ratio", "ratio");
    bench_space(20, 60, 8);
    bench_space(40, 120, 8);
    bench_space(40, 300, 10);
    bench_space(100, 60, 12);
    bench_space(300, 180, 12);
    bench_space(1000, 600, 8);
    bench_space(1000, 600, 12);
    bench_space(1000, 600, 16);
    bench_space(1000, 600, 1000, 2);
    bench_space(1000, 800, 1000, 2);
    bench_space(1000, 200, 1000);
    bench_space(1000, 300, 1000);
}

}  // namespace partonomy::bench
