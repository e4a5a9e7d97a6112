/* From clauses to a diagram: the trace of a search that counts models.

   Decide a variable, propagate units, and what is left falls into components that share no variable: the number of
   models is the product over components and the sum over the two values of the decision (Bayardo and Pehoushek,
   "Counting models using connected components", 2000). A component is known by its unassigned variables and unsatisfied
   clauses; one that was met before is looked up instead of searched (Sang et al. 2004; sharpSAT: Thurley 2006). Writing
   down decisions as nodes and products as branches keeps the answer for every later question (decision-DNNF: Huang and
   Darwiche 2007). With the order of diagram_order.cpp the number of components is at most (variables) x 2^(width).

   We depart from sharpSAT in two ways. Nothing is learned from conflicts: theories of an expert are loose, and cached
   components alone keep the bound. And the variables that an assignment sets free are listed in its branch, so that
   every branch of a node speaks of the same variables (a smooth diagram), and counts under evidence need no correction.
   Definitions multiply nothing: a variable that is equivalent to a formula is propagated or decided one way.

   Why not a binary decision diagram: over independent groups of variables it carries its state through all of them in
   one order, where components just stand side by side; the figures are in docs/configuration-spaces.md. */

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <sstream>

#include "base/errors.h"
#include "knowledge/diagram_nodes.h"

namespace partonomy::knowledge {
namespace {

constexpr int dead = -1, unknown = -2;
constexpr double hopeless_share = 20;
constexpr int depth_limit = 8'000;  // of the recursion: some 4 MB of stack

/// Results by component. Keys are compared in full: two components never share a result by accident.
class Cache {
public:
    Cache() : table_(1 << 10) {}

    [[nodiscard]] int find(std::span<const std::uint32_t> key) const {
        const Entry& entry = table_[place(key, hash(key))];
        return entry.size == 0 ? unknown : entry.node;
    }
    void insert(std::span<const std::uint32_t> key, int node) {
        if (2 * ++count_ > table_.size()) grow();
        const std::uint64_t code = hash(key);
        table_[place(key, code)] = {code, keys_.size(), static_cast<std::uint32_t>(key.size()), node};
        keys_.insert(keys_.end(), key.begin(), key.end());
    }
    [[nodiscard]] std::size_t bytes() const { return table_.size() * sizeof(Entry) + keys_.capacity() * 4; }

private:
    struct Entry {
        std::uint64_t hash = 0;
        std::size_t first = 0;
        std::uint32_t size = 0;  // 0: vacant
        int node = unknown;
    };
    static std::uint64_t hash(std::span<const std::uint32_t> key) {
        std::uint64_t code = 0x9e3779b97f4a7c15U;
        for (const std::uint32_t word : key) {
            code = (code ^ word) * 0xff51afd7ed558ccdU;
            code ^= code >> 32;
        }
        return code;
    }
    [[nodiscard]] std::size_t place(std::span<const std::uint32_t> key, std::uint64_t code) const {
        std::size_t i = code & (table_.size() - 1);
        const auto is_here = [&](const Entry& entry) {
            return entry.hash == code && entry.size == key.size() &&
                   std::equal(key.begin(), key.end(), keys_.begin() + static_cast<std::ptrdiff_t>(entry.first));
        };
        while (table_[i].size != 0 && !is_here(table_[i])) i = (i + 1) & (table_.size() - 1);
        return i;
    }
    void grow() {
        std::vector<Entry> old(table_.size() * 2);
        old.swap(table_);
        for (const Entry& entry : old) {
            if (entry.size == 0) continue;
            std::size_t i = entry.hash & (table_.size() - 1);
            while (table_[i].size != 0) i = (i + 1) & (table_.size() - 1);
            table_[i] = entry;
        }
    }

    std::vector<Entry> table_;
    std::vector<std::uint32_t> keys_;
    std::size_t count_ = 0;
};

/// Lists one behind the other in memory, which the search walks all the time.
class Lists {
public:
    void append(std::span<const int> list) {
        items_.insert(items_.end(), list.begin(), list.end());
        first_.push_back(static_cast<std::uint32_t>(items_.size()));
    }
    [[nodiscard]] std::span<const int> operator[](std::size_t i) const {
        return {items_.data() + first_[i], items_.data() + first_[i + 1]};
    }
    [[nodiscard]] std::size_t size() const { return first_.size() - 1; }

private:
    std::vector<std::uint32_t> first_{0};
    std::vector<int> items_;
};

Lists together(const std::vector<std::vector<int>>& lists) {
    Lists result;
    for (const std::vector<int>& list : lists) result.append(list);
    return result;
}

class Search {
public:
    Search(const Clauses& clauses, const DecisionOrder& order, const DiagramOptions& options)
        : order_(order), options_(options), result_(std::make_shared<Diagram::Nodes>()) {
        const auto n = static_cast<std::size_t>(clauses.variable_count());
        result_->variables = clauses.variable_count();
        values_.assign(n + 1, 0);
        variable_labels_.assign(n + 1, 0);
        std::vector<std::vector<int>> with_literal(2 * n + 2), with_variable(n + 1);
        for (std::size_t c = 0; c < clauses.size(); ++c) read(clauses[c], with_literal, with_variable);
        with_literal_ = together(with_literal);
        with_variable_ = together(with_variable);
        clause_labels_.assign(clauses_.size(), 0);
    }

