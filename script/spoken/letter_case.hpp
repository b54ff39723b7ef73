// Capital and small letters, by Unicode, of no particular language.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace parlour::script {

// Nothing where the text is not well-formed.
std::optional<std::string> capitals(std::string_view text);
std::optional<std::string> small_letters(std::string_view text);

} // namespace parlour::script
