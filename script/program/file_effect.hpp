// Translates the effects of <readfile> and the other file elements to requests.
#pragma once

#include <optional>

#include "runtime/base/outside/files.hpp"
#include "script/program/host.hpp"

namespace parlour::script {

// The request for an effect; nothing if the effect is not about files.
std::optional<FileRequest> file_request(const Effect& effect,
                                        std::size_t max_bytes);

} // namespace parlour::script
