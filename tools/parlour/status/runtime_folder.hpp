// The folder in which running nodes can be asked: one socket for each, bound
// for its user only.
#pragma once

#include <filesystem>

#include "runtime/base/error.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

// $XDG_RUNTIME_DIR/parlour, else parlour-UID in the folder for temporary files.
std::filesystem::path runtime_folder(const Places& places);

// Makes it where it is missing. An error (kind File) where it is not this
// user's alone: then anybody might listen there.
Expected<void> make_runtime_folder(const std::filesystem::path& folder);

} // namespace parlour::tools
