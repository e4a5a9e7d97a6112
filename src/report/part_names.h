#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "expert/annotation.h"
#include "mesh/triangle_mesh.h"

namespace partonomy {

/// The most specific concept of a part, "unnamed" when it has none.
[[nodiscard]] std::string concept_of(const AnnotatedPart& part);

/// All that a part, or a composite part, is called, diagnoses left out: "Handle+Head" where two names hold. What counts
/// as one name (labels.txt, eval) is the first.
[[nodiscard]] std::string all_names_of(const AnnotatedPart& part);
[[nodiscard]] std::string all_names_of(const AnnotatedComposite& composite);

/// One display name a part, all different: "Seat" where the concept occurs once, else "Leg 1", "Leg 2" …
[[nodiscard]] std::vector<std::string> part_names(const Annotation& annotation);

/// The same for composite parts.
[[nodiscard]] std::vector<std::string> composite_names(const Annotation& annotation);

/// Names with how often each occurs, in the order of the alphabet: "Leg x4, Seat".
[[nodiscard]] std::string counted(const std::vector<std::string>& names);

/// "Chair, lacks 1 Seat, 2 Leg", "Table, 1 Tabletop too many".
[[nodiscard]] std::string in_words(const NearClass& near);

/// Throws UsageError when the annotation is not one of this mesh: another number of triangles, a part index out of
/// range.
void check_belongs(const TriangleMesh& mesh, const Annotation& annotation);

/// "a, b, c".
[[nodiscard]] std::string join(const std::vector<std::string>& words, std::string_view between = ", ");

/// A part by its id; null when there is none.
[[nodiscard]] const AnnotatedPart* find_part(const Annotation& annotation, int id);

/// One line of a text file cannot hold a line break: control characters become blanks.
[[nodiscard]] std::string one_line(std::string text);

}  // namespace partonomy
