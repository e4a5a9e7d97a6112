/* Choosing a question over a diagram.

   What a question q tells about the labels L is their mutual information, H(L) - H(L|q) = H(q) - H(q|L). The right-hand
   side needs one sweep for each combination of labels, and no more: a sweep under a combination gives the shares of all
   questions at once. Combinations are found by splitting on the first label that is open, so only possible ones are
   visited. Where there are too many, labels are taken one by one: the sum over labels of I(label; q), with one sweep
   per label. Dichotomy needs a single sweep. Likelihoods change the weights in these sweeps and nothing else. */

#include "knowledge/diagram_questions.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "knowledge/sampled_models.h"

namespace partonomy::knowledge {
namespace {

double entropy(double p) { return p <= 0 || p >= 1 ? 0 : -p * std::log2(p) - (1 - p) * std::log2(1 - p); }

class Chooser {
public:
    Chooser(const Diagram& diagram, std::span<const LiteralQuestion> questions, const ChoiceOptions& options,
            std::span<const int> evidence, std::span<const LiteralWeight> weights)
        : diagram_(diagram),
          questions_(questions),
          options_(options),
          evidence_(evidence.begin(), evidence.end()),
          weights_(weights),
          all_(diagram.shares(evidence, weights)) {}

    std::optional<std::size_t> run() {
        for (const LiteralQuestion& question : questions_)
            if (!(question.cost > 0))
                throw std::invalid_argument("best_question: the cost of a question should be above 0");
        if (!options_.wanted.empty() && are_known(all_, options_)) return std::nullopt;
        std::vector<double> scores(questions_.size(), 0);
        if (options_.criterion != SplitCriterion::dichotomy && !options_.wanted.empty()) {
            gain_ = open_entropies();
            if (diagram_.sample() != nullptr) {
                by_sample(diagram_.sample()->sample(evidence_));
            } else {
                visits_ = std::max<std::size_t>(8, options_.work_limit / (diagram_.literal_count() + 1));
                if (!split(all_, 1)) one_by_one();
            }
            for (std::size_t q = 0; q < questions_.size(); ++q)
                if (gain_[q] > 1e-9) scores[q] = gain_[q] / price(q);
            if (const auto best = highest(scores); best || options_.must_tell) return best;
        }
        for (std::size_t q = 0; q < questions_.size(); ++q) scores[q] = smaller_side(q) / price(q);
        return highest(scores);
    }

private:
    [[nodiscard]] double price(std::size_t q) const {
        return options_.criterion == SplitCriterion::gain_per_cost ? questions_[q].cost : 1;
    }
    [[nodiscard]] double smaller_side(std::size_t q) const {
        return std::min(all_.of(questions_[q].literal), all_.of(-questions_[q].literal));
    }
    [[nodiscard]] std::vector<double> open_entropies() const {
        std::vector<double> result;
        for (const LiteralQuestion& question : questions_) result.push_back(entropy(all_.of(question.literal)));
        return result;
    }

    /// Takes H(q | labels) off the gains; false when there are too many combinations of labels.
    bool split(const Shares& shares, double share) {
        const auto open = std::ranges::find_if(
            options_.wanted, [&](int label) { return shares.is_possible(label) && shares.is_possible(-label); });
        if (open == options_.wanted.end()) {
            for (std::size_t q = 0; q < questions_.size(); ++q)
                gain_[q] -= share * entropy(shares.of(questions_[q].literal));
            return true;
        }
        for (const int label : {*open, -*open}) {
            if (visits_-- == 0) return false;
            evidence_.push_back(label);
            const bool fine = split(diagram_.shares(evidence_, weights_), share * shares.of(label));
            evidence_.pop_back();
            if (!fine) return false;
        }
        return true;
    }

    /// The gains as sums over single labels.
    void one_by_one() {
        gain_.assign(questions_.size(), 0);
        for (const int label : options_.wanted) {
            const double yes = all_.of(label), no = all_.of(-label);
            if (yes == 0 || no == 0) continue;
            evidence_.push_back(label);
            const Shares with = diagram_.shares(evidence_, weights_);
            evidence_.pop_back();
            for (std::size_t q = 0; q < questions_.size(); ++q) {
                const double in_all = all_.of(questions_[q].literal), in_yes = with.of(questions_[q].literal);
                const double in_no = std::clamp((in_all - yes * in_yes) / no, 0.0, 1.0);
                gain_[q] += entropy(in_all) - yes * entropy(in_yes) - no * entropy(in_no);
            }
        }
    }

    /// The same from a sample: for questions that are open, how much each label would tell about them.
    void by_sample(const ModelSample& sample) {
        const auto n = static_cast<double>(sample.size);
        for (std::size_t q = 0; q < questions_.size(); ++q) {
            const int question = questions_[q].literal;
            gain_[q] = 0;
            if (!all_.is_possible(question) || !all_.is_possible(-question) || sample.size == 0) continue;
            const double share = static_cast<double>(sample.count(question)) / n;
            for (const int label : options_.wanted) {
                if (!all_.is_possible(label) || !all_.is_possible(-label)) continue;
                const auto yes = static_cast<double>(sample.count(label)), no = n - yes;
                if (yes == 0 || no == 0) continue;
                const auto both = static_cast<double>(sample.count(question, label));
                const double in_no = std::clamp((share * n - both) / no, 0.0, 1.0);
                gain_[q] += entropy(share) - yes / n * entropy(both / yes) - no / n * entropy(in_no);
            }
        }
    }

    /// The first of the highest; scores closer than rounding count as equal.
    static std::optional<std::size_t> highest(const std::vector<double>& scores) {
        std::optional<std::size_t> best;
        for (std::size_t q = 0; q < scores.size(); ++q)
            if (scores[q] > (best ? scores[*best] * (1 + 1e-9) : 0)) best = q;
        return best;
    }

    const Diagram& diagram_;
    std::span<const LiteralQuestion> questions_;
    const ChoiceOptions& options_;
    std::vector<int> evidence_;
    std::span<const LiteralWeight> weights_;
    Shares all_;
    std::vector<double> gain_;
    std::size_t visits_ = 0;
};

}  // namespace

bool are_known(const Shares& shares, const ChoiceOptions& options) {
    return std::ranges::all_of(options.wanted, [&](int label) {
        const double share = std::max(shares.of(label), shares.of(-label));
        const bool is_inferred = !shares.is_possible(label) || !shares.is_possible(-label);
        return is_inferred || (options.certainty < 1 && share >= options.certainty);
    });
}

std::optional<std::size_t> best_question(const Diagram& diagram, std::span<const LiteralQuestion> questions,
                                         const ChoiceOptions& options, std::span<const int> evidence,
                                         std::span<const LiteralWeight> weights) {
    return Chooser(diagram, questions, options, evidence, weights).run();
}

std::array<LiteralWeight, 2> likelihood(int literal, double score) {
    if (!(score >= 0 && score <= 1)) throw std::invalid_argument("likelihood: a score lies between 0 and 1");
    return {LiteralWeight{literal, score}, LiteralWeight{-literal, 1 - score}};
}

}  // namespace partonomy::knowledge
