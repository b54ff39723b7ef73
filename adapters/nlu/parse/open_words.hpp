// Whether words that no list knows look like a value: a name, a place, a text.
// Pure.
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/islands.hpp"
#include "adapters/nlu/parse/spans.hpp"

namespace parlour::adapters::nlu {

// The words of a value, in the words that the rule or act has explained.
struct OpenWords {
  TokenRange value;
  TokenRange explained;
  // An answer without a sentence around it.
  bool bare = false;
};

// How certain it is that the words are a value: 1, or so little that the
// dialogue asks back or does not believe it (engine rule 5.5). Words of
// sentences are in doubt; so is an answer that is long or has no word that is
// new to the grammars. It is not believed if more was said, nor is who somebody
// is ("I am …"), if the word does not look like a name.
double certainty_of_words(const Utterance& utterance, const OpenWords& words);

// With a capital letter, or where the writer uses none.
bool is_written_as_name(const Utterance& utterance, TokenRange value);

// Whether the words of a sentence may be a value at all: in "I am seeing",
// nobody is called so.
bool may_be_value(const Utterance& utterance, TokenRange value);

// "T H I J S": several letters, one by one.
bool is_spelt(const Tokens& tokens, TokenRange range);
// Such letters as a word: "Thijs".
std::string spelt_word(const Tokens& tokens, TokenRange range);

// Removes the islands with a value that is not to be believed, by itself or
// beside what else is said: "one moment, I have it written down" gives no name.
void drop_implausible(std::vector<Island>& islands, const Utterance& utterance,
                      const Spans& spans);

} // namespace parlour::adapters::nlu
