/* Questions to a diagram are sweeps over its nodes. Up: a branch is worth the product of its literals, its free
   variables and its children, a node the sum of its branches; the root is the count. Down: how much of the count flows
   through each branch gives every literal its share at once (Darwiche, "A differential approach to inference in
   Bayesian networks", 2003). Literals that contradict the evidence are worth 0, others 1, or their weight.

   The same sweep runs in three kinds of numbers: exact ones (GMP), doubles with an exponent of their own, which
   neither overflow nor vanish when there are more than 2^1000 configurations, and plain doubles where counts of models
   cannot get there. Nothing is subtracted, so what is 0 is exactly 0. Cost: Diagram::literal_count operations.

   The same few conjunctions are asked about again and again (every window of a street has the same answers), so what a
   sweep found is remembered. */

#include "knowledge/diagram.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>

#include "knowledge/diagram_nodes.h"
#include "knowledge/sampled_models.h"

namespace partonomy::knowledge {
namespace {

/// mantissa x 2^(256 exponent), the mantissa between 2^-256 and 2^256; or 0.
class Scaled {
public:
    Scaled(double mantissa = 0, int exponent = 0) : mantissa_(mantissa), exponent_(exponent) {
        if (mantissa_ == 0) exponent_ = 0;
        while (mantissa_ >= high) mantissa_ *= low, ++exponent_;
        while (mantissa_ != 0 && mantissa_ < low) mantissa_ *= high, --exponent_;
    }
    friend Scaled operator*(const Scaled& a, const Scaled& b) {
        return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
    }
    friend Scaled operator+(const Scaled& a, const Scaled& b) {
        if (a.mantissa_ == 0 || b.mantissa_ == 0) return a.mantissa_ == 0 ? b : a;
        if (a.exponent_ == b.exponent_) return {a.mantissa_ + b.mantissa_, a.exponent_};
        const Scaled &large = a.exponent_ > b.exponent_ ? a : b, &small = a.exponent_ > b.exponent_ ? b : a;
        return large.exponent_ - small.exponent_ > 1 ? large
                                                     : Scaled(large.mantissa_ + small.mantissa_ * low, large.exponent_);
    }
    Scaled& operator*=(const Scaled& other) { return *this = *this * other; }
    void divide(const Scaled& other) { *this = {mantissa_ / other.mantissa_, exponent_ - other.exponent_}; }
    Scaled& operator+=(const Scaled& other) { return *this = *this + other; }
    [[nodiscard]] bool is_zero() const { return mantissa_ == 0; }
    [[nodiscard]] double log2() const { return std::log2(mantissa_) + 256.0 * exponent_; }
    /// The share of `total`; not 0 unless this is.
    [[nodiscard]] double share(const Scaled& total) const {
        if (is_zero()) return 0;
        const int shift = std::max(exponent_ - total.exponent_, -10);
        return std::max(std::ldexp(mantissa_ / total.mantissa_, 256 * shift), std::numeric_limits<double>::min());
    }

private:
    static constexpr double high = 0x1p256, low = 0x1p-256;
    double mantissa_;
    int exponent_;
};

/// A count below 2^1000.
class Plain {
public:
    Plain(double value = 0) : value_(value) {}
    Plain& operator*=(const Plain& other) {
        value_ *= other.value_;
        return *this;
    }
    Plain& operator+=(const Plain& other) {
        value_ += other.value_;
        return *this;
    }
    void divide(const Plain& other) { value_ /= other.value_; }
    [[nodiscard]] bool is_zero() const { return value_ == 0; }
    [[nodiscard]] double log2() const { return std::log2(value_); }
    [[nodiscard]] double share(const Plain& total) const { return is_zero() ? 0 : value_ / total.value_; }

private:
    double value_;
};

class Exact {
public:
    Exact(long value = 0) : value_(value) {}
    Exact& operator*=(const Exact& other) {
        if (other.value_ != 1) value_ *= other.value_;
        return *this;
    }
    Exact& operator+=(const Exact& other) {
        value_ += other.value_;
        return *this;
    }
    void divide(const Exact& other) { mpz_divexact(value_.get_mpz_t(), value_.get_mpz_t(), other.value_.get_mpz_t()); }
    [[nodiscard]] bool is_zero() const { return value_ == 0; }
    [[nodiscard]] Count count() const {
        if (is_zero()) return {"0", -std::numeric_limits<double>::infinity()};
        long exponent = 0;
        const double mantissa = mpz_get_d_2exp(&exponent, value_.get_mpz_t());
        return {value_.get_str(), std::log2(mantissa) + static_cast<double>(exponent)};
    }

private:
    mpz_class value_;
};

std::size_t index(int literal) { return literal > 0 ? 2 * literal : 1 - 2 * literal; }

template <typename Number>
class Sweep {
public:
    Sweep(const Diagram::Nodes& nodes, std::span<const int> evidence, std::span<const LiteralWeight> weights)
        : nodes_(nodes), weights_(2 * static_cast<std::size_t>(nodes.variables) + 2, Number(1)) {
        for (const LiteralWeight& each : weights) {
            if (!(each.weight >= 0) || std::isinf(each.weight))
                throw std::invalid_argument("Diagram: the weight of a literal should be a number that is not negative");
            if constexpr (!std::is_same_v<Number, Exact>) weights_[checked(each.literal)] *= Number(each.weight);
        }
        for (const int literal : evidence) weights_[checked(-literal)] = Number(0);
        up_.reserve(nodes.nodes.size());
        for (const auto& both : nodes.nodes) {
            Number sum = worth(both[0]);
            sum += worth(both[1]);
            up_.push_back(std::move(sum));
        }
        total_ = worth(nodes.root);
    }

