// WordIndex finds a word among the words of all values: exactly, in singular or
// plural, or misspelt.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/text/text_map.hpp"

namespace parlour::adapters::nlu {

// The singular of an English noun by rule: "shops" gives "shop". Words are
// stored and looked up in this form, so that either number finds the other.
std::string singular(std::string_view word);

// How far from its spelling a word may be found.
enum class Spelling : std::uint8_t {
  // Not at all, but for the other number.
  exact,
  // At most a letter more or fewer, and nearly the same: for long words.
  nearly,
  // Misspelt, or only said alike.
  loose,
};

// Not thread-safe while words are added; afterwards any number of threads may
// find.
class WordIndex {
public:
  using WordId = std::uint32_t;

  struct Hit {
    WordId word = 0;
    double similarity = 1;
    // Only said alike: "boat" for "pot". For names, which are spelt in many
    // ways.
    bool only_said = false;
  };

  // Returns the number of the word, which is new if its singular is not yet
  // there. Numbers count from 0.
  WordId add(std::string_view word);

  // The word itself, if it is there, then words that may be it if the spelling
  // is not exact; the most similar first, at most eight.
  std::vector<Hit> find(std::string_view word, Spelling spelling) const;
  // Words that are said the same, such as "soh" for "so".
  std::vector<Hit> find_said_alike(std::string_view word) const;
  std::size_t size() const {
    return words_.size();
  }

private:
  // A word as it is written (similarity.hpp), sounds (sounds.hpp) and is said
  // (phones.hpp).
  struct Word {
    std::string letters;
    std::uint32_t letter_bits = 0;
    std::string sound;
    std::string phones;
    std::uint32_t phone_bits = 0;
    std::uint32_t outline = 0; // as a key; 0: it has no phones
  };

  // One that was heard.
  struct Heard {
    Word word;
    // How similar a word must be at least, and by how many letters it may be
    // longer or shorter.
    double least = 0;
    std::size_t extra = 0;
  };

  static Word read(std::string letters);
  static std::vector<std::uint32_t> keys_of(const Word& word);
  void add_misspelt(const std::string& word, Spelling spelling,
                    std::vector<Hit>& hits) const;
  Hit compare(const Heard& heard, WordId number, std::size_t shared) const;
  static double alike_when_said(const Heard& heard, const Word& known);
  static void sort(std::vector<Hit>& hits);

  std::vector<Word> words_;
  TextMap<WordId> numbers_;
  // Words by their length and the keys that similar words share (with_length
  // and keys_of in the source).
  std::unordered_map<std::uint64_t, std::vector<WordId>> near_;
};

} // namespace parlour::adapters::nlu
