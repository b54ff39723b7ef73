// What is UTF-8: texts of sources and of everything that comes from outside.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace parlour {

// The offset of the first byte that is not UTF-8 in its shortest form without
// surrogates, if any.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

} // namespace parlour
