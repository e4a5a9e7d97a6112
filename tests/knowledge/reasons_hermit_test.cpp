/* HermiT's second opinion on a sample of explanations: an object of the explanation's axioms and answers that is not
   what is explained contradicts itself, and no longer when any one of them is left out. */

#include "base/errors.h"
#include "brute.h"
#include "hermit.h"
#include "owl/write.h"

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

owl::Iri individual(int region) { return "urn:test#region" + std::to_string(region); }
const owl::Iri object = "urn:test#object";

/// The features, some of the axioms about classes, and an object whose regions some of the answers are about.
class Abox {
public:
    Abox(const brute::Random& random, const Knowledge& knowledge) : random_(random), knowledge_(knowledge) {
        result_.iri = "urn:test";
        for (std::size_t i = 0; i < random.first_class; ++i) add(random.ontology.result.axioms[i]);
        for (std::size_t r = 0; r < random.values.size(); ++r) {
            const std::string n = std::to_string(r);
            sub(mini::name("Region"), mini::some("hasF" + n, "F" + n));
        }
        owl::Axiom parts{};
        parts.kind = owl::AxiomKind::object_property_range;
        parts.classes = {mini::name("Region")};
        parts.properties = {{mini::iri("hasPart"), false}};
        add(parts);
        is(object, mini::name("Object"));
        std::vector<owl::Iri> everybody{object};
        for (int region = 0; region < knowledge.region_count; ++region) {
            owl::Axiom link{};
            link.kind = owl::AxiomKind::object_property_assertion;
            link.properties = {{mini::iri("hasPart"), false}};
            link.individuals = {object, individual(region)};
            add(link);
            everybody.push_back(individual(region));
        }
        owl::Axiom different{};
        different.kind = owl::AxiomKind::different_individuals;
        different.individuals = everybody;
        add(different);
    }

    void add(const owl::Axiom& axiom) { result_.axioms.push_back(axiom); }
    void is(const owl::Iri& who, const owl::ClassPointer& what) {
        owl::Axiom axiom{};
        axiom.kind = owl::AxiomKind::class_assertion;
        axiom.classes = {what};
        axiom.individuals = {who};
        add(axiom);
    }
    void believe(const Answer& answer) {
        const auto variable = static_cast<std::size_t>(answer.question.variable);
        const std::string& value = random_.values[variable][static_cast<std::size_t>(answer.question.value)];
        const auto yes = mini::some("hasF" + std::to_string(variable), value);
        is(individual(answer.region), answer.yes ? yes : mini::no(yes));
    }
    void close() {
        auto regions = std::make_shared<owl::ClassExpression>();
        regions->kind = owl::ClassKind::one_of;
        for (int region = 0; region < knowledge_.region_count; ++region)
            regions->individuals.push_back(individual(region));
        is(object, mini::only("hasPart", regions));
    }
    [[nodiscard]] std::string text() const { return owl::write_functional(result_); }

private:
    void sub(const owl::ClassPointer& a, const owl::ClassPointer& b) {
        owl::Axiom axiom{};
        axiom.kind = owl::AxiomKind::sub_class_of;
        axiom.classes = {a, b};
        add(axiom);
    }

    const brute::Random& random_;
    const Knowledge& knowledge_;
    owl::Ontology result_;
};

}  // namespace

TEST(ReasonsHermit, AgreesThatExplanationsAreMinimal) {
    if (!hermit::is_there()) GTEST_SKIP() << "no HermiT: run ./dev setup";
    std::vector<std::string> texts, names;
    std::vector<bool> expected;  // inconsistent
    int explanations = 0;
    for (unsigned seed = 7000; seed < 8000 && explanations < 15; ++seed) {
        std::mt19937 random(seed);
        const brute::Random ontology(random, seed % 3 == 0, 2);
        Domain domain;
        try {
            domain = compile(ontology.ontology.result);
        } catch (const OntologyError&) {
            continue;
        }
        const Knowledge knowledge = brute::random_knowledge(random, ontology);
        const Conclusions conclusions = conclude(domain, knowledge);
        const auto classes = entailed(*conclusions.objects, conclusions.object);
        if (conclusions.contradiction || classes.empty()) continue;
        const Iri goal =
            conclusions.objects->concepts[static_cast<std::size_t>(classes[random() % classes.size()])].iri;
        for (const Explanation& each : all_explanations(domain, knowledge, goal).sets) {
            const std::size_t size = each.axioms.size() + each.answers.size() + (each.needs_completeness ? 1 : 0);
            if (size < 3) continue;
            ++explanations;
            for (std::size_t left_out = 0; left_out <= size; ++left_out) {  // `size`: nothing is left out
                Abox abox(ontology, knowledge);
                abox.is(object, mini::no(mini::name(owl::local_name(goal))));
                std::size_t element = 0;
                for (const std::size_t i : each.axioms)
                    if (element++ != left_out) abox.add(domain.ontology.axioms[i]);
                for (const std::size_t i : each.answers)
                    if (element++ != left_out) abox.believe(knowledge.answers[i]);
                if (each.needs_completeness && element != left_out) abox.close();
                texts.push_back(abox.text());
                names.push_back("seed " + std::to_string(seed) + ", without element " + std::to_string(left_out) +
                                " of " + std::to_string(size));
                expected.push_back(left_out == size);
            }
        }
    }
    ASSERT_GE(explanations, 15);
    const std::vector<std::string> lines = hermit::judge(texts);
    for (std::size_t i = 0; i < lines.size(); ++i)
        EXPECT_TRUE(lines[i].starts_with(expected[i] ? "inconsistent" : "consistent"))
            << names[i] << ": " << lines[i] << "\n"
            << texts[i];
}
