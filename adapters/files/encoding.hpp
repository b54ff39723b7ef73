// UTF-8 as scripts need it.
#pragma once

#include <string_view>

namespace parlour::adapters {

bool is_utf8(std::string_view text);

} // namespace parlour::adapters
