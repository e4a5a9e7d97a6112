/* What an unrecognised object comes nearest to. A second opinion: what is said to be lacking is put in, and what is
 * said to be too many is taken away; then the object must be recognised as just that. */

#include "knowledge/near_miss.h"

#include <gtest/gtest.h>

#include <random>

#include "mini.h"

using namespace mini;
using namespace partonomy::knowledge;

namespace {

constexpr Question board{0, 0}, cube{0, 1}, stick{0, 2}, horizontal{1, 0}, vertical{1, 1};

Domain furniture() {
    Ontology ontology = shapes();
    ontology.same("Seat", both({some("hasShape", "Board"), some("hasOrientation", "Horizontal")}))
        .same("Back", both({some("hasShape", "Board"), some("hasOrientation", "Vertical")}))
        .same("Leg", both({some("hasShape", "Stick"), some("hasOrientation", "Vertical")}))
        .same("Box", some("hasShape", "Cube"))
        .same("Chair", both({exactly(1, name("Seat")), some("hasPart", "Back"), at_least(3, name("Leg"))}))
        .same("Armchair", both({name("Chair"), at_least(2, name("Box"))}))
        .same("Bench", both({at_least(2, name("Seat")), either({at_least(2, name("Leg")), some("hasPart", "Box")}),
                             at_most(0, name("Back"))}))
        .same("Seating", either({name("Chair"), name("Bench")}))
        .same("BoxedSeat", both({some("hasPart", "Seat"), some("hasPart", "Box")}))
        .sub("BoxedSeat", "Incompatible");
    return compile(ontology.result);
}

const std::vector<std::pair<std::string, std::vector<Question>>> kinds{
    {"Seat", {board, horizontal}}, {"Back", {board, vertical}}, {"Leg", {stick, vertical}}, {"Box", {cube, vertical}}};

/// So many of each kind, all of them known.
Knowledge object_of(const std::vector<int>& counts) {
    Knowledge knowledge{0, true, {}};
    for (std::size_t k = 0; k < kinds.size(); ++k)
        for (int i = 0; i < counts[k]; ++i, ++knowledge.region_count)
            for (const Question& question : kinds[k].second)
                knowledge.answers.push_back({knowledge.region_count, question, true});
    return knowledge;
}

bool is_a(const Conclusions& known, const Iri& iri) {
    for (const ConceptId id : entailed(*known.objects, known.object))
        if (known.objects->concepts[static_cast<std::size_t>(id)].iri == iri) return true;
    return false;
}

int& count_of(std::vector<int>& counts, const std::string& kind) {
    for (std::size_t k = 0; k < kinds.size(); ++k)
        if (kinds[k].first == kind) return counts[k];
    throw std::out_of_range(kind);
}

TEST(NearMiss, TellsWhatIsLackingAndWhatIsTooMany) {
    const Domain domain = furniture();
    const auto nearest = [&](const std::vector<int>& counts) {
        return near_misses(domain, conclude(domain, object_of(counts))).at(0);
    };
    const NearMiss seatless = nearest({0, 1, 4, 0});
    EXPECT_EQ(seatless.iri, iri("Chair"));
    EXPECT_EQ(seatless.lacks, std::vector<std::string>{"1 Seat"});
    EXPECT_TRUE(seatless.too_many.empty());
    const NearMiss two_seats = nearest({2, 1, 4, 0});
    EXPECT_EQ(two_seats.iri, iri("Chair"));
    EXPECT_EQ(two_seats.too_many, std::vector<std::string>{"1 Seat"});
    const NearMiss legless = nearest({1, 1, 1, 0});
    EXPECT_EQ(legless.lacks, std::vector<std::string>{"2 Leg"});
    EXPECT_TRUE(near_misses(domain, conclude(domain, object_of({0, 0, 0, 0}))).empty());
    for (const NearMiss& miss : near_misses(domain, conclude(domain, object_of({1, 1, 0, 1})), {iri("Chair")}))
        EXPECT_TRUE(miss.iri != iri("Chair") && miss.iri != iri("BoxedSeat")) << miss.iri;
}

TEST(NearMiss, TellsWhichPartsMayBeWhatIsLacking) {
    const Domain domain = furniture();
    Knowledge knowledge = object_of({0, 1, 4, 0});
    knowledge.region_count += 1;
    knowledge.answers.push_back({5, board, true});  // how it lies is not known
    const NearMiss miss = near_misses(domain, conclude(domain, knowledge)).at(0);
    EXPECT_EQ(miss.iri, iri("Chair"));
    EXPECT_EQ(miss.lacks, std::vector<std::string>{"1 Seat (part 6 may be one)"});
}

/// A box that a stand does not allow speaks for the cart that wants one, although the cart lacks as many parts.
TEST(NearMiss, APartTooManySpeaksForWhatWantsIt) {
    Ontology ontology = shapes();
    ontology.same("Seat", both({some("hasShape", "Board"), some("hasOrientation", "Horizontal")}))
        .same("Back", both({some("hasShape", "Board"), some("hasOrientation", "Vertical")}))
        .same("Leg", both({some("hasShape", "Stick"), some("hasOrientation", "Vertical")}))
        .same("Box", some("hasShape", "Cube"))
        .same("Stand", both({some("hasPart", "Seat"), at_least(2, name("Leg")), at_most(0, name("Box"))}))
        .same("Cart", both({some("hasPart", "Seat"), some("hasPart", "Box"), at_least(2, name("Leg")),
                            at_least(2, name("Back"))}));
    const Domain domain = compile(ontology.result);
    const std::vector<NearMiss> near = near_misses(domain, conclude(domain, object_of({1, 0, 2, 1})));
    ASSERT_EQ(near.size(), 2U);
    EXPECT_EQ(near[0].iri, iri("Cart"));
    EXPECT_EQ(near[0].lacks, std::vector<std::string>{"2 Back"});
    EXPECT_EQ(near[1].too_many, std::vector<std::string>{"1 Box"});
}

TEST(NearMiss, WithWhatIsLackingItIsRecognised) {
    const Domain domain = furniture();
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    int told = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<int> counts;
        for (std::size_t k = 0; k < kinds.size(); ++k)
            counts.push_back(std::uniform_int_distribution<int>(0, 4)(random));
        const Conclusions known = conclude(domain, object_of(counts));
        double likeness = 1;
        for (const NearMiss& miss : near_misses(domain, known)) {
            EXPECT_LE(miss.likeness, likeness);
            likeness = miss.likeness;
            EXPECT_EQ(miss.lacks.empty() && miss.too_many.empty(), is_a(known, miss.iri)) << miss.iri;
            EXPECT_EQ(miss.likeness == 1, is_a(known, miss.iri)) << miss.iri;
            std::vector<int> mended = counts;
            const auto put = [&](const std::string& text, int sign) {
                const std::size_t blank = text.find(' ');
                count_of(mended, text.substr(blank + 1)) += sign * std::stoi(text.substr(0, blank));
            };
            for (const std::string& text : miss.lacks) put(text, 1);
            for (const std::string& text : miss.too_many) put(text, -1);
            EXPECT_TRUE(is_a(conclude(domain, object_of(mended)), miss.iri)) << miss.iri;
            ++told;
        }
    }
    EXPECT_GT(told, 300);
}

}  // namespace
