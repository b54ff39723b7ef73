// The effects of <readfile> and its like as requests for whoever has the disk.
#pragma once

#include <optional>

#include "runtime/base/files.hpp"
#include "script/program/host.hpp"

namespace parlour::script {

// Nothing for an effect that is about something else.
std::optional<FileRequest> file_request(const Effect& effect,
                                        std::size_t most_bytes);

} // namespace parlour::script
