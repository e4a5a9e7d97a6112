/* The paper's reasoner against ours on the paper's job: which concept is each configuration of a part's features? For
 * HermiT the product of the features becomes one defined class for each configuration, beside core.ttl and the
 * ontology, and classifying them all tells below which concepts each one is. It runs in one Java process, which has
 * done the same several times before it is timed; but for the 6,256 classes of furniture.ttl, which take it minutes. */

#include "bench/bench_hermit.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <sstream>

#include "base/files.h"
#include "expert/annotate.h"
#include "knowledge/decision_tree.h"
#include "owl/write.h"

namespace partonomy::bench {
namespace {

namespace fs = std::filesystem;
using knowledge::Domain;
using owl::ClassKind;

fs::path hermit_jar() {
    const fs::path root = PARTONOMY_SOURCE_DIR "/.venv/lib";
    if (!fs::exists(root)) return {};
    for (const auto& python : fs::directory_iterator(root))
        if (const auto jar = python.path() / "site-packages/owlready2/hermit/HermiT.jar"; fs::exists(jar)) return jar;
    return {};
}

owl::ClassPointer named(const owl::Iri& iri) {
    auto expression = std::make_shared<owl::ClassExpression>();
    expression->iri = iri;
    return expression;
}

/// "hasShape some Board", "height some xsd:double[<= 0.55]".
owl::ClassPointer feature(const Domain& domain, const knowledge::Variable& variable, std::size_t value) {
    auto expression = std::make_shared<owl::ClassExpression>();
    if (variable.kind == knowledge::VariableKind::range) {
        const knowledge::RangeConcept& range = domain.ranges[static_cast<std::size_t>(variable.index)];
        expression->kind = ClassKind::some_values_from;
        expression->property.iri = range.property;
        expression->operands = {named(range.values[value].iri)};
        return expression;
    }
    const std::string xsd = "http://www.w3.org/2001/XMLSchema#";
    const knowledge::MeasuredProperty& number = domain.numbers[static_cast<std::size_t>(variable.index)];
    const auto& interval = number.intervals[value];
    expression->kind = ClassKind::data_some_values_from;
    expression->property.iri = number.iri;
    expression->range.datatype = xsd + "double";
    const auto bound = [&](const char* facet, bool is_closed, double x) {
        if (std::isinf(x)) return;
        expression->range.facets.push_back(
            {xsd + facet + (is_closed ? "Inclusive" : "Exclusive"), {fmt::format("{}", x), xsd + "double", ""}});
    };
    bound("min", interval.low_closed, interval.low);
    bound("max", interval.high_closed, interval.high);
    return expression;
}

/// The ontology with a class for each configuration of a region.
owl::Ontology with_product(const Domain& domain) {
    owl::Ontology ontology = domain.ontology;
    domain.regions.all().for_each([&](std::size_t i) {
        auto both = std::make_shared<owl::ClassExpression>();
        both->kind = ClassKind::intersection_of;
        both->operands = {named(std::string(owl::core_prefix) + "Region")};
        for (std::size_t v = 0; v < domain.regions.variables.size(); ++v)
            for (std::size_t k = 0; k < domain.regions.holds[v].size(); ++k)
                if (domain.regions.holds[v][k].has(i))
                    both->operands.push_back(feature(domain, domain.regions.variables[v], k));
        const owl::Iri iri = fmt::format("urn:product#C{:03}", i);
        ontology.entities.push_back({owl::EntityKind::klass, iri, {}});
        owl::Axiom axiom{};
        axiom.kind = owl::AxiomKind::equivalent_classes;
        axiom.classes = {named(iri), both};
        ontology.axioms.push_back(axiom);
    });
    std::ranges::stable_sort(ontology.entities, {}, &owl::Entity::iri);
    return ontology;
}

double ms_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// One ontology, the criterion of its tree, and how often HermiT does its product.
struct Furniture {
    std::string file;
    std::string criterion;
    int warm_ups, runs;
    [[nodiscard]] std::string path() const { return PARTONOMY_SOURCE_DIR "/ontologies/" + file; }
};

/// With the part of core that it speaks of, as `partonomy tree` and `annotate` read it.
owl::Ontology load(const Furniture& furniture) {
    owl::LoadOptions options;
    options.whole_core = false;
    return owl::load_ontology(furniture.path(), options);
}

/// Median of the time from the ontology's file to the tree's file, in this process: what `partonomy tree -o` does.
double our_ms(const Furniture& furniture, const fs::path& folder) {
    std::vector<double> times;
    for (int i = 0; i < 41; ++i)
        times.push_back(ms_of([&] {
            const Domain domain = knowledge::compile(load(furniture));
            const Catalogue catalogue = make_catalogue(domain);
            const std::vector<knowledge::Concept>& concepts = domain.regions.concepts;
            knowledge::PlanOptions plan;
            plan.criterion = parse_criterion(furniture.criterion);
            plan.cost = [&](knowledge::Question question) -> std::optional<double> {
                const ElementaryAlgorithm* algorithm = catalogue.find(Signature::is_a, question);
                if (!algorithm) algorithm = catalogue.find(Signature::related, question);
                return algorithm ? std::optional(algorithm->cost) : std::nullopt;
            };
            for (std::size_t c = 0; c < concepts.size(); ++c)
                if (concepts[c].provable && !concepts[c].iri.starts_with(owl::core_prefix))
                    plan.wanted.push_back(static_cast<knowledge::ConceptId>(c));
            const auto find_all = [&](knowledge::Question question) { return catalogue.cutting_cost(question, 0); };
            write_file(folder / "tree.json", to_json(build_tree(domain.regions, plan, find_all), domain));
        }));
    std::ranges::sort(times);
    return times[times.size() / 2];
}

void compare(const Furniture& furniture, const fs::path& folder, bool with_hermit) {
    const double ours = our_ms(furniture, folder);
    fmt::print("  {}: read, compile, whole {} tree, written as JSON: {:.2f} ms\n", furniture.file, furniture.criterion,
               ours);
    if (!with_hermit) return;
    if (hermit_jar().empty() || std::system("java -version > /dev/null 2>&1") != 0) {
        fmt::print("  HermiT: skipped, no Java or no Python environment (./dev setup)\n");
        return;
    }
    const Domain domain = knowledge::compile(load(furniture));
    write_file(folder / "product.ofn", write_functional(with_product(domain), {.merge_imports = true}));
    const std::string command =
        fmt::format("java -cp '{}' '{}' '{}' {} {} > '{}' 2> '{}'", hermit_jar().string(),
                    PARTONOMY_SOURCE_DIR "/bench/HermitProduct.java", (folder / "product.ofn").string(),
                    furniture.warm_ups, furniture.runs, (folder / "out").string(), (folder / "err").string());
    double load = 0, classify = 0;
    int classes = 0;
    if (std::system(command.c_str()) != 0 ||
        !(std::istringstream(read_file(folder / "out")) >> load >> classify >> classes)) {
        fmt::print("  HermiT: failed: {}\n", read_file(folder / "err"));
        return;
    }
    fmt::print("  HermiT: {} classes, read {:.0f} ms, classify {:.0f} ms (medians of {} after {} warm-ups)\n", classes,
               load, classify, furniture.runs, furniture.warm_ups);
    fmt::print("  ratio: {:.0f} x with reading, {:.0f} x classification alone\n", (load + classify) / ours,
               classify / ours);
}

}  // namespace

void bench_hermit(bool with_all) {
    fmt::print("\nFurniture from file to saved tree; reference: HermiT in one warm process on the same product\n");
    const fs::path folder = fs::temp_directory_path() / ("partonomy-hermit-bench-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    compare({"paper-furniture.ttl", "dichotomy", 5, 5}, folder, true);
    compare({"furniture.ttl", "gain-per-cost", 0, 1}, folder, with_all);
    fs::remove_all(folder);
}

}  // namespace partonomy::bench
