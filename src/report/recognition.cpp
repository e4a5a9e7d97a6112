#include "report/recognition.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "base/errors.h"

namespace partonomy {

void Recognition::add(const std::string& mesh, const std::string& truth, const Classes& classes) {
    if (classes && std::ranges::find(*classes, truth) != classes->end()) {
        ++right;
        return;
    }
    const std::string found = !classes           ? "without annotation.json"
                              : classes->empty() ? "not recognised"
                                                 : fmt::format("as {}", fmt::join(*classes, ", "));
    wrong.push_back(fmt::format("{} {} instead of {}", mesh, found, truth));
}

void Recognition::add_of_no_kind(const std::string& mesh, const Classes& classes) {
    if (!classes)
        unknown.push_back(mesh);
    else if (classes->empty())
        rightly_not_recognised.push_back(mesh);
    else
        recognised.push_back(fmt::format("{} as {}", mesh, fmt::join(*classes, ", ")));
}

std::string Recognition::classes_in_words() const {
    return fmt::format("classes: {} of {} right{}{}", right, of_a_class(), wrong.empty() ? "" : "; ",
                       fmt::join(wrong, "; "));
}

std::string Recognition::no_kind_in_words() const {
    std::vector<std::string> said;
    if (const std::size_t number = rightly_not_recognised.size(); number > 0)
        said.push_back(fmt::format("{} rightly not recognised", number));
    if (!recognised.empty())
        said.push_back(fmt::format("{} recognised ({})", recognised.size(), fmt::join(recognised, "; ")));
    if (!unknown.empty())
        said.push_back(fmt::format("{} without annotation.json ({})", unknown.size(), fmt::join(unknown, ", ")));
    return fmt::format("{} {} of no kind: {}", of_no_kind(), of_no_kind() == 1 ? "mesh" : "meshes",
                       fmt::join(said, ", "));
}

std::map<std::string, std::string> read_classes(const std::string& text, const std::string& source) {
    std::map<std::string, std::string> classes;
    std::istringstream lines(text);
    std::string line;
    for (long number = 1; std::getline(lines, line); ++number) {
        line = line.substr(0, line.find('#'));
        std::ranges::replace(line, ',', ' ');
        std::istringstream words(line);
        std::string mesh, name, more;
        if (!(words >> mesh)) continue;
        if (!(words >> name) || words >> more)
            throw UsageError(
                at(source, number, "a line should be the name of a mesh and its class, as in: chair3 Chair"));
        if (!classes.emplace(std::filesystem::path(mesh).stem().string(), name).second)
            throw UsageError(at(source, number, mesh + " has a class already"));
    }
    return classes;
}

}  // namespace partonomy
