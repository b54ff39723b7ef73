// As many open files as so many visitors need: each has a connection.
#pragma once

#include <cstddef>

namespace parlour::tools {

// Raises this process's limit of open files, as far as the system lets it.
// Returns for how many connections there is room beside `others`.
// `others`: files that the rest of the process needs. Where the limit cannot be
// read, `wanted` is returned.
std::size_t room_for_connections(std::size_t wanted, std::size_t others);

} // namespace parlour::tools
