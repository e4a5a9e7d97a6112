#include "report/part_names.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"

namespace partonomy {

std::string concept_of(const AnnotatedPart& part) { return part.concepts.empty() ? "unnamed" : part.concepts.front(); }

std::string all_names_of(const AnnotatedPart& part) {
    return part.names.empty() ? concept_of(part) : join(part.names, "+");
}

std::string all_names_of(const AnnotatedComposite& composite) {
    return composite.names.empty() ? composite.concepts.front() : join(composite.names, "+");
}

namespace {

/// Makes names different by numbers where one occurs more than once.
std::vector<std::string> told_apart(const std::vector<std::string>& bases) {
    std::map<std::string, int> count, number;
    for (const std::string& base : bases) ++count[base];
    std::set<std::string> taken;
    std::vector<std::string> names;
    names.reserve(bases.size());
    for (const std::string& base : bases) {
        std::string name = base;
        if (count[base] > 1) name.append(" ").append(std::to_string(++number[base]));
        while (!taken.insert(name).second) name += "'";  // a concept called "Leg 1" beside two of Leg
        names.push_back(name);
    }
    return names;
}

}  // namespace

std::vector<std::string> part_names(const Annotation& annotation) {
    std::vector<std::string> bases;
    for (const AnnotatedPart& part : annotation.parts) bases.push_back(concept_of(part));
    return told_apart(bases);
}

std::vector<std::string> composite_names(const Annotation& annotation) {
    std::vector<std::string> bases;
    for (const AnnotatedComposite& composite : annotation.composites) bases.push_back(composite.concepts.front());
    return told_apart(bases);
}

std::string counted(const std::vector<std::string>& names) {
    std::map<std::string, int> counts;
    for (const std::string& name : names) ++counts[name];
    std::vector<std::string> words;
    for (const auto& [name, count] : counts) words.push_back(count > 1 ? name + " x" + std::to_string(count) : name);
    return join(words);
}

std::string in_words(const NearClass& near) {
    std::string text = near.concept_name;
    if (!near.lacks.empty()) text += ", lacks " + join(near.lacks);
    if (!near.too_many.empty()) text += ", " + join(near.too_many) + " too many";
    return text;
}

void check_belongs(const TriangleMesh& mesh, const Annotation& annotation) {
    if (annotation.part_of_triangle.size() != mesh.triangles.size())
        throw UsageError("the annotation speaks of " + std::to_string(annotation.part_of_triangle.size()) +
                         " triangles, the mesh has " + std::to_string(mesh.triangles.size()));
    const auto parts = static_cast<std::int64_t>(annotation.parts.size());
    for (const std::int32_t part : annotation.part_of_triangle)
        if (part < -1 || part >= parts)
            throw UsageError("the annotation gives a triangle to part number " + std::to_string(part) + " of " +
                             std::to_string(parts));
}

std::string join(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) {
        if (&word != &words.front()) text += between;
        text += word;
    }
    return text;
}

const AnnotatedPart* find_part(const Annotation& annotation, int id) {
    const auto found = std::find_if(annotation.parts.begin(), annotation.parts.end(),
                                    [&](const AnnotatedPart& part) { return part.id == id; });
    return found == annotation.parts.end() ? nullptr : &*found;
}

std::string one_line(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
    return text;
}

}  // namespace partonomy