    [[nodiscard]] const Number& total() const { return total_; }
    [[nodiscard]] bool is_allowed(int literal) const { return !weights_[index(literal)].is_zero(); }
    [[nodiscard]] Number worth(const DiagramBranch& branch) const {
        if (branch.is_dead) return Number(0);
        Number product = own_worth(branch);
        for (const int child : nodes_.children(branch)) {
            if (product.is_zero()) break;
            product *= up_[child];
        }
        return product;
    }

    /// The part of the total in which each literal is true.
    [[nodiscard]] std::vector<Number> down() const {
        std::vector<Number> parts(weights_.size(), Number(0));
        if (total_.is_zero()) return parts;
        std::vector<Number> flows(up_.size(), Number(0)),
            free(static_cast<std::size_t>(nodes_.variables) + 1, Number(0)), after;
        const auto pass_on = [&](const DiagramBranch& branch, const Number& flow) {
            spread(branch, flow, parts, free, flows, after);
        };
        pass_on(nodes_.root, Number(1));
        for (std::size_t i = up_.size(); i-- > 0;) {
            if (flows[i].is_zero() || up_[i].is_zero()) continue;
            for (const DiagramBranch& branch : nodes_.nodes[i]) pass_on(branch, flows[i]);
        }
        for (int v = 1; v <= nodes_.variables; ++v) {
            if (free[v].is_zero()) continue;
            free[v].divide(either(v));
            for (const int literal : {v, -v}) {
                Number part = free[v];
                part *= weights_[index(literal)];
                parts[index(literal)] += part;
            }
        }
        return parts;
    }

private:
    [[nodiscard]] std::size_t checked(int literal) const {
        if (literal == 0 || std::abs(literal) > nodes_.variables)
            throw std::invalid_argument("Diagram: there is no literal " + std::to_string(literal));
        return index(literal);
    }

    [[nodiscard]] Number either(int variable) const {
        Number sum = weights_[2 * variable];
        sum += weights_[2 * variable + 1];
        return sum;
    }

