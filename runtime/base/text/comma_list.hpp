// A list in one text, as options have them: "hey parlour, computer".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace parlour {

// The parts between commas, without blanks around them; empty ones are left
// out.
std::vector<std::string> split_at_commas(std::string_view text);

} // namespace parlour
