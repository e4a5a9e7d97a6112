/* What an unrecognised object comes nearest to, and what it lacks.

   The definition of a concept of objects is a formula over "at least k parts are C". Each such atom is compared with
   the parts that are C for sure, and with those that may be: a part that is needed and there counts as right, one that
   is needed and not there as lacking, one beyond what is allowed as too many. A conjunction adds up, of a disjunction
   the best branch counts, negation swaps the two. The likeness of a concept is the share of right ones; a part that may
   be what is needed counts half, and one too many counts twice: a part that is missing may only not have been found,
   but one that is there and that the concept does not allow speaks for another. Cost: one walk over each definition. */

#include "knowledge/near_miss.h"

#include <algorithm>
#include <map>

#include "knowledge/assembly.h"

namespace partonomy::knowledge {
namespace {

constexpr int deepest = 64;               // names within names
constexpr double foreign = 2;             // parts that a part too many counts for
constexpr std::size_t most_doubtful = 3;  // parts that are listed for what they may be

/// How many parts are C, and which may be besides.
struct Members {
    unsigned certain = 0;
    std::vector<std::string> doubtful;  ///< "part 3", "parts 1, 2"
};

/// How well a formula is met. What is wanted of one class of parts in several places (`exactly 2` is `min 2` and not
/// `min 3`) is told once.
struct Match {
    double right = 0, wrong = 0;
    bool can_be = true;  ///< false where nothing could make it hold
    std::map<std::string, unsigned> lacks, too_many;
    std::map<std::string, std::vector<std::string>> doubtful;

    [[nodiscard]] double likeness() const { return right + wrong > 0 ? right / (right + wrong) : 1; }
    void add(const Match& other) {
        right += other.right;
        wrong += other.wrong;
        can_be = can_be && other.can_be;
        for (const auto& [name, count] : other.lacks) lacks[name] = std::max(lacks[name], count);
        for (const auto& [name, count] : other.too_many) too_many[name] = std::max(too_many[name], count);
        doubtful.insert(other.doubtful.begin(), other.doubtful.end());
    }
    [[nodiscard]] bool is_better_than(const Match& other) const {
        return std::tuple(can_be, likeness(), -wrong) > std::tuple(other.can_be, other.likeness(), -other.wrong);
    }
};

class Matcher {
public:
    Matcher(const Domain& domain, const Conclusions& known)
        : theory_(domain.grounding->theory), parts_(domain.grounding->assembly.parts), known_(known) {}

    [[nodiscard]] Match match(FormulaId id, bool is_wanted, int depth = 0) const {
        const Formula& formula = theory_.formulas[static_cast<std::size_t>(id)];
        Match result;
        switch (formula.kind) {
            case Formula::Kind::truth:
            case Formula::Kind::falsity:
                result.can_be = (formula.kind == Formula::Kind::truth) == is_wanted;
                return result;
            case Formula::Kind::negation:
                return match(formula.operands[0], !is_wanted, depth);
            case Formula::Kind::conjunction:
            case Formula::Kind::disjunction: {
                const bool are_all_needed = (formula.kind == Formula::Kind::conjunction) == is_wanted;
                for (std::size_t i = 0; i < formula.operands.size(); ++i) {
                    const Match each = match(formula.operands[i], is_wanted, depth);
                    if (are_all_needed)
                        result.add(each);
                    else if (i == 0 || each.is_better_than(result))
                        result = each;
                }
                return result;
            }
            case Formula::Kind::named: {
                const NamedConcept& named = theory_.concepts[static_cast<std::size_t>(formula.index)];
                result.can_be = !is_wanted;
                if (named.definition < 0 || depth == deepest) return result;
                const std::pair key(formula.index, is_wanted);
                if (const auto known = of_names_.find(key); known != of_names_.end()) return known->second;
                return of_names_[key] = match(named.definition, is_wanted, depth + 1);
            }
            case Formula::Kind::parts:
                return match_parts(id, is_wanted);
            default:
                return result;
        }
    }

private:
    [[nodiscard]] Match match_parts(FormulaId id, bool is_wanted) const {
        const Formula& formula = theory_.formulas[static_cast<std::size_t>(id)];
        Match result;
        const int atom = parts_.atom_of[static_cast<std::size_t>(id)];
        if (atom < 0) {
            result.can_be = !is_wanted;
            return result;
        }
        const Members members = members_of(parts_.classes[parts_.atoms[static_cast<std::size_t>(atom)].part]);
        const bool is_name = formula.part_class->kind == owl::ClassKind::named;
        const std::string written = to_manchester(*formula.part_class);
        const std::string name = is_name ? written : "(" + written + ")";
        const auto possible = members.certain + static_cast<unsigned>(members.doubtful.size());
        if (is_wanted) {
            const unsigned there = std::min(members.certain, formula.threshold), missing = formula.threshold - there;
            const unsigned open = std::min(missing, possible - members.certain);
            result.right = there + 0.5 * open;
            result.wrong = missing - 0.5 * open;
            if (missing > 0) result.lacks[name] = missing;
            if (open > 0) result.doubtful[name] = members.doubtful;
        } else if (possible >= formula.threshold) {
            const bool is_certain = members.certain >= formula.threshold;
            result.wrong = foreign * (is_certain ? members.certain - formula.threshold + 1 : 0.5);
            result.too_many[name] = is_certain ? members.certain - formula.threshold + 1 : 1;
            if (!is_certain) result.doubtful[name] = members.doubtful;
        }
        return result;
    }

