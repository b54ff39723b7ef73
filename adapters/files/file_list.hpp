// The files of a folder that fit a pattern.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

// A sorted list of names; each part of the pattern is looked for in one level
// of folders, links are passed over. Empty where the folder is not there. An
// error of kind File where the names have more than `most_bytes` together.
Expected<Value> list_files(const std::filesystem::path& data,
                           const std::vector<std::string>& pattern,
                           std::size_t most_bytes);

} // namespace parlour::adapters
