// Spelling: how near two spellings of a name are (engine rule 5, cardinality
// "set": case, spelling variation, word order and plural aside). Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::dialogue {

// Lower case by Unicode; punctuation and white space become one space, none at
// the ends. Apostrophes go: "Jeffery's" is one word.
std::string folded(std::string_view text);

// Whether folded(text) == words.
bool folds_to(std::string_view text, std::string_view words);

std::vector<std::string> words_of(std::string_view text); // folded

// 0: the same but for case and punctuation; 1: but for word order and plural;
// then more with every letter; nothing: too far. Words with digits in them are
// near only to themselves.
std::optional<int> spelling_distance(std::string_view said,
                                     std::string_view canonical);

// Whether every word of `part` is one of `whole`, in any order.
bool has_words(std::string_view whole, std::string_view part);

} // namespace parlour::dialogue
