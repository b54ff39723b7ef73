#include "tools/parlour/voice_test/word_errors.hpp"

#include <algorithm>

#include "adapters/asr/words/spoken_words.hpp"

namespace parlour::tools {

namespace {

// Without the dots of "a.m.", which some write and others do not.
std::vector<std::string> words_of(std::string_view text) {
  auto words = adapters::asr::spoken_words(text);
  for (auto& word : words)
    std::erase(word, '.');
  return words;
}

} // namespace

double WordErrors::rate() const {
  return words == 0
             ? 0
             : 100 * static_cast<double>(errors()) / static_cast<double>(words);
}

WordErrors& WordErrors::operator+=(const WordErrors& other) {
  words += other.words;
  substitutions += other.substitutions;
  insertions += other.insertions;
  deletions += other.deletions;
  return *this;
}

// Row by row: the best way to each pair of prefixes, of which substitutions are
// preferred where several are equally good.
WordErrors count_word_errors(const std::vector<std::string>& said,
                             const std::vector<std::string>& heard) {
  std::vector<WordErrors> before(heard.size() + 1);
  for (std::size_t j = 0; j <= heard.size(); ++j)
    before[j].insertions = j;
  for (const auto& word : said) {
    auto row = before;
    ++row[0].deletions;
    for (std::size_t j = 1; j <= heard.size(); ++j) {
      row[j] = before[j - 1];
      row[j].substitutions += word != heard[j - 1];
      if (before[j].errors() + 1 < row[j].errors()) {
        row[j] = before[j];
        ++row[j].deletions;
      }
      if (row[j - 1].errors() + 1 < row[j].errors()) {
        row[j] = row[j - 1];
        ++row[j].insertions;
      }
    }
    before = std::move(row);
  }
  auto found = before.back();
  found.words = said.size();
  return found;
}

WordErrors count_word_errors(std::string_view said, std::string_view heard) {
  return count_word_errors(words_of(said), words_of(heard));
}

} // namespace parlour::tools
