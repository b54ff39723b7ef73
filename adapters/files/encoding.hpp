// Checks whether bytes are valid UTF-8.
#pragma once

#include <string_view>

namespace parlour::adapters {

bool is_utf8(std::string_view text);

} // namespace parlour::adapters