    std::shared_ptr<const Diagram::Nodes> run() {
        Component whole;
        for (int v = 1; v <= result_->variables; ++v) whole.variables.push_back(v);
        for (std::size_t c = 0; c < clauses_.size(); ++c) whole.clauses.push_back(static_cast<int>(c));
        if (!is_broken_) result_->root = branch(0, whole);
        return result_;
    }

private:
    struct Component {
        std::vector<int> variables, clauses;  // ascending
    };

    static std::size_t index(int literal) { return literal > 0 ? 2 * literal : 1 - 2 * literal; }
    [[nodiscard]] int value(int literal) const { return literal > 0 ? values_[literal] : -values_[-literal]; }

    void read(std::span<const int> literals, std::vector<std::vector<int>>& with_literal,
              std::vector<std::vector<int>>& with_variable) {
        std::vector<int> clause(literals.begin(), literals.end());
        std::ranges::sort(clause);
        clause.erase(std::unique(clause.begin(), clause.end()), clause.end());
        if (std::ranges::any_of(clause, [&](int each) { return std::ranges::binary_search(clause, -each); })) return;
        if (clause.empty()) is_broken_ = true;
        if (clause.size() == 1) units_.push_back(clause[0]);
        const int id = static_cast<int>(clauses_.size());
        for (const int literal : clause) {
            with_literal[index(literal)].push_back(id);
            with_variable[std::abs(literal)].push_back(id);
        }
        satisfied_.push_back(0);
        open_.push_back(static_cast<int>(clause.size()));
        clauses_.append(clause);
    }

    void enqueue(int literal) {
        values_[std::abs(literal)] = literal > 0 ? 1 : -1;
        trail_.push_back(literal);
    }

    /// False when some clause has become false.
    bool propagate() {
        bool fine = true;
        for (; fine && head_ < trail_.size(); ++head_) {
            const int literal = trail_[head_];
            for (const int c : with_literal_[index(literal)]) ++satisfied_[c];
            for (const int c : with_literal_[index(-literal)]) {
                if (--open_[c] > 1 || satisfied_[c] > 0) continue;
                if (open_[c] == 0) fine = false;
                if (!fine) continue;
                for (const int left : clauses_[c]) {
                    if (value(left) < 0) continue;
                    if (value(left) == 0) enqueue(left);
                    break;
                }
            }
        }
        return fine;
    }

    void undo(std::size_t mark) {
        while (trail_.size() > mark) {
            const int literal = trail_.back();
            trail_.pop_back();
            values_[std::abs(literal)] = 0;
            if (trail_.size() >= head_) continue;  // was never propagated
            for (const int c : with_literal_[index(literal)]) --satisfied_[c];
            for (const int c : with_literal_[index(-literal)]) ++open_[c];
        }
        head_ = std::min(head_, mark);
    }

    /// What is left of `whole`, in pieces that share no variable; the variables of no piece are free.
    void split(const Component& whole, std::vector<Component>& pieces, std::vector<int>& free) {
        const std::uint64_t first = next_label_;
        for (const int start : whole.variables) {
            if (values_[start] != 0 || variable_labels_[start] >= first) continue;
            bool is_free = true;
            queue_.assign(1, start);
            variable_labels_[start] = next_label_;
            for (std::size_t i = 0; i < queue_.size(); ++i)
                for (const int c : with_variable_[queue_[i]]) {
                    if (satisfied_[c] > 0 || clause_labels_[c] >= first) continue;
                    clause_labels_[c] = next_label_;
                    is_free = false;
                    for (const int literal : clauses_[c]) {
                        const int v = std::abs(literal);
                        if (values_[v] != 0 || variable_labels_[v] >= first) continue;
                        variable_labels_[v] = next_label_;
                        queue_.push_back(v);
                    }
                }
            if (is_free) {
                free.push_back(start);
                variable_labels_[start] = 0;
            } else {
                ++next_label_;
                pieces.emplace_back();
                pieces.back().variables.reserve(queue_.size());
            }
        }
        for (const int v : whole.variables)
            if (variable_labels_[v] >= first) pieces[variable_labels_[v] - first].variables.push_back(v);
        for (const int c : whole.clauses)
            if (clause_labels_[c] >= first) pieces[clause_labels_[c] - first].clauses.push_back(c);
    }

