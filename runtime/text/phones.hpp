// The phones of English (CMU's, without stress): AA, AE, … What recognisers say
// how words sound with.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace parlour {

bool is_phone(std::string_view text);

// What is wrong with a list of phones with blanks between, such as "HH OW"; the
// sentence names the first that is none. Nothing: all is right.
std::optional<std::string> mistake_in_phones(std::string_view phones);

// The phones as a recogniser's dictionary has them: one blank between.
std::string tidy_phones(std::string_view phones);

} // namespace parlour
