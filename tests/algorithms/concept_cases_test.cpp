/* Every elementary concept of core.ttl on shapes of which the truth is known by construction: shapes that it is, that
 * it is not, and that are on its border; as they are, turned about up, moved and scaled, and with noise of 0.5 % of the
 * diagonal. A concept or relation that the catalogue lists and that has no such three cases fails here. */

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "algorithms/catalogue.h"
#include "algorithms/concept_shapes.h"
#include "algorithms/relation_cases.h"
#include "knowledge/theory.h"
#include "shape/part_box.h"
#include "shape/solids.h"

namespace partonomy {
namespace {

struct Core {
    knowledge::Domain domain = make_core_domain();
    Catalogue catalogue = make_catalogue(domain);
    std::map<std::string, knowledge::Question> questions;  ///< by concept
    Core() {
        for (const ElementaryAlgorithm& algorithm : catalogue.algorithms)
            if (algorithm.signature == Signature::is_a) questions.emplace(algorithm.name, algorithm.question);
    }
    static const Core& get() {
        static const Core core;
        return core;
    }
    /// All values of the concept's range.
    [[nodiscard]] const std::vector<std::string>& range_of(const std::string& value) const {
        return domain.regions.variables[static_cast<std::size_t>(questions.at(value).variable)].values;
    }
};

std::vector<KnownShape> all_shapes() {
    std::vector<KnownShape> all = shapes_by_form();
    for (std::vector<KnownShape> more : {shapes_by_place(), shapes_by_paint()})
        all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    return all;
}

/// The shape in another place, size and unit, with so much noise; what is measured of it.
class Seen {
public:
    Seen(const KnownShape& shape, double noise, std::mt19937& random) {
        double factor = std::pow(10, std::uniform_real_distribution<double>(-2, 2)(random));
        object_ = make_object(solids::disturbed(shape.mesh, noise, random, &factor), {Vec3::UnitZ(), 1 / factor});
        finish(shape);
    }
    explicit Seen(const KnownShape& shape) : object_(make_object(shape.mesh, {})) { finish(shape); }
    Seen(const Seen&) = delete;
    Seen& operator=(const Seen&) = delete;

    [[nodiscard]] double score(const std::string& value) const {
        const Core& core = Core::get();
        return is_a(core.domain, core.catalogue, core.questions.at(value), object_, measured_).value_or(-1);
    }

private:
    void finish(const KnownShape& shape) {
        object_.appearance = shape.appearance;
        const std::size_t count = shape.region > 0 ? shape.region : shape.mesh.triangles.size();
        for (std::size_t t = 0; t < count; ++t) part_.region.triangles.push_back(static_cast<std::int32_t>(t));
        part_.region.memberships.assign(count, 1.0F);
        part_.box = measure_part(object_.mesh, object_.geometry, part_.region.triangles, object_.is_noisy).box;
        measured_ = measure_region(object_, part_);
    }

    Object object_;
    PartRegion part_;
    RegionMeasurements measured_;
};

void expect_truth(const KnownShape& shape, const Seen& seen) {
    for (const std::string& value : shape.is)
        for (const std::string& other : Core::get().range_of(value)) {
            if (other == value)
                EXPECT_GT(seen.score(other), 0.9) << other;
            else
                EXPECT_LT(seen.score(other), 0.1) << other;
        }
    for (const std::string& value : shape.border) EXPECT_NEAR(seen.score(value), 0.5, 0.35) << value;
}

TEST(Concepts, AreWhatTheyAreAndNothingElse) {
    for (const KnownShape& shape : all_shapes()) {
        SCOPED_TRACE(shape.name);
        expect_truth(shape, Seen(shape));
    }
}

TEST(Concepts, PlaceTurnAndSizeChangeNothing) {
    constexpr unsigned seed = 5;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (const KnownShape& shape : all_shapes()) {
        SCOPED_TRACE(shape.name);
        expect_truth(shape, Seen(shape, 0, random));
    }
}

/// What it is stays likelier than not, and everything else less; on a border nothing but its two sides is likely.
TEST(Concepts, NoiseDoesNotTurnThemRound) {
    for (const KnownShape& shape : all_shapes())
        for (const unsigned seed : {1U, 2U, 3U, 4U}) {
            SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
            std::mt19937 random(seed);
            const Seen seen(shape, 0.005, random);
            for (const std::string& value : shape.is)
                for (const std::string& other : Core::get().range_of(value)) {
                    if (other == value)
                        EXPECT_GT(seen.score(other), 0.5) << other;
                    else
                        EXPECT_LT(seen.score(other), 0.5) << other;
                }
            for (const std::string& value : shape.border) {
                for (const std::string& other : Core::get().range_of(value)) {
                    const bool is_side = std::ranges::find(shape.border, other) != shape.border.end();
                    EXPECT_TRUE(is_side || seen.score(other) < 0.6) << other;
                }
            }
        }
}

/// Walks the catalogue: nothing in it goes without a case that it is, one that it is not and one on its border.
TEST(Concepts, NoneOfTheCatalogueIsLeftOut) {
    std::map<std::string, std::set<std::string>> tested;  // concept -> kinds of cases
    for (const KnownShape& shape : all_shapes()) {
        for (const std::string& value : shape.is)
            for (const std::string& other : Core::get().range_of(value))
                tested[other].insert(other == value ? "positive" : "negative");
        for (const std::string& value : shape.border) tested[value].insert("borderline");
    }
    const std::map<RelationTruth, std::string> kinds{{RelationTruth::yes, "positive"},
                                                     {RelationTruth::no, "negative"},
                                                     {RelationTruth::border, "borderline"},
                                                     {RelationTruth::unknown, "unanswerable"}};
    for (const RelationCase& each : relation_cases()) tested[each.relation].insert(kinds.at(each.truth));
    std::set<std::string> names;
    for (const ElementaryAlgorithm& algorithm : Core::get().catalogue.algorithms) names.insert(algorithm.name);
    EXPECT_GE(names.size(), 94U);  // 74 concepts, 20 relations
    for (const std::string& name : names)
        for (const char* kind : {"positive", "negative", "borderline"})
            EXPECT_TRUE(tested[name].contains(kind)) << name << " has no " << kind << " case";
    for (const auto& [name, cases] : tested) EXPECT_TRUE(names.contains(name)) << name << " is not in the catalogue";
}

}  // namespace
}  // namespace partonomy