    /// Clauses of two literals are left out: unsatisfied, with a variable in the component, they have lost none.
    [[nodiscard]] std::vector<std::uint32_t> key_of(const Component& component) const {
        std::vector<std::uint32_t> key;
        for (const int v : component.variables) key.push_back(static_cast<std::uint32_t>(v));
        key.push_back(0);
        for (const int c : component.clauses)
            if (clauses_[c].size() > 2) key.push_back(static_cast<std::uint32_t>(c));
        return key;
    }

    int solve(const Component& component) {
        const std::vector<std::uint32_t> key = key_of(component);
        if (const int known = cache_.find(key); known != unknown) return known;
        if (++depth_ > depth_limit) give_up("nests deeper than " + std::to_string(depth_limit) + " decisions");
        const int v = *std::ranges::min_element(component.variables, {}, [&](int each) { return order_.ranks[each]; });
        const std::array<DiagramBranch, 2> both{branch(v, component), branch(-v, component)};
        --depth_;
        int node = dead;
        if (!both[0].is_dead || !both[1].is_dead) {
            node = static_cast<int>(result_->nodes.size());
            result_->nodes.push_back(both);
        }
        cache_.insert(key, node);
        check_limits();
        return node;
    }

    /// What becomes of the component when `literal` (0: the unit clauses) is true.
    DiagramBranch branch(int literal, const Component& component) {
        const std::size_t mark = trail_.size();
        bool fine = true;
        if (literal != 0) enqueue(literal);
        for (const int unit : units_) {
            if (literal != 0) break;
            fine = fine && value(unit) >= 0;
            if (value(unit) == 0) enqueue(unit);
        }
        DiagramBranch made;
        if (fine && propagate()) {
            std::vector<Component> pieces;
            std::vector<int> free, children;
            steps_ += component.variables.size() + component.clauses.size();
            split(component, pieces, free);
            for (const Component& piece : pieces) {
                children.push_back(solve(piece));
                if (children.back() == dead) break;
            }
            if (children.empty() || children.back() != dead) {
                std::vector<int>& pool = result_->pool;
                made = {pool.size(), static_cast<std::uint32_t>(trail_.size() - mark),
                        static_cast<std::uint32_t>(free.size()), static_cast<std::uint32_t>(children.size()), false};
                pool.insert(pool.end(), trail_.begin() + static_cast<std::ptrdiff_t>(mark), trail_.end());
                pool.insert(pool.end(), free.begin(), free.end());
                pool.insert(pool.end(), children.begin(), children.end());
            }
        }
        undo(mark);
        return made;
    }

    void check_limits() {
        if (result_->nodes.size() > options_.node_limit)
            give_up("has more than " + std::to_string(options_.node_limit) + " nodes");
        const double million_steps = static_cast<double>(steps_) / 1e6;
        if (million_steps > options_.step_limit / (order_.is_hopeless ? hopeless_share : 1))
            give_up((order_.is_hopeless ? "would take far more than " : "takes more than ") +
                    in_words(options_.step_limit) + " million steps to make");
        if (++checks_ % 256 != 0) return;
        const std::size_t bytes =
            cache_.bytes() + 4 * result_->pool.capacity() + sizeof(DiagramBranch) * 2 * result_->nodes.capacity();
        if (bytes > options_.memory_limit)
            give_up("takes more than " + std::to_string(options_.memory_limit >> 20) + " MB");
        if (options_.seconds_limit <= 0) return;
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        if (seconds > options_.seconds_limit)
            give_up("takes longer than " + in_words(options_.seconds_limit) + " s to make");
    }
    static std::string in_words(double number) {
        std::ostringstream out;
        out << number;
        return out.str();
    }

    [[noreturn]] void give_up(const std::string& why) const {
        throw OntologyError("the decision diagram of its configurations " + why +
                            "; raise that limit, or let rules tie fewer concepts together (up to " +
                            std::to_string(order_.width) + " have to be decided as one)");
    }

    const DecisionOrder& order_;
    const DiagramOptions& options_;
    std::shared_ptr<Diagram::Nodes> result_;
    Lists clauses_, with_literal_, with_variable_;
    std::vector<int> satisfied_, open_;  // literals of each clause that are true; that are not false
    std::vector<int> units_;
    bool is_broken_ = false;  // there is an empty clause
    std::vector<signed char> values_;
    std::vector<int> trail_;
    std::size_t head_ = 0;
    std::vector<std::uint64_t> variable_labels_, clause_labels_;  // which piece, when last split
    std::uint64_t next_label_ = 1, steps_ = 0, checks_ = 0;
    std::vector<int> queue_;
    Cache cache_;
    int depth_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

std::shared_ptr<const Diagram::Nodes> search_diagram(const Clauses& clauses, const DecisionOrder& order,
                                                     const DiagramOptions& options) {
    return Search(clauses, order, options).run();
}

}  // namespace partonomy::knowledge
