#include "report/part_names.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"

namespace partonomy {

std::string concept_of(const AnnotatedPart& part) { return part.concepts.empty() ? "unnamed" : part.concepts.front(); }

std::vector<std::string> part_names(const Annotation& annotation) {
    std::map<std::string, int> count;
    for (const AnnotatedPart& part : annotation.parts) ++count[concept_of(part)];
    std::map<std::string, int> number;
    std::set<std::string> taken;
    std::vector<std::string> names;
    names.reserve(annotation.parts.size());
    for (const AnnotatedPart& part : annotation.parts) {
        const std::string base = concept_of(part);
        std::string name = base;
        if (count[base] > 1) name.append(" ").append(std::to_string(++number[base]));
        while (!taken.insert(name).second) name += "'";  // a concept called "Leg 1" beside two of Leg
        names.push_back(name);
    }
    return names;
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
