#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/errors.h"
#include "owl/ontology.h"

namespace partonomy::owl {

/// The error sentence about a document that is called `name`.
inline std::string sentence(const std::string& text, const std::string& name) {
    try {
        (void)parse_ontology(text, name);
    } catch (const OntologyError& error) {
        return error.what();
    }
    return "(no error)";
}

/// A document that must be refused.
struct Bad {
    std::string text;
    std::string begins;  ///< file and line
    std::string holds;   ///< a piece of the sentence
};

inline void expect_refused(const std::vector<Bad>& cases, const std::string& name) {
    for (const Bad& bad : cases) {
        SCOPED_TRACE(bad.text.substr(0, 2000));
        const std::string said = sentence(bad.text, name);
        EXPECT_TRUE(said.starts_with(bad.begins)) << said;
        EXPECT_NE(said.find(bad.holds), std::string::npos) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
}

}  // namespace partonomy::owl
