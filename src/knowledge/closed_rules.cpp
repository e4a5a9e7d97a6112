/* DL-safe rules (SWRL).

   Variables range over the individuals of the world, or over the chosen values of a data property; a variable that a
   built-in compares ranges over the literals that the ontology mentions, since only of those it is known how they
   compare. Writing a rule out for all assignments costs n to the number of variables, so variables that the head does
   not have are eliminated first (bucket elimination: Dechter 1999): the atoms with y in them become one table over
   their other variables, "there is a y with …", whose entries are gates. A rule that is a chain or a tree then costs n²
   or n³ however long it is; one with a clique of k variables costs n to the k. */

#include <algorithm>

#include "knowledge/closed_grounder.h"
#include "owl/words.h"

namespace partonomy::knowledge::closed {

using owl::RuleAtom;
using owl::RuleTerm;

namespace {

/// A variable of a rule with what it ranges over: individuals, or values of the group of `data_property`.
struct Variable {
    Iri name;
    int data_property = -1;
    bool is_data = false, is_compared = false;
    std::vector<std::size_t> domain = {};
};

/// A literal for each assignment of some variables; the last one varies fastest.
struct Table {
    std::vector<int> scope;  ///< variables, ascending
    std::vector<int> literals;
};

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
    return std::ranges::any_of(names, [&](const char* each) { return name == each; });
}

/// The local name of a built-in that compares two things; throws CannotGround for every other.
std::string comparison(const RuleAtom& atom) {
    const std::string name = owl::local_name(atom.iri);
    const bool is_known =
        atom.iri.starts_with(owl::swrlb_prefix) &&
        is_one_of(name, {"equal", "notEqual", "lessThan", "lessThanOrEqual", "greaterThan", "greaterThanOrEqual"});
    if (!is_known) {
        throw CannotGround{"the built-in " + name +
                           " computes values that are not among the known ones; compare with "
                           "swrlb:equal, notEqual, lessThan, lessThanOrEqual, greaterThan, greaterThanOrEqual, or give "
                           "the computed value a data property"};
    }
    if (atom.arguments.size() != 2)
        throw CannotGround{"the built-in " + name + " compares two things, no more and no less"};
    return name;
}

bool compares(const std::string& name, const DataValue& a, const DataValue& b) {
    const std::partial_ordering order = compare_numbers(a, b);
    const bool is_equal = order == std::partial_ordering::equivalent || key_of(a) == key_of(b);
    if (name == "equal") return is_equal;
    if (name == "notEqual") return !is_equal;
    if (name == "lessThan") return order < 0;
    if (name == "greaterThan") return order > 0;
    return name == "lessThanOrEqual" ? order <= 0 : order >= 0;
}

}  // namespace

/// One rule being grounded.
class RuleGrounder {
public:
    RuleGrounder(Grounder& grounder, const owl::Rule& rule) : grounder_(grounder), rule_(rule) {
        for (const auto* side : {&rule.body, &rule.head})
            for (const RuleAtom& atom : *side) declare(atom, side == &rule.body);
        for (Variable& variable : variables_) give_domain(variable);
    }

    void ground() {
        std::vector<Table> body;
        for (const RuleAtom& atom : rule_.body) body.push_back(table_of(atom));
        if (rule_.head.empty()) require(body, {{}, {-grounder_.always_}});
        for (const RuleAtom& atom : rule_.head) require(body, table_of(atom));
    }

private:
    int variable(const RuleTerm& term) {
        const auto found = std::ranges::find(variables_, term.iri, &Variable::name);
        if (found != variables_.end()) return static_cast<int>(found - variables_.begin());
        variables_.push_back({term.iri});
        return static_cast<int>(variables_.size()) - 1;
    }

