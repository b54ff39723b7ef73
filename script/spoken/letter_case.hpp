// Upper and lower case by the rules of Unicode, for no particular language.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace parlour::script {

// Return nothing if the text is not valid UTF-8.
std::optional<std::string> capitals(std::string_view text);
std::optional<std::string> small_letters(std::string_view text);

} // namespace parlour::script
