#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "base/files.h"

// HermiT (through ./dev setup) as a second opinion on ontologies in functional syntax.

namespace hermit {

inline std::filesystem::path jar() {
    const std::filesystem::path root = PARTONOMY_SOURCE_DIR "/.venv/lib";
    if (!std::filesystem::exists(root)) return {};
    for (const auto& python : std::filesystem::directory_iterator(root)) {
        const auto jar = python.path() / "site-packages/owlready2/hermit/HermiT.jar";
        if (std::filesystem::exists(jar)) return jar;
    }
    return {};
}

inline bool is_there() { return !jar().empty() && std::system("java -version > /dev/null 2>&1") == 0; }

/// One line of HermitJudge for each ontology; `arguments` are its own. `seconds`: for one question.
inline std::vector<std::string> judge(const std::vector<std::string>& ontologies, const std::string& arguments = {},
                                      int seconds = 10) {
    const auto folder = std::filesystem::temp_directory_path() / ("partonomy-hermit-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::string text;
    for (const std::string& ontology : ontologies) text += ontology + "%%%%\n";
    partonomy::write_file(folder / "in", text);
    const std::string command = "java -XX:+UseSerialGC -Dmilliseconds=" + std::to_string(seconds * 1000) + " -cp '" + jar().string() +
                                "' " PARTONOMY_SOURCE_DIR "/tests/knowledge/HermitJudge.java " + arguments + " < " +
                                (folder / "in").string() + " > " + (folder / "out").string() + " 2> " +
                                (folder / "err").string();
    const int code = std::system(command.c_str());
    EXPECT_EQ(code, 0) << partonomy::read_file(folder / "err");
    std::istringstream out(partonomy::read_file(folder / "out"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(out, line);) lines.push_back(line);
    std::filesystem::remove_all(folder);
    EXPECT_EQ(lines.size(), ontologies.size());
    lines.resize(ontologies.size());
    return lines;
}

}  // namespace hermit
