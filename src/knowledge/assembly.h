#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "knowledge/explain.h"
#include "knowledge/theory.h"

// Inside of the knowledge folder: how regions make composite parts, and both make an object.

namespace partonomy::knowledge {

/// What composite parts of one group count, and what they can be.
struct CompositeLayer {
    bool is_used = false;  ///< some concept in scope speaks of them; otherwise nothing else is filled
    Parts parts;
    ObjectLayer objects;                       ///< "object" being the composite part
    ConfigurationSet regions;                  ///< configurations of a region that belongs to such a group
    std::vector<ConfigurationSet> composites;  ///< by group: configurations of a composite part that belongs to it
    ConfigurationSet possible;                 ///< in which no incompatible concept holds
    /// No other owning group has a claim to its regions, so each of them is in exactly one group that owns, or in none.
    bool owns = true;
};

/// Everything between regions and object.
struct Assembly {
    std::vector<CompositeLayer> composites;  ///< by Theory::groups
    Parts parts;                             ///< what the object counts
    [[nodiscard]] bool has_composites() const;
};

/// Throws OntologyError when parts combine in more than `limit` ways.
[[nodiscard]] Assembly assemble(const Theory& theory, const Scope& scope, const Layer& regions, std::size_t limit);

/// What an object of any number of parts may count: parts are regions in `among`, and composite parts of them;
/// ascending. Only composite parts that are possible when `only_possible`. Throws OntologyError beyond `limit`. Where
/// groups have a claim to the same regions, more than can be: then a group that does not own its regions may turn up
/// anywhere.
[[nodiscard]] std::vector<Counts> possible_counts(const Theory& theory, const Assembly& assembly,
                                                  const ConfigurationSet& among, bool only_possible, std::size_t limit);

/// What is found when parts are put together.
struct Assembled {
    std::vector<Counts> counts;             ///< that the object may have; ascending
    std::vector<CompositePart> composites;  ///< that there are in any case; by group, then by regions
    bool is_certain = true;                 ///< there are no others in any case
};

/// What each kind of region, and each kind of composite part, counts for everything around it (put_together.cpp).
struct Contributions;
[[nodiscard]] std::shared_ptr<const Contributions> find_contributions(const Assembly& assembly,
                                                                      const ConfigurationSet& all);

/// Puts the regions of an object together: each known to lie in its set (empty: nothing is known), those of each pair
/// in `connected` touching. nullopt when there are too many ways to try them all.
[[nodiscard]] std::optional<Assembled> put_together(const Theory& theory, const Assembly& assembly,
                                                    const Contributions& contributions,
                                                    const std::vector<ConfigurationSet>& regions,
                                                    const std::vector<std::pair<int, int>>& connected);

/// What follows without the closed world of the mesh (mesh_world.h), which conclude() looks at, too.
[[nodiscard]] Conclusions conclude_by_spaces(const Domain& domain, const Knowledge& knowledge);

/// The composite parts of a mesh when there is no doubt which there are; nullopt otherwise.
[[nodiscard]] std::optional<std::vector<CompositePart>> certain_composites(const Domain& domain,
                                                                           const Knowledge& knowledge);

/// Those of `all_counts` that agree with `some` on regions, or have more of them with `or_more`; ascending. What is
/// left when composite parts are not known.
[[nodiscard]] std::vector<Counts> with_any_composites(const Parts& parts, const std::vector<Counts>& all_counts,
                                                      const std::vector<Counts>& some, bool or_more);

struct Grounding {
    CompileOptions options;
    Theory theory;
    Scope scope;  ///< everything
    std::string file;
    Assembly assembly;
    ConfigurationSet regions;           ///< every configuration of a region
    ConfigurationSet possible_regions;  ///< in which no incompatible concept holds

    /// Every configuration of an object.
    struct Listing {
        ObjectLayer layer;
        Space space;
    };
    /// Made when first asked for. Throws OntologyError when there are too many configurations.
    [[nodiscard]] const Listing& objects() const;
    /// Made when first asked for.
    [[nodiscard]] const Contributions& contributions() const;

private:
    mutable std::once_flag once_, contributions_once_;
    mutable Listing listing_;
    mutable std::shared_ptr<const Contributions> contributions_;
};

/// What belongs together: a set of configurations that none of some sets tells apart, and which of them it is in.
struct Cell {
    std::vector<char> in;
    ConfigurationSet where;  ///< not empty
};
[[nodiscard]] std::vector<Cell> split(const ConfigurationSet& all, const std::vector<const ConfigurationSet*>& sets);

}  // namespace partonomy::knowledge
