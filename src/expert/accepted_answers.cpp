#include "expert/accepted_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/errors.h"
#include "base/spelling.h"
#include "expert/annotate.h"

namespace partonomy {
namespace {

using knowledge::Answer;
using knowledge::ConfigurationSet;
using knowledge::Domain;
using knowledge::Question;
using knowledge::Variable;

std::string short_name(const Variable& variable) { return owl::local_name(feature_name(variable)); }

class Reader {
public:
    Reader(const Session& session, const std::string& source)
        : session_(session), variables_(session.domain().regions.variables), source_(source) {}

    [[nodiscard]] Answer read(const LearnedAnswer& told) const {
        if (told.part < 1 || told.part > session_.region_count())
            wrong(
                session_.region_count() == 0
                    ? fmt::format("there is no part {}: nothing was cut out of this mesh", told.part)
                    : fmt::format("there is no part {}: there are parts 1 to {}", told.part, session_.region_count()));
        return {told.part - 1, question(told), told.yes};
    }

    [[noreturn]] void wrong(const std::string& what) const { throw UsageError(at(source_, 0, what)); }

private:
    [[nodiscard]] Question question(const LearnedAnswer& told) const {
        std::vector<std::string> names;
        for (std::size_t v = 0; v < variables_.size(); ++v) {
            const Variable& variable = variables_[v];
            if (!variable.answerable) continue;
            names.push_back(short_name(variable));
            if (feature_name(variable) != told.feature && names.back() != told.feature) continue;
            const auto value = std::ranges::find(variable.values, told.value);
            if (value == variable.values.end())
                wrong(fmt::format("part {}: {} has no value \"{}\": there are {}{}", told.part, names.back(),
                                  told.value, fmt::join(variable.values, "; "),
                                  did_you_mean({told.value}, variable.values)));
            return {static_cast<int>(v), static_cast<int>(value - variable.values.begin())};
        }
        const std::string name = owl::local_name(told.feature);
        for (const knowledge::Concept& each : session_.domain().regions.concepts)
            if (owl::local_name(each.iri) == name)
                wrong(
                    fmt::format("part {}: {} is what follows from answers, and no question; say what makes it one: {}",
                                told.part, name, fmt::join(names, ", ")));
        wrong(fmt::format("part {}: \"{}\" is no feature that this ontology asks for{}", told.part, told.feature,
                          did_you_mean({name}, names)));
    }

    const Session& session_;
    const std::vector<Variable>& variables_;
    const std::string& source_;
};

}  // namespace

void accept_answers(Session& session, const std::vector<LearnedAnswer>& told, const std::string& source) {
    const Reader reader(session, source);
    const knowledge::Space& space = session.domain().regions;
    std::vector<Answer> answers;
    std::map<int, ConfigurationSet> possible;  // by region: what a person's answers leave of it
    for (const LearnedAnswer& each : told) {
        const Answer answer = reader.read(each);
        ConfigurationSet& left = possible.try_emplace(answer.region, space.all()).first->second;
        if (answer.yes)
            left &= yes_set(space, answer.question);
        else
            left -= yes_set(space, answer.question);
        if (left.is_empty())
            reader.wrong(
                fmt::format("part {}: {} \"{}\": {} cannot hold together with what the file says of that part "
                            "before, and the ontology",
                            each.part, owl::local_name(each.feature), each.value, each.yes ? "yes" : "no"));
        answers.push_back(answer);
    }
    for (const Answer& answer : answers) session.correct(answer.region, answer.question, answer.yes);
}

}  // namespace partonomy
