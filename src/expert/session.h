#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "algorithms/catalogue.h"
#include "algorithms/related_index.h"
#include "expert/annotation.h"
#include "expert/final_labelling.h"
#include "expert/in_numbers.h"
#include "knowledge/explain.h"
#include "knowledge/relations.h"

namespace partonomy {

/// One object under questioning: the regions cut so far, what was answered, and what follows from it. A strategy
/// decides what to ask; the session runs the algorithm, counts it, learns the answer, and writes the trace.
class Session {
public:
    /// All must outlive the session. `cut`: of the object; its own regions, or others.
    Session(const knowledge::Domain& domain, const Catalogue& catalogue, const Object& object, const Cut& cut);

    /// SF: cuts all regions out of the uncut rest that are what the question says, by the question's own algorithm or a
    /// derived one. Returns how many.
    int find_all(knowledge::Question question);

    /// SI: asks whether a region is what the question says, and learns the answer. nullopt when no algorithm can tell.
    /// A question about a relation runs T on the regions that matter, each once; nullopt, too, while the answer hangs
    /// on what other regions are.
    std::optional<bool> ask(int region, knowledge::Question question);

    /// SI without learning: the score, counted and traced. For strategies that compare scores before they believe one.
    std::optional<double> ask_score(int region, knowledge::Question question);

    /// Learns an answer that needs no algorithm (deduced), or one whose score is already known.
    void learn(int region, knowledge::Question question, bool yes, double score);

    /// Learns what a person says, which is surer than anything else: of the answers about the region those that
    /// contradict it are left out, the least certain first. So is every answer about a relation, of any region, that
    /// hung on what a region could be and now may be otherwise. Nothing else is given up; ask_on() asks what is open
    /// then.
    void correct(int region, knowledge::Question question, bool yes);

    /// Takes every candidate that no question has cut as a region, with what is known of the rest.
    void adopt_rest();

    /// TF: finds which regions touch, where the ontology has composite parts. A later call looks at regions that may
    /// belong to one only since.
    void find_connections();

    /// Whether the object has so few parts that what was measured is told in numbers.
    [[nodiscard]] bool is_told_in_numbers() const { return region_count() <= 200; }
    /// Adds to the trace what was measured: to each `is a` the numbers it rests on, to each answer about a relation
    /// those of at most two tuples of regions. Nothing where the object has very many parts.
    void tell_measures();
    /// What an answer rests on: of an `is a` the numbers that it measured, of a relation those of at most two tuples of
    /// regions, or that no other part is what it asks for. Empty where nothing can tell, or a person said so.
    [[nodiscard]] InNumbers in_numbers(const knowledge::Answer& answer);
    /// Configurations that an answer leaves of some.
    [[nodiscard]] knowledge::ConfigurationSet narrowed(knowledge::ConfigurationSet set,
                                                       const knowledge::Answer& answer) const;

    /// Whether the values of a variable are read off a region as soon as it is cut, so that no question is asked:
    /// numbers, and range concepts whose values all cost 0.
    [[nodiscard]] bool is_measured(int variable) const { return measured_[index(variable)] != 0; }

    [[nodiscard]] bool has_rest() const { return !rest_.empty(); }
    [[nodiscard]] const knowledge::ConfigurationSet& rest_possible() const { return rest_possible_; }
    [[nodiscard]] int region_count() const { return static_cast<int>(parts_.size()); }
    /// Whether a person said so.
    [[nodiscard]] bool is_accepted(const knowledge::Answer& answer) const {
        return accepted_.contains({answer.region, answer.question});
    }

    /// What a region can still be.
    [[nodiscard]] const knowledge::ConfigurationSet& possible(int region) const { return possible_[index(region)]; }
    [[nodiscard]] const PartRegion& part(int region) const { return parts_[index(region)]; }
    [[nodiscard]] const RegionMeasurements& measurements(int region) const { return measurements_[index(region)]; }
    /// Score of `is a` for the region's shape: of its own answer, or of the lowest answer that ruled the others out.
    [[nodiscard]] double shape_score(int region) const { return shape_scores_[index(region)]; }

    [[nodiscard]] knowledge::Knowledge knowledge() const;
    /// Score in [0.5, 1] of each answer in knowledge().answers.
    [[nodiscard]] const std::vector<double>& answer_scores() const { return answer_scores_; }

    /// Costs of the questions that can be answered on a cut region; for knowledge::PlanOptions.
    [[nodiscard]] std::optional<double> is_a_cost(knowledge::Question question) const;
    /// The same for `find all`, where it is worth asking now (Catalogue::cutting_cost).
    [[nodiscard]] std::optional<double> find_all_cost(knowledge::Question question) const;

    [[nodiscard]] bool has_own_find_all() const { return catalogue_.has_own_find_all; }

    /// Concepts of a region that an answer is wanted for: those that the expert defined.
    [[nodiscard]] const std::vector<knowledge::ConceptId>& wanted() const { return wanted_; }

    [[nodiscard]] const knowledge::Domain& domain() const { return domain_; }
    [[nodiscard]] const Catalogue& catalogue() const { return catalogue_; }
    [[nodiscard]] const Object& object() const { return object_; }
    /// Fraction of the surface that is in no candidate region.
    [[nodiscard]] double uncovered_fraction() const { return uncovered_fraction_; }

