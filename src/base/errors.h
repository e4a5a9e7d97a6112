#pragma once

#include <stdexcept>
#include <string>

namespace partonomy {

/// What a user can mend: a file, an option, an ontology. what() is one clear sentence: where it is wrong, what is wrong,
/// what would be right. Everything that the library throws on purpose derives from this; anything else is our fault.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A file cannot be read or written.
class FileError : public Error {
public:
    using Error::Error;
};

/// A mesh file is broken, or holds no surface.
class MeshError : public Error {
public:
    using Error::Error;
};

/// An ontology has a syntax error, a missing import, or an axiom that cannot be used.
class OntologyError : public Error {
public:
    using Error::Error;
};

/// An option or argument is wrong.
class UsageError : public Error {
public:
    using Error::Error;
};

/// "file:line: sentence", or "file: sentence" when `line` is 0: the one way in which our errors name a place.
[[nodiscard]] std::string at(const std::string& file, long line, const std::string& sentence);

}  // namespace partonomy
