// ValueIndex holds the sets of values of an application (of slots and columns)
// and finds where an utterance names one of them: word by word, in any order,
// with words left out, joined, split or misspelt, and without regard to titles
// (understanding, "Names and values").
//
//  values            "Dr. Jeffery Ho", "Jeffery Lim", "Coffee Shop"
//  "ho jeffery"      Dr. Jeffery Ho
//  "jeffery"         candidates: Dr. Jeffery Ho, Jeffery Lim
//  "the cofee shop"  Coffee Shop, with a lower confidence
//  "kelvin ho"       nobody, though "Ho" is known: a name must be covered
//
// It is an inverted index: each word has a list of the values in which it
// occurs.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "adapters/nlu/text/name_sounds.hpp"
#include "adapters/nlu/text/tokens.hpp"
#include "adapters/nlu/text/word_index.hpp"

namespace parlour::adapters::nlu {

using SetId = std::uint32_t;

// A place in an utterance that names a value.
struct ValueMatch {
  SetId set = 0;
  // Tokens [begin, end).
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  // The numbers, within the set, of the values that fit equally well.
  std::vector<std::uint32_t> values;
  double confidence = 1;
  // Every word of the value that counts was said.
  bool whole = false;
  // Enough was said, in words without another meaning, that the value is meant
  // even where none is expected.
  bool stands_alone = false;
};

// Built by add(), then only read, by any number of threads.
class ValueIndex {
public:
  // Adds a set. Equal texts count as one value.
  SetId add(const std::vector<std::string>& values);

  // Other words for words of values, a group a set: where "cup" is one, "mug"
  // is one, too, but less certain. Only for values written in small letters:
  // names are said as they are. After all sets.
  void add_synonyms(const std::vector<std::vector<std::string>>& groups);

  // All matches, ordered by their begin. `plain` says for each token whether it
  // has a meaning of its own; such a word is neither a misspelt value nor part
  // of an unknown name.
  std::vector<ValueMatch> find(const Tokens& tokens,
                               const std::vector<bool>& plain) const;

  // Whether some value has this word, as it is or in the other number.
  bool has_word(std::string_view word) const {
    return !words_.index.find(word, Spelling::exact).empty() ||
           !joined_.index.find(word, Spelling::exact).empty();
  }

  // Whether its values look like names of people.
  bool has_people(SetId set) const {
    return sets_[set].of_people;
  }

  // Whether at least a quarter of its values have words of values that are
  // written in small letters, as shops have, and people do not.
  bool has_things(SetId set) const;

  // Of each value, if the set has people; else empty.
  const std::vector<NameSounds>& sounds(SetId set) const {
    return sets_[set].sounds;
  }
  const std::string& value(SetId set, std::uint32_t number) const {
    return values_[sets_[set].first + number].text;
  }

private:
  friend class ValueFits;
  friend class ValueSearch;

  struct Entry {
    std::string text;
    SetId set = 0;
    // A bit for each word of the value, and the bits of those that must be
    // said.
    std::uint16_t all = 0;
    std::uint16_t heavy = 0;
  };

  // An entry of a word's list: the value, and which of its words this is.
  struct Posting {
    std::uint32_t value = 0;
    std::uint16_t mask = 0;
  };

  // Words, and the list of each by its number.
  struct Lists {
    WordIndex index;
    std::vector<std::vector<Posting>> postings;

    void add(std::string_view word, Posting posting);
  };

  struct Set {
    // The index in values_ of its first value.
    std::uint32_t first = 0;
    // Its values look like names of people, so a word beside one that is left
    // over means somebody else.
    bool of_people = false;
    std::vector<NameSounds> sounds;
  };

  void add_value(const std::string& text, SetId set);
  bool is_thing(const Entry& value) const;

  std::vector<Entry> values_;
  std::vector<Set> sets_;
  Lists words_;
  // Two adjacent words written together, with two bits. They are many, and
  // looked for apart, so that they take neither the time nor the place of
  // words.
  Lists joined_;
  // Those of values that are written in small letters.
  std::unordered_set<std::string> words_of_things_;
  // The lists of words that no value has.
  TextMap<std::vector<Posting>> synonyms_;
};

} // namespace parlour::adapters::nlu
