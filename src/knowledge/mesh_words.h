#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "knowledge/domain.h"
#include "knowledge/ground.h"

// Inside of mesh_world.cpp: how axioms speak of a mesh's world.

namespace partonomy::knowledge {

/// "isTargetRegion some …" as the class of those of which it was answered yes: local name "relation1" ….
[[nodiscard]] Iri relation_class(std::size_t index);
/// The object and its parts, where the ontology names other things, too.
[[nodiscard]] Iri mesh_class();
/// The composite parts of one kind of group (groups.h).
[[nodiscard]] Iri group_class(int group);

/// Whether it is a restriction on a data property.
[[nodiscard]] inline bool is_data(owl::ClassKind kind) { return kind >= owl::ClassKind::data_some_values_from; }

/// Class expressions and axioms of a domain in the words of a mesh's world.
class MeshWords {
public:
    /// `plain`: the domain's ontology in fewer words (plain.h). The domain must outlive this.
    MeshWords(const Domain& domain, const owl::Ontology& plain);

    [[nodiscard]] owl::ClassPointer operator()(const owl::ClassPointer& expression) const;
    [[nodiscard]] owl::Axiom operator()(owl::Axiom axiom) const;
    [[nodiscard]] Level level_of_axiom(const owl::Axiom& axiom) const;

private:
    [[nodiscard]] int group_of(const owl::Axiom& axiom) const;
    void look_at_one_layer(owl::ClassExpression& result, const owl::ClassPointer& as_written) const;
    [[nodiscard]] owl::ClassPointer within(Level level, int group, const owl::ClassPointer& expression) const;
    [[nodiscard]] std::optional<owl::ClassPointer> as_relation(const owl::ClassExpression& expression) const;

    const Theory& theory_;
    const std::vector<RangeConcept>& ranges_;
    std::map<Iri, Level> levels_;
    bool has_strangers_ = false;
    std::set<Iri> numbers_;
    std::map<std::string, std::size_t> relational_;
};

}  // namespace partonomy::knowledge