    std::vector<TraceEntry> trace;
    int find_all_count = 0, is_a_count = 0, related_count = 0, find_related_count = 0;
    int read_off_count = 0;  ///< numbers and cost-free ranges that were read off regions, one each, without a question

private:
    struct Candidate {
        PartRegion part;
        RegionMeasurements measurements;
        std::vector<knowledge::Answer> ruled_out;  ///< answers "no" of the `find all`s that it was not found by
        std::vector<double> scores;                ///< of those answers
    };
    static std::size_t index(int region) { return static_cast<std::size_t>(region); }
    int add_region(Candidate candidate);
    [[nodiscard]] Candidate make_candidate(PartRegion part) const;
    [[nodiscard]] std::vector<const PartRegion*> rest_parts() const;
    /// Takes the regions that a derived `find all` finds from the rest, with their scores.
    std::vector<std::pair<Candidate, double>> take_derived(const ElementaryAlgorithm& algorithm);
    std::optional<bool> ask_relation(int region, knowledge::Question question);
    /// T, counted and traced; what was asked before is not asked again.
    std::optional<double> relate(const knowledge::RelationTuple& tuple);
    /// TF where it costs less than the T's that the question would take one by one.
    void relate_many(int region, knowledge::Question question);
    /// TF, counted and traced: scores of all tuples that have some region in the place of the one -1.
    void find_related(const knowledge::RelationTuple& line);
    const Scene& scene();
    const RegionPlace& place(int region);
    struct ScoredAnswer {
        knowledge::Answer answer;
        double score;
    };
    void read_off(int region, int variable, std::vector<ScoredAnswer>& answers);
    /// As learn() one by one, of one region: where they contradict nothing, what is possible is found out once.
    void learn_together(const std::vector<ScoredAnswer>& answers);
    void note(const knowledge::Answer& answer, double score);
    /// "part 3: is it a board".
    [[nodiscard]] std::string in_words(int region, knowledge::Question question) const;
    /// Answers are likelihoods: of those of one region that contradict a new one the least certain is left out when it
    /// is borderline. False: that is the new one.
    bool make_room(const knowledge::Answer& answer, double score);
    /// What the answers that are there leave of a region.
    [[nodiscard]] knowledge::ConfigurationSet possible_by_answers(int region) const;
    [[nodiscard]] bool is_relation(const knowledge::Answer& answer) const;
    void leave_out(std::size_t answer, const char* why);
    [[nodiscard]] InNumbers relation_in_numbers(int region, knowledge::Question question);
    /// Gives up answers about relations that hung on what `region` could be (`before`); and what hung on those.
    void withdraw_relations(int region, knowledge::ConfigurationSet before);
    /// What is known of a region now and was not in `before`, in words; not the answer to `asked` itself.
    [[nodiscard]] std::vector<std::string> consequences(int region, const knowledge::ConfigurationSet& before,
                                                        knowledge::Question asked);

    const knowledge::Domain& domain_;
    const Catalogue& catalogue_;
    const Object& object_;
    double uncovered_fraction_ = 0;
    bool patches_are_whole_ = false;  ///< no border of the rest cuts a curved patch (keep_patches_whole)
    std::vector<knowledge::ConceptId> wanted_;
    std::vector<char> measured_;  ///< by variable of regions

    std::vector<Candidate> rest_;  ///< candidate regions that no question has cut out
    knowledge::ConfigurationSet rest_possible_;

    std::vector<PartRegion> parts_;  ///< the regions, in the order in which they were cut
    std::vector<RegionMeasurements> measurements_;
    std::vector<knowledge::ConfigurationSet> possible_;
    std::vector<double> shape_scores_;
    std::vector<knowledge::Answer> answers_;
    std::vector<double> answer_scores_;
    std::vector<std::string> left_out_;  ///< for the trace: doubtful answers that contradicted others
    std::set<std::pair<int, knowledge::Question>> accepted_;   ///< what a person said
    std::set<std::pair<int, knowledge::Question>> withdrawn_;  ///< answers about relations, since the last correction
    std::optional<std::vector<std::pair<int, int>>> connected_;
    std::vector<int> connectable_;  ///< regions of which is known which of them touch; ascending
    std::optional<Scene> scene_;
    std::map<int, RegionPlace> places_;         ///< of regions that relations were asked of; they point to parts_
    std::optional<RelatedIndex> index_;         ///< of all regions that were there when it was made
    int indexed_ = 0;                           ///< how many
    std::vector<RelationTest> relation_tests_;  ///< of domain_.relations
    std::map<knowledge::RelationTuple, std::optional<double>> related_;
    struct ToldRelation {
        std::size_t entry;  ///< place in the trace
        std::size_t facts;  ///< how many there were in `inferred`, the answer being the last; 0: it is the entry itself
        int region;
        knowledge::Question question;
        bool yes;
    };
    std::vector<ToldRelation> told_;
    struct AskedIsA {
        std::size_t entry;  ///< place in the trace
        int region;
        knowledge::Question question;
    };
    std::vector<AskedIsA> asked_;
};

/// How an object is questioned; the paper's Table 3 compares them.
enum class Strategy {
    expert,                 ///< the decision tree, walked online
    naive,                  ///< every `find all` of the shapes, then every other `is a` on every region
    segment_then_identify,  ///< regions from a segmentation, then every `is a` on every region
};

/// Names what hangs on relations: asks of each region, as long as some answer is had, what names are still open for. An
/// answer that hangs on the name of another region waits for it.
void name_by_relations(Session& session, knowledge::SplitCriterion criterion);

/// Asks about the regions that there are until everything wanted is known or nothing more can be answered.
void ask_on(Session& session, knowledge::SplitCriterion criterion);

/// Asks what parts are by which objects are told apart, also of an object that can be none of them: what it comes
/// nearest to is told then, and what it lacks.
void ask_what_objects_count(Session& session);

/// Cuts regions, then asks on.
void run_expert(Session& session, knowledge::SplitCriterion criterion);
void run_naive(Session& session);
void run_segment_then_identify(Session& session);

}  // namespace partonomy
