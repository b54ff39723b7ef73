// Braces in a text that embed nothing (language rule 4.4).
#pragma once

#include <string_view>

namespace parlour::script {

// Where the first one is that is not doubled; npos: there is none.
std::size_t plain_brace(std::string_view text);

} // namespace parlour::script
