// Examples of an application's topics from a file (understanding, "Examples"):
// a line each, the topic, a tab, and the text with its marks. Empty lines and
// those that begin with # say nothing.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "runtime/base/understanding.hpp"

namespace parlour::adapters::nlu {

inline constexpr std::size_t most_example_file_bytes = 8 << 20;

// Adds the file's examples to the topics of `model`. What is wrong is told with
// its line and column, a hundred times at most, and left out.
std::vector<Error> add_example_file(const std::filesystem::path& path,
                                    UnderstandingModel& model);

} // namespace parlour::adapters::nlu