    void declare(const RuleAtom& atom, bool is_body) {
        if (atom.kind == RuleAtom::Kind::built_in) (void)comparison(atom);  // throws for what is none
        for (std::size_t i = 0; i < atom.arguments.size(); ++i) {
            const RuleTerm& term = atom.arguments[i];
            const bool is_data = atom.kind == RuleAtom::Kind::of_data_range || atom.kind == RuleAtom::Kind::built_in ||
                                 (atom.kind == RuleAtom::Kind::data_property && i == 1);
            if (is_data == (term.kind == RuleTerm::Kind::individual) ||
                (!is_data && term.kind == RuleTerm::Kind::literal))
                if (term.kind != RuleTerm::Kind::variable)
                    throw CannotGround{is_data ? "an individual stands where a literal is meant"
                                               : "a literal stands where an individual is meant"};
            if (term.kind != RuleTerm::Kind::variable) continue;
            const auto id = static_cast<std::size_t>(variable(term));
            Variable& it = variables_[id];
            if (uses_.size() <= id) uses_.resize(id + 1, is_data);
            if (uses_[id] != is_data) {
                throw CannotGround{"the variable " + owl::short_name(term.iri) +
                                   " stands for an individual and for a literal; use two variables"};
            }
            it.is_data = is_data;
            it.is_compared = it.is_compared || atom.kind == RuleAtom::Kind::built_in;
            if (is_data && is_body && atom.kind == RuleAtom::Kind::data_property)
                it.data_property = std::max(it.data_property, grounder_.data_property_of(atom.property));
        }
    }

    void give_domain(Variable& variable) {
        if (!variable.is_data) {
            for (int i = 0; i < grounder_.count_; ++i) variable.domain.push_back(static_cast<std::size_t>(i));
            return;
        }
        if (variable.data_property < 0) {
            throw CannotGround{"the variable " + owl::short_name(variable.name) +
                               " stands for a literal, but no data property in the body has it as its value; add one"};
        }
        const DataGroup& group = grounder_.group_of(variable.data_property);
        for (std::size_t value = 0; value < group.values.size(); ++value)
            if (!variable.is_compared || group.cells.cells()[group.values[value]].value)
                variable.domain.push_back(value);
    }

    /// Calls `step` with every assignment of the variables in `scope`, in the order of a table's literals.
    template <class Step>
    void for_each_assignment(const std::vector<int>& scope, Step step) {
        double count = 1;
        for (const int id : scope) count *= static_cast<double>(variables_[static_cast<std::size_t>(id)].domain.size());
        grounder_.expect_clauses(count);
        if (count == 0) return;
        std::vector<std::size_t> at(variables_.size(), 0);
        while (true) {
            step(at);
            std::size_t i = scope.size();
            while (i > 0) {
                const auto id = static_cast<std::size_t>(scope[i - 1]);
                if (++at[id] < variables_[id].domain.size()) break;
                at[id] = 0;
                --i;
            }
            if (i == 0) return;
        }
    }

    [[nodiscard]] int literal_in(const Table& table, const std::vector<std::size_t>& at) const {
        std::size_t index = 0;
        for (const int id : table.scope) {
            const auto variable = static_cast<std::size_t>(id);
            index = index * variables_[variable].domain.size() + at[variable];
        }
        return table.literals[index];
    }

    Table table_of(const RuleAtom& atom) {
        Table table;
        for (const RuleTerm& term : atom.arguments)
            if (term.kind == RuleTerm::Kind::variable) table.scope.push_back(variable(term));
        std::ranges::sort(table.scope);
        table.scope.erase(std::ranges::unique(table.scope).begin(), table.scope.end());
        for_each_assignment(
            table.scope, [&](const std::vector<std::size_t>& at) { table.literals.push_back(literal_of(atom, at)); });
        return table;
    }

    int constant(bool truth) const { return truth ? grounder_.always_ : -grounder_.always_; }

    std::size_t assigned(const RuleTerm& term, const std::vector<std::size_t>& at) {
        const auto id = static_cast<std::size_t>(variable(term));
        return variables_[id].domain[at[id]];
    }

    int individual(const RuleTerm& term, const std::vector<std::size_t>& at) {
        return term.kind == RuleTerm::Kind::variable ? static_cast<int>(assigned(term, at))
                                                     : grounder_.individuals.ids.at(term.iri);
    }

    const DataCells::Cell& cell(const RuleTerm& term, const std::vector<std::size_t>& at) {
        const DataGroup& group = grounder_.group_of(variables_[static_cast<std::size_t>(variable(term))].data_property);
        return group.cells.cells()[group.values[assigned(term, at)]];
    }

    DataValue known_value(const RuleTerm& term, const std::vector<std::size_t>& at) {
        return term.kind == RuleTerm::Kind::literal ? value_of(term.literal) : cell(term, at).value.value();
    }

