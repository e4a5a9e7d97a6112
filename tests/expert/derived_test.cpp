// `find all` of concepts that no algorithm was made for: holes and bosses of plates, and an expert's own range concept.

#include <gtest/gtest.h>

#include <map>

#include "base/errors.h"
#include "expert/annotate.h"
#include "expert/session.h"
#include "shape/part_box.h"
#include "shape/solids.h"

namespace partonomy {
namespace {

constexpr double pi = std::numbers::pi;

/// A plate of square tiles of size 1, each plain ('.'), with a hole ('o') or with a boss on it ('b').
struct Plate {
    TriangleMesh mesh;
    std::vector<std::string> labels;  ///< per triangle: Hole, Boss or -
    int holes = 0, bosses = 0;

    explicit Plate(const std::vector<std::string>& rows, double thickness = 0.25, double radius = 0.3) {
        const int columns = static_cast<int>(rows[0].size()), lines = static_cast<int>(rows.size());
        const auto has = [&](int x, int y) { return x >= 0 && y >= 0 && x < columns && y < lines; };
        for (int y = 0; y < lines; ++y)
            for (int x = 0; x < columns; ++x) {
                const char kind = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
                holes += kind == 'o';
                bosses += kind == 'b';
                const auto point = [&](int i, double share, double z) {  // share 0 on the circle, 1 on the square
                    const double turn = 2 * pi * i / around, c = std::cos(turn), s = std::sin(turn);
                    const double square = 0.5 / std::max(std::abs(c), std::abs(s));
                    const double r = radius + share * (square - radius);
                    return at(x + 0.5 + r * c, y + 0.5 + r * s, z);
                };
                for (int i = 0; i < around; ++i) {
                    for (int k = 0; k < 3; ++k) {
                        const double a = k / 3.0, b = (k + 1) / 3.0;
                        quad(point(i, a, thickness), point(i, b, thickness), point(i + 1, b, thickness),
                             point(i + 1, a, thickness), "-");
                        quad(point(i, a, 0), point(i + 1, a, 0), point(i + 1, b, 0), point(i, b, 0), "-");
                    }
                    const double middle = 2 * pi * (i + 0.5) / around;
                    const int side_x =
                        std::abs(std::cos(middle)) > std::abs(std::sin(middle)) ? (std::cos(middle) > 0 ? 1 : -1) : 0;
                    const int side_y = side_x != 0 ? 0 : (std::sin(middle) > 0 ? 1 : -1);
                    for (int k = 0; k < 2 && !has(x + side_x, y + side_y); ++k)
                        quad(point(i, 1, k * thickness / 2), point(i + 1, 1, k * thickness / 2),
                             point(i + 1, 1, (k + 1) * thickness / 2), point(i, 1, (k + 1) * thickness / 2), "-");
                    for (int k = 0; k < 2 && kind == 'o'; ++k)
                        quad(point(i + 1, 0, k * thickness / 2), point(i, 0, k * thickness / 2),
                             point(i, 0, (k + 1) * thickness / 2), point(i + 1, 0, (k + 1) * thickness / 2), "Hole");
                    if (kind == 'o') continue;
                    const auto disc = [&](double z, bool upward, const char* label) {
                        const auto ring = [&](int j, double share) {
                            const double turn = 2 * pi * j / around;
                            return at(x + 0.5 + share * radius * std::cos(turn),
                                      y + 0.5 + share * radius * std::sin(turn), z);
                        };
                        const std::int32_t m = at(x + 0.5, y + 0.5, z);
                        if (upward) {
                            triangle(m, ring(i, 0.5), ring(i + 1, 0.5), label);
                            quad(ring(i, 0.5), ring(i, 1), ring(i + 1, 1), ring(i + 1, 0.5), label);
                        } else {
                            triangle(m, ring(i + 1, 0.5), ring(i, 0.5), label);
                            quad(ring(i, 0.5), ring(i + 1, 0.5), ring(i + 1, 1), ring(i, 1), label);
                        }
                    };
                    disc(0, false, "-");
                    if (kind == '.') disc(thickness, true, "-");
                    if (kind != 'b') continue;
                    const double step = 0.1;
                    for (int k = 0; k < 5; ++k)
                        quad(point(i, 0, thickness + k * step), point(i + 1, 0, thickness + k * step),
                             point(i + 1, 0, thickness + (k + 1) * step), point(i, 0, thickness + (k + 1) * step),
                             "Boss");
                    disc(thickness + 5 * step, true, "Boss");
                }
            }
        mesh = solids::finish(std::move(mesh));
    }

private:
    static constexpr int around = 32;
    std::map<std::array<long, 3>, std::int32_t> places_;
    std::int32_t at(double x, double y, double z) {
        const std::array<long, 3> key{std::lround(x * 1e6), std::lround(y * 1e6), std::lround(z * 1e6)};
        const auto [place, is_new] = places_.emplace(key, static_cast<std::int32_t>(mesh.positions.size()));
        if (is_new) mesh.positions.emplace_back(x, y, z);
        return place->second;
    }
    void triangle(std::int32_t a, std::int32_t b, std::int32_t c, const char* label) {
        mesh.triangles.push_back({a, b, c});
        labels.emplace_back(label);
    }
    void quad(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, const char* label) {
        triangle(a, b, c, label);
        triangle(a, c, d, label);
    }
};

const char* const head =
    "@prefix : <http://example.org/#> .\n@prefix core: <https://w3id.org/partonomy/core#> .\n"
    "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
    "<http://example.org/> a owl:Ontology ; owl:imports <https://w3id.org/partonomy/core> .\n";

std::string some(const std::string& property, const std::string& filler) {
    return "[ a owl:Restriction ; owl:onProperty " + property + " ; owl:someValuesFrom " + filler + " ]";
}

std::string defined(const std::string& name, const std::string& super, const std::string& conditions) {
    return name + " a owl:Class ; rdfs:subClassOf " + super +
           " ; owl:equivalentClass [ a owl:Class ; owl:intersectionOf ( " + super + " " + conditions + " ) ] .\n";
}

struct Expert {
    knowledge::Domain domain;
    Catalogue catalogue;
    explicit Expert(const std::string& text)
        : domain(knowledge::compile(owl::parse_ontology(head + text, "test.ttl"))), catalogue(make_catalogue(domain)) {}
    [[nodiscard]] Annotation annotate(const TriangleMesh& mesh, double metres = 1) const {
        return partonomy::annotate(domain, catalogue, make_object(mesh, {Vec3::UnitZ(), metres}), {});
    }
};

const Expert& inspector() {
    static const Expert expert(
        defined(":Hole", "core:Region",
                some("core:hasSurfaceType", "core:Cylinder") + some("core:hasConvexity", "core:Concave")) +
        defined(":Boss", "core:Region",
                some("core:hasSurfaceType", "core:Cylinder") + some("core:hasConvexity", "core:Convex")) +
        defined(":Drilled", "core:Object", some("core:hasPart", ":Hole")));
    return expert;
}

int count_of(const Annotation& annotation, const std::string& name) {
    return static_cast<int>(std::ranges::count_if(annotation.parts, [&](const AnnotatedPart& part) {
        return std::ranges::find(part.concepts, name) != part.concepts.end();
    }));
}

TEST(Derived, HolesAndBossesOfPlates) {
    for (const std::vector<std::string>& rows :
         {std::vector<std::string>{".o."}, {"o.o", "..."}, {"ob.", ".o."}, {"..", ".."}, {"b.", ".b"}}) {
        const Plate plate(rows);
        for (const double noise : {0.0, 0.005})
            for (const unsigned seed : {1U, 2U}) {
                SCOPED_TRACE(rows[0] + " noise " + std::to_string(noise) + " seed " + std::to_string(seed));
                std::mt19937 random(seed);
                const Annotation annotation = inspector().annotate(solids::disturbed(plate.mesh, noise, random));
                EXPECT_EQ(count_of(annotation, "Hole"), plate.holes);
                EXPECT_EQ(count_of(annotation, "Boss"), plate.bosses);
                if (noise == 0) {  // else other cuts are asked about, too
                    EXPECT_EQ(annotation.questions.at("SF"), 1);
                }
                // Most of what is told to be a hole or boss is one, and the other way round.
                double right = 0, all = 0;
                for (std::size_t t = 0; t < plate.labels.size(); ++t) {
                    all += plate.labels[t] != "-" || annotation.labels[t] != "-";
                    right += plate.labels[t] != "-" && annotation.labels[t] == plate.labels[t];
                }
                EXPECT_GE(right, 0.95 * all);
            }
    }
}

/// A board on two others: its own range concept asks for the height between its lowest and highest point.
const std::string rises =
    ":SeatHeight a owl:Class ; rdfs:subClassOf core:Feature ; owl:disjointUnionOf ( :Thin :Thick ) .\n"
    ":hasSeatHeight a owl:ObjectProperty , owl:FunctionalProperty ; rdfs:subPropertyOf core:hasFeature ; "
    "rdfs:domain core:Region ; rdfs:range :SeatHeight .\n"
    ":Thin a owl:Class ; core:question \"is it as thin as a seat\" ; core:measure \"top height - bottom height\" ; "
    "core:membership \"-inf -inf 0.08 0.12\" .\n"
    ":Thick a owl:Class ; core:question \"is it thick\" ; core:measure \"top height - bottom height\" ; "
    "core:membership \"0.08 0.12 inf inf\" .\n" +
    defined(":Seat", "core:Region", some(":hasSeatHeight", ":Thin")) +
    defined(":Stand", "core:Region", some(":hasSeatHeight", ":Thick")) +
    defined(":Bench", "core:Object", some("core:hasPart", ":Seat") + some("core:hasPart", ":Stand"));

TriangleMesh bench() {
    const auto board = [](double x, double y, double z, double dx, double dy, double dz) {
        return solids::moved(solids::sweep(solids::rectangle(dx, dy, 0.05), dz, 0.05),
                             [=](const Vec3& p) -> Vec3 { return p + Vec3(x, y, z); });
    };
    TriangleMesh mesh;
    for (const TriangleMesh& part :
         {board(0, 0, 0.4, 1.2, 0.4, 0.05), board(-0.4, 0, 0, 0.05, 0.35, 0.39), board(0.4, 0, 0, 0.05, 0.35, 0.39)}) {
        const auto first = static_cast<std::int32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
        for (const auto& t : part.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return solids::finish(std::move(mesh));
}

TEST(Derived, ConceptsOfAnExpertWorkLikeBuiltInOnes) {
    const Expert expert(rises);
    for (const unsigned seed : {1U, 2U, 3U}) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        double metres = 1;
        const Annotation annotation = expert.annotate(solids::disturbed(bench(), 0, random, &metres));
        EXPECT_EQ(count_of(annotation, "Seat"), 1);
        EXPECT_EQ(count_of(annotation, "Stand"), 2);
        EXPECT_EQ(annotation.classes, std::vector<std::string>{"Bench"});
        for (const AnnotatedPart& part : annotation.parts) {
            const bool is_seat = part.concepts.front() == "Seat";
            EXPECT_NEAR(part.measurements.at("top height - bottom height"), is_seat ? 0.05 : 0.39, 1e-6);
            EXPECT_EQ(part.features.at("SeatHeight"), is_seat ? "Thin" : "Thick");
            EXPECT_GT(part.score, 0.9);
        }
        EXPECT_TRUE(std::ranges::any_of(annotation.trace, [](const TraceEntry& entry) {
            return entry.kind == "SI" && entry.question.find("is it as thin as a seat") != std::string::npos;
        }));
    }
}

/// The same question as a `find all`: the same regions, whoever asks.
TEST(Derived, FindAllOfAnExpertsConcept) {
    const Expert expert(rises);
    const Object object = make_object(bench(), {});
    const auto variable = expert.domain.regions.find_variable("http://example.org/#SeatHeight");
    ASSERT_TRUE(variable);
    const ElementaryAlgorithm* algorithm = expert.catalogue.find(Signature::find_all, {*variable, 1});
    ASSERT_NE(algorithm, nullptr);
    EXPECT_EQ(algorithm->origin, Origin::derived);
    const Cut cut = cut_of(object);
    Session session(expert.domain, expert.catalogue, object, cut);
    EXPECT_EQ(session.find_all({*variable, 1}), 2);
    EXPECT_TRUE(session.has_rest());
    EXPECT_EQ(session.find_all({*variable, 0}), 1);
    EXPECT_FALSE(session.has_rest());
    EXPECT_EQ(session.find_all_count, 2);
    EXPECT_EQ(session.trace.front().kind, "SF");
}

/// Without a unit nothing can tell, and nothing is guessed.
TEST(Derived, MetresNeedAUnit) {
    const Expert expert(rises);
    const Annotation annotation =
        annotate(expert.domain, expert.catalogue, make_object(bench(), {Vec3::UnitZ(), std::nullopt}), {});
    EXPECT_EQ(annotation.questions.at("SI") + annotation.questions.at("SF"), 0);
    for (const AnnotatedPart& part : annotation.parts) {
        EXPECT_FALSE(part.features.contains("SeatHeight"));
        EXPECT_FALSE(part.measurements.contains("top height - bottom height"));
        EXPECT_LE(part.score, 0.5);  // a seat as likely as a stand
    }
}

/// A seat that was cut in two is found as one; a corner of two walls is not.
TEST(Derived, PartsThatBelongTogetherAreMerged) {
    const Object object = make_object(bench(), {});
    ASSERT_EQ(object.candidates.size(), 3U);
    std::vector<PartRegion> parts;
    for (const PartRegion& part : object.candidates) {
        std::vector<std::int32_t> left, right;
        for (const std::int32_t t : part.region.triangles)
            (object.geometry.barycentres[static_cast<std::size_t>(t)].x() < 0 ? left : right).push_back(t);
        for (std::vector<std::int32_t>* half : {&left, &right}) {
            if (half->empty()) continue;
            const PartBox box = measure_part(object.mesh, object.geometry, *half, object.is_noisy);
            parts.push_back({{*half, box.memberships}, box.box, box.fit});
        }
    }
    ASSERT_EQ(parts.size(), 4U);
    std::vector<const PartRegion*> pointers;
    for (const PartRegion& part : parts) pointers.push_back(&part);
    const DerivedRegions all = derive_find_all(object, pointers, Grain::parts, [](const auto&) { return 1.0; });
    ASSERT_EQ(all.found.size(), 3U);
    int merged = 0;
    for (const DerivedRegion& region : all.found) merged += region.of.size() == 2;
    EXPECT_EQ(merged, 1);
    EXPECT_TRUE(all.rests.empty());
}

TEST(Derived, AnExpertsRangeMayTellWhatTheMeshIsCutInto) {
    std::string text = rises;
    const std::string feature = "core:Feature ; owl:dis";
    text.replace(text.find(feature), feature.size(), "core:Feature ; core:regions \"cut\" ; owl:dis");
    const Expert cut(text), derived(rises);
    for (const auto& [expert, origin] : {std::pair(&cut, Origin::own), std::pair(&derived, Origin::derived)})
        for (const ElementaryAlgorithm& algorithm : expert->catalogue.algorithms)
            if (algorithm.signature == Signature::find_all) {
                EXPECT_EQ(algorithm.origin, origin) << algorithm.name;
            }
    const Annotation annotation = cut.annotate(bench());
    EXPECT_EQ(annotation.classes, std::vector<std::string>{"Bench"});
    EXPECT_EQ(count_of(annotation, "Seat"), 1);
    EXPECT_EQ(count_of(annotation, "Stand"), 2);
    EXPECT_EQ(annotation.questions.at("SF"), 1);  // one question cuts all three
    EXPECT_LE(annotation.questions.at("SI"), 0);
}

TEST(Derived, WrongWordsAreRefused) {
    const auto error_of = [](std::string from, const std::string& to) {
        std::string text = rises;
        text.replace(text.find(from), from.size(), to);
        try {
            static_cast<void>(Expert(text));
        } catch (const OntologyError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    const std::string formula = "\"top height - bottom height\"";
    EXPECT_NE(error_of(formula, "\"top height - botom height\"").find("did you mean \"bottom height\"?"),
              std::string::npos);
    EXPECT_NE(error_of(formula, "\"top height - inclination\"").find("it subtracts m and degrees"), std::string::npos);
    EXPECT_NE(error_of(formula, "\"top height - inclination\"").find("test.ttl:"), std::string::npos);
    EXPECT_NE(error_of("core:Feature ; owl:dis", "core:Feature ; core:regions \"pieces\" ; owl:dis")
                  .find("should be \"cut\", \"parts\" or \"patches\""),
              std::string::npos);
}

}  // namespace
}  // namespace partonomy
