// Sentences of several kinds from a file, and digits in a text. Pure, but for
// the reading.
#pragma once

#include <filesystem>
#include <istream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/error.hpp"

namespace parlour::tools {

// By their kinds, in the order of the file.
using Sentences = std::map<std::string, std::vector<std::string>>;

// A kind, a tab and a sentence in each line; other lines, and those that begin
// with #, are left out.
Sentences read_sentences(std::istream& in);
Expected<Sentences> read_sentences(const std::filesystem::path& file);

// "nine 1 two, 34" as "91234": figures and their English names. Other words are
// left out, but "double" counts the next digit twice.
std::string digits_in(std::string_view text);

} // namespace parlour::tools
