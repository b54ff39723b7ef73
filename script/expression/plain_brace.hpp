// Braces in a text that embed nothing (language rule 4.4).
#pragma once

#include <string_view>

namespace parlour::script {

// Where the first one is that is not doubled; npos: there is none.
std::size_t plain_brace(std::string_view text);
// Behind the expression that the brace at that place embeds; npos: none.
std::size_t embedded_end(std::string_view text, std::size_t brace);

} // namespace parlour::script
