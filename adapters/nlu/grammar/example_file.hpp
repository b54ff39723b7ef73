// Reads examples and wordings of topics from files of the application
// (docs/understanding.md, "Examples" and "Wordings"). Each line has a topic, a
// tab, and a text with its marks. Behind the topic of a wording stand slots
// that the text fills without saying their values:
//
//  Visit<tab>I would like to meet [Jeffery Ho](Host)
//  Place Name="swimming pool"<tab>can I take a dip
//
// Blank lines and lines that begin with # are ignored.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu {

// A larger file is an error.
inline constexpr std::size_t max_example_file_bytes = 8 << 20;

// A sentence that people say, and what it means.
struct Wording {
  std::string topic;
  // Slots that it fills by itself, in the order of their names.
  std::vector<std::pair<std::string, Value>> constants;
  std::string text; // with its marks

  bool operator==(const Wording&) const = default;
};

// Adds the examples to the topics of `model`. Lines with errors are left out;
// the errors have line and column. Reading stops after a hundred errors.
std::vector<Error> add_example_file(const std::filesystem::path& path,
                                    UnderstandingModel& model);

// The same for wordings of topics that `model` has.
std::vector<Error> read_wording_file(const std::filesystem::path& path,
                                     const UnderstandingModel& model,
                                     std::vector<Wording>& wordings);

} // namespace parlour::adapters::nlu
