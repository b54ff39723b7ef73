// Reads examples of topics from a file of the application (understanding,
// "Examples"). Each line has a topic, a tab, and a text with its marks:
//
//  Visit<tab>I would like to meet [Jeffery Ho](Host)
//
// Blank lines and lines that begin with # are ignored.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu {

// A larger file is an error.
inline constexpr std::size_t max_example_file_bytes = 8 << 20;

// Adds the examples to the topics of `model`. Lines with errors are left out;
// the errors have line and column. Reading stops after a hundred errors.
std::vector<Error> add_example_file(const std::filesystem::path& path,
                                    UnderstandingModel& model);

} // namespace parlour::adapters::nlu