    [[nodiscard]] Members members_of(const Parts::PartClass& part) const {
        Members members;
        const auto count = [&](const ConfigurationSet& possible, const ConfigurationSet& where, std::string who) {
            if (possible.is_empty() || !possible.intersects(where)) return;
            if (possible.is_subset_of(where))
                ++members.certain;
            else
                members.doubtful.push_back(std::move(who));
        };
        if (!part.where.is_empty())
            for (std::size_t r = 0; r < known_.regions.size(); ++r)
                count(known_.regions[r], part.where, "part " + std::to_string(r + 1));
        for (const CompositePart& composite : known_.composites) {
            const auto group = static_cast<std::size_t>(composite.group);
            if (group >= part.composites.size() || part.composites[group].is_empty()) continue;
            std::string who;
            for (const int region : composite.regions)
                who += (who.empty() ? composite.regions.size() > 1 ? "parts " : "part " : ", ") +
                       std::to_string(region + 1);
            count(composite.possible, part.composites[group], std::move(who));
        }
        return members;
    }

    const Theory& theory_;
    const Parts& parts_;
    const Conclusions& known_;
    mutable std::map<std::pair<int, bool>, Match> of_names_;  ///< walked once, however many definitions use a name
};

/// "2 Leg (part 3 may be one)"
std::vector<std::string> in_words(const std::map<std::string, unsigned>& counts, const Match& match) {
    std::vector<std::string> texts;
    for (const auto& [name, count] : counts) {
        std::string text = std::to_string(count) + " " + name;
        if (const auto found = match.doubtful.find(name); found != match.doubtful.end()) {
            std::string who;
            for (std::size_t i = 0; i < std::min(found->second.size(), most_doubtful); ++i)
                who += (i > 0 ? " or " : "") + found->second[i];
            text += " (" + who + (found->second.size() > most_doubtful ? " or another" : "") + " may be one)";
        }
        texts.push_back(std::move(text));
    }
    return texts;
}

}  // namespace

std::vector<NearMiss> near_misses(const Domain& domain, const Conclusions& known, const std::vector<Iri>& left_out) {
    std::vector<NearMiss> found;
    if (!domain.grounding) return found;
    const Matcher matcher(domain, known);
    for (const NamedConcept& named : domain.grounding->theory.concepts) {
        if (named.level != Level::object || named.incompatible || named.open || named.definition < 0 ||
            named.iri.starts_with(owl::core_prefix) || std::ranges::find(left_out, named.iri) != left_out.end())
            continue;
        const Match match = matcher.match(named.definition, true);
        if (!match.can_be || !(match.right > 0)) continue;
        found.push_back({named.iri, in_words(match.lacks, match), in_words(match.too_many, match), match.likeness()});
    }
    std::ranges::stable_sort(found, std::greater<>(), &NearMiss::likeness);
    // Of those that come nearest the most specific first: what is above them lacks the same.
    const auto end =
        std::ranges::find_if(found, [&](const NearMiss& miss) { return miss.likeness < found.front().likeness; });
    std::vector<Iri> alike;
    for (auto miss = found.begin(); miss != end; ++miss) alike.push_back(miss->iri);
    const std::vector<Iri> specific = domain.most_specific(alike);
    std::stable_partition(found.begin(), end, [&](const NearMiss& miss) {
        return std::ranges::find(specific, miss.iri) != specific.end();
    });
    return found;
}

}  // namespace partonomy::knowledge
