// The closed sets of English words that the understanding treats apart, one
// table each. Words are as the tokenizer makes them: lower case, no
// apostrophe.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace parlour::adapters::nlu {

// "dr", "mr", "professor" …: stand before a name, are not part of it.
bool is_title(std::string_view word);

// "the", "any", "this" …: may stand before any value.
bool is_determiner(std::string_view word);

// "bin", "s/o" …: join a person's name to the father's, and may be left out.
bool is_connector(std::string_view word);

// Words that a value can do without: "of", "and", determiners, connectors.
bool is_light(std::string_view word);

// Words that are no name and no value by themselves: pronouns, prepositions,
// auxiliaries, common adjectives. Determiners and connectors of places ("of")
// are among them.
bool is_function_word(std::string_view word);

// All of them, sorted.
std::vector<std::string_view> all_function_words();

// "but", "if", "maybe", "not": a yes with one of them beside it is none.
bool is_turning_word(std::string_view word);

// Phrases that mean nothing for the task, words separated by one blank.
std::span<const std::string_view> filler_phrases();

// "i'm" is "i am"; empty where `word` (with its apostrophe) is none.
std::string_view contraction(std::string_view word);

} // namespace parlour::adapters::nlu
