// Lists the files of a folder that fit a pattern (language rule 11.8).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

// Returns a sorted list of names. Each part of the pattern is matched in one
// level of folders; links are ignored. The list is empty if the folder does not
// exist. The error, of kind File, says that the names have more than
// `max_bytes` bytes together, or that a folder cannot be read.
Expected<Value> list_files(const std::filesystem::path& data,
                           const std::vector<std::string>& pattern,
                           std::size_t max_bytes);

} // namespace parlour::adapters
