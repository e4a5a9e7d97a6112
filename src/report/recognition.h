#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace partonomy {

/// What many objects were recognised as, beside what they are. Classes are those of the annotation, diagnoses left out;
/// nullopt where it is lost.
struct Recognition {
    using Classes = std::optional<std::vector<std::string>>;

    /// Of objects with a true class: right, or "chair3 as Table instead of Chair".
    std::size_t right = 0;
    std::vector<std::string> wrong;
    /// Of objects of no kind that the ontology knows: they must not be recognised. By name; the second with its
    /// classes.
    std::vector<std::string> rightly_not_recognised, recognised, unknown;

    /// Right where `truth` is among the classes, superclasses included.
    void add(const std::string& mesh, const std::string& truth, const Classes& classes);
    void add_of_no_kind(const std::string& mesh, const Classes& classes);

    [[nodiscard]] std::size_t of_a_class() const { return right + wrong.size(); }
    [[nodiscard]] std::size_t of_no_kind() const {
        return rightly_not_recognised.size() + recognised.size() + unknown.size();
    }

    /// "classes: 9 of 10 right; chair3 as Table instead of Chair".
    [[nodiscard]] std::string classes_in_words() const;
    /// "2 meshes of no kind: 1 rightly not recognised, 1 recognised (box as Table)".
    [[nodiscard]] std::string no_kind_in_words() const;
};

/// Reads true classes: on each line the name of a mesh (a path or an ending is left out) and its class, by blanks or a
/// comma; "-" for what is of no kind. Empty lines and what follows a # are skipped. `source` is what errors call the
/// text. Throws UsageError with the line for anything else, and for a mesh with two classes.
[[nodiscard]] std::map<std::string, std::string> read_classes(const std::string& text, const std::string& source);

}  // namespace partonomy
