// Word errors: how the words that were recognised differ from those that were
// said, as speech recognition counts them: the least number of substitutions,
// insertions and deletions.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::tools {

struct WordErrors {
  std::size_t words = 0; // that were said
  std::size_t substitutions = 0;
  std::size_t insertions = 0;
  std::size_t deletions = 0;

  std::size_t errors() const {
    return substitutions + insertions + deletions;
  }
  // In percent of the words; 0 where nothing was said.
  double rate() const;
  WordErrors& operator+=(const WordErrors& other);
  bool operator==(const WordErrors&) const = default;
};

// Of lists of words.
WordErrors count_word_errors(const std::vector<std::string>& said,
                             const std::vector<std::string>& heard);
// Of texts. Both are compared as they are spoken, so "10:30am" equals "ten
// thirty a.m.".
WordErrors count_word_errors(std::string_view said, std::string_view heard);

} // namespace parlour::tools