    /// Of the literals and free variables.
    [[nodiscard]] Number own_worth(const DiagramBranch& branch) const {
        Number product(1);
        for (const int literal : nodes_.literals(branch)) {
            const Number& weight = weights_[index(literal)];
            if (weight.is_zero()) return Number(0);
            product *= weight;
        }
        for (const int variable : nodes_.free(branch)) product *= either(variable);
        return product;
    }

    /// `after` is room to work in.
    void spread(const DiagramBranch& branch, const Number& flow, std::vector<Number>& parts, std::vector<Number>& free,
                std::vector<Number>& flows, std::vector<Number>& after) const {
        if (branch.is_dead) return;
        Number outside = own_worth(branch);
        if (outside.is_zero()) return;
        outside *= flow;
        const std::span<const int> children = nodes_.children(branch);
        // A child gets what the branch is worth without it: all before it times all after it.
        after.assign(children.size() + 1, Number(1));
        for (std::size_t i = children.size(); i-- > 0;) {
            after[i] = after[i + 1];
            after[i] *= up_[children[i]];
        }
        Number whole = outside;
        whole *= after[0];
        Number before = std::move(outside);
        for (std::size_t i = 0; i < children.size(); ++i) {
            Number share = before;
            share *= after[i + 1];
            flows[children[i]] += share;
            before *= up_[children[i]];
        }
        if (whole.is_zero()) return;
        for (const int literal : nodes_.literals(branch)) parts[index(literal)] += whole;
        for (const int variable : nodes_.free(branch)) free[variable] += whole;
    }

    const Diagram::Nodes& nodes_;
    std::vector<Number> weights_, up_;
    Number total_;
};

/// Walks every way from the root to a model, and only those: a branch without a model is not entered.
class ModelWalk {
public:
    ModelWalk(const Diagram::Nodes& nodes, std::size_t limit, std::span<const int> evidence)
        : nodes_(nodes), limit_(limit), sweep_(nodes, evidence, {}) {}

    std::vector<std::vector<int>> run() {
        if (!sweep_.total().is_zero()) enter(nodes_.root);
        return std::move(models_);
    }

private:
    void enter(const DiagramBranch& branch) {
        if (sweep_.worth(branch).is_zero()) return;
        const std::size_t chosen = chosen_.size();
        const std::vector<int> open = open_;
        for (const int literal : nodes_.literals(branch)) chosen_.push_back(literal);
        for (const int variable : nodes_.free(branch)) open_.push_back(-variable);
        for (const int child : nodes_.children(branch)) open_.push_back(child);
        go_on();
        chosen_.resize(chosen);
        open_ = open;
    }

    void go_on() {
        if (models_.size() >= limit_) return;
        if (open_.empty()) {
            std::vector<int> model;
            for (const int literal : chosen_)
                if (literal > 0) model.push_back(literal);
            std::ranges::sort(model);
            models_.push_back(std::move(model));
            return;
        }
        const int next = open_.back();
        open_.pop_back();
        if (next >= 0) {
            for (const DiagramBranch& branch : nodes_.nodes[next]) enter(branch);
        } else {
            for (const int literal : {-next, next}) {
                if (!sweep_.is_allowed(literal)) continue;
                chosen_.push_back(literal);
                go_on();
                chosen_.pop_back();
            }
        }
        open_.push_back(next);
    }

