#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace partonomy::owl {

/// Where blanks and comments (from # to the end of the line) that begin at `at` end; `line` grows with each line left.
[[nodiscard]] std::size_t skip_blanks(std::string_view text, std::size_t at, long& line);

/// The token from `begin` to `end` in quotes, for error sentences: at most 40 bytes of its first line.
[[nodiscard]] std::string quoted_token(std::string_view text, std::size_t begin, std::size_t end);

}  // namespace partonomy::owl