    int literal_of(const RuleAtom& atom, const std::vector<std::size_t>& at) {
        const auto& arguments = atom.arguments;
        switch (atom.kind) {
            case RuleAtom::Kind::of_class:
                return grounder_.holds(grounder_.intern(*atom.klass), individual(arguments.at(0), at));
            case RuleAtom::Kind::object_property:
                return grounder_.property_atom(grounder_.property_of(atom.property), individual(arguments.at(0), at),
                                               individual(arguments.at(1), at));
            case RuleAtom::Kind::data_property: {
                const int property = grounder_.data_property_of(atom.property);
                const int subject = individual(arguments.at(0), at);
                if (arguments.at(1).kind == RuleTerm::Kind::literal)
                    return grounder_.value_atom(property, subject, arguments[1].literal).value();
                return grounder_.data_atom(property, subject, assigned(arguments[1], at));
            }
            case RuleAtom::Kind::of_data_range: {
                const RuleTerm& term = arguments.at(0);
                if (term.kind == RuleTerm::Kind::literal)
                    return constant(grounder_.has_literal(atom.range, term.literal));
                const int property = variables_[static_cast<std::size_t>(variable(term))].data_property;
                const auto& inside = grounder_.values_in(property, grounder_.range_id(atom.range));
                return constant(std::ranges::binary_search(inside, assigned(term, at)));
            }
            case RuleAtom::Kind::same_as:
                return grounder_.equality(individual(arguments.at(0), at), individual(arguments.at(1), at));
            case RuleAtom::Kind::different_from:
                return -grounder_.equality(individual(arguments.at(0), at), individual(arguments.at(1), at));
            case RuleAtom::Kind::built_in:
                break;
        }
        return constant(compares(comparison(atom), known_value(arguments.at(0), at), known_value(arguments.at(1), at)));
    }

    /// The variables of all tables that have `id`, without it.
    static std::vector<int> neighbours(const std::vector<Table>& tables, int id) {
        std::vector<int> scope;
        for (const Table& table : tables)
            if (std::ranges::binary_search(table.scope, id))
                scope.insert(scope.end(), table.scope.begin(), table.scope.end());
        std::ranges::sort(scope);
        scope.erase(std::ranges::unique(scope).begin(), scope.end());
        std::erase(scope, id);
        return scope;
    }

    void eliminate(std::vector<Table>& tables, int id) {
        Table joined;
        joined.scope = neighbours(tables, id);
        std::vector<Table> used, others;
        for (Table& table : tables)
            (std::ranges::binary_search(table.scope, id) ? used : others).push_back(std::move(table));
        const auto eliminated = static_cast<std::size_t>(id);
        for_each_assignment(joined.scope, [&](std::vector<std::size_t> at) {
            std::vector<int> choices;
            for (std::size_t value = 0; value < variables_[eliminated].domain.size(); ++value) {
                at[eliminated] = value;
                std::vector<int> conditions;
                for (const Table& table : used) conditions.push_back(literal_in(table, at));
                choices.push_back(grounder_.clauses.all_of(conditions));
            }
            joined.literals.push_back(grounder_.clauses.any_of(choices));
            grounder_.expect_clauses(0);
        });
        others.push_back(std::move(joined));
        tables = std::move(others);
    }

    void require(std::vector<Table> body, const Table& head) {
        std::vector<int> open;
        for (int id = 0; id < static_cast<int>(variables_.size()); ++id)
            if (!std::ranges::binary_search(head.scope, id)) open.push_back(id);
        while (!open.empty()) {
            const auto cost = [&](int id) { return neighbours(body, id).size(); };
            const auto next = std::ranges::min_element(open, {}, cost);
            eliminate(body, *next);
            open.erase(next);
        }
        for_each_assignment(head.scope, [&](const std::vector<std::size_t>& at) {
            std::vector<int> clause{literal_in(head, at)};
            for (const Table& table : body) clause.push_back(-literal_in(table, at));
            grounder_.require(clause);
        });
    }

    Grounder& grounder_;
    const owl::Rule& rule_;
    std::vector<Variable> variables_;
    std::vector<bool> uses_;  ///< by variable: for data
};

void Grounder::ground_rule(const owl::Rule& rule) { RuleGrounder(*this, rule).ground(); }

}  // namespace partonomy::knowledge::closed