    const Diagram::Nodes& nodes_;
    std::size_t limit_;
    Sweep<Scaled> sweep_;
    std::vector<int> chosen_, open_;  ///< open: nodes, and the negated numbers of free variables
    std::vector<std::vector<int>> models_;
};

Count counted(bool has_model) {
    if (has_model) return {too_many, 0};
    return {"0", -std::numeric_limits<double>::infinity()};
}

template <typename Number>
Shares shares_of(const Diagram::Nodes& nodes, std::span<const int> evidence, std::span<const LiteralWeight> weights) {
    const Sweep<Number> sweep(nodes, evidence, weights);
    Shares shares{sweep.total().log2(), {}};
    for (const Number& part : sweep.down()) shares.each.push_back(part.share(sweep.total()));
    return shares;
}

}  // namespace

/// Shares by evidence; forgotten all at once when they fill their room.
class Diagram::Memory {
public:
    [[nodiscard]] std::shared_ptr<const Shares> find(const std::vector<int>& evidence) {
        const std::scoped_lock lock(mutex_);
        const auto found = known_.find(evidence);
        return found == known_.end() ? nullptr : found->second;
    }
    void insert(std::vector<int> evidence, std::shared_ptr<const Shares> shares) {
        const std::scoped_lock lock(mutex_);
        const std::size_t size = shares->each.size();
        if (numbers_ + size > most_numbers) known_.clear(), numbers_ = 0;
        if (known_.emplace(std::move(evidence), std::move(shares)).second) numbers_ += size;
    }

private:
    static constexpr std::size_t most_numbers = 4'000'000;  // 32 MB
    std::mutex mutex_;
    std::map<std::vector<int>, std::shared_ptr<const Shares>> known_;
    std::size_t numbers_ = 0;
};

Diagram::Diagram() : memory_(std::make_shared<Memory>()) {}

Diagram::Diagram(const Clauses& clauses, const DiagramOptions& options)
    : nodes_(search_diagram(clauses, decision_order(clauses), options)), memory_(std::make_shared<Memory>()) {}

Diagram Diagram::sampled(const Clauses& clauses, std::string why, int variables) {
    Diagram diagram;
    diagram.sample_ = std::make_shared<const SampledModels>(clauses, std::move(why),
                                                            variables > 0 ? variables : clauses.variable_count());
    return diagram;
}

std::size_t Diagram::node_count() const { return sample_ ? 0 : nodes_->nodes.size(); }
std::size_t Diagram::literal_count() const { return sample_ ? sample_->clause_count() : nodes_->pool.size(); }
int Diagram::variable_count() const { return sample_ ? sample_->variable_count() : nodes_->variables; }
bool Diagram::is_empty() const { return sample_ ? !sample_->has_model({}) : nodes_->root.is_dead; }

Count Diagram::count(std::span<const int> evidence) const {
    if (sample_) return counted(sample_->has_model(evidence));
    return Sweep<Exact>(*nodes_, evidence, {}).total().count();
}

LiteralCounts Diagram::count_each(std::span<const int> evidence) const {
    LiteralCounts counts;
    if (sample_) {
        const Shares shares = sample_->shares(evidence);
        counts.total = counted(!std::isinf(shares.log2_total));
        for (const double share : shares.each) counts.each.push_back(counted(share > 0));
        return counts;
    }
    const Sweep<Exact> sweep(*nodes_, evidence, {});
    counts.total = sweep.total().count();
    for (const Exact& part : sweep.down()) counts.each.push_back(part.count());
    return counts;
}

Shares Diagram::shares(std::span<const int> evidence, std::span<const LiteralWeight> weights) const {
    if (sample_) {
        std::vector<int> certain(evidence.begin(), evidence.end());
        for (const LiteralWeight& each : weights)
            if (each.weight == 0) certain.push_back(-each.literal);
        return sample_->shares(certain);
    }
    constexpr int most_plain = 1000;  // variables: then no count reaches 2^1000
    return weights.empty() && nodes_->variables <= most_plain ? shares_of<Plain>(*nodes_, evidence, {})
                                                              : shares_of<Scaled>(*nodes_, evidence, weights);
}

std::shared_ptr<const Shares> Diagram::remembered_shares(const std::vector<int>& evidence) const {
    std::shared_ptr<const Shares> found = memory_->find(evidence);
    if (!found) {
        found = std::make_shared<const Shares>(shares(evidence));
        memory_->insert(evidence, found);
    }
    return found;
}

std::vector<std::vector<int>> Diagram::models(std::size_t limit, std::span<const int> evidence) const {
    if (sample_) throw std::logic_error("Diagram: the models of a sampled one are not listed");
    return ModelWalk(*nodes_, limit, evidence).run();
}

}  // namespace partonomy::knowledge
