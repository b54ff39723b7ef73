// How people read a written line aloud, where voices do it otherwise. Pure.
#pragma once

#include <string>
#include <string_view>

namespace parlour::tools {

// "9123 4567" as "9 1 2 3 4 5 6 7": telephone numbers are read digit by digit,
// not as nine thousand; "Anand s/o Menon" as "Anand son of Menon".
std::string read_aloud(std::string_view line);

} // namespace parlour::tools
