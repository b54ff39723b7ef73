// The closed sets of English words that understanding treats specially, one
// table each. Words have the form that the tokenizer gives them: lower case,
// without apostrophes.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::adapters::nlu {

// "dr", "mr", "professor" …: may stand before a name and are not part of it.
bool is_title(std::string_view word);

// "the", "any", "this" …: may stand before any value.
bool is_determiner(std::string_view word);

// "the", "it", "not", "open", "blocked" …: follow "is" and no possessive.
bool follows_is(std::string_view word);

// "moment", "way", "thing" …: name no thing by themselves.
bool is_vague(std::string_view word);

// "easier", "funny" …: say what one thinks of something, and are no answer.
bool is_comment(std::string_view word);

// "anything", "somewhere", "where", "like" …: a verb follows them and "to".
bool is_before_infinitive(std::string_view word);

// "i", "you", "can", "could" …: a verb follows them.
bool is_before_verb(std::string_view word);

// "bin", "s/o" …: connect a person's name with the father's; may be omitted.
bool is_connector(std::string_view word);

// Words that a value can do without: "of", "and", determiners, connectors.
bool is_light(std::string_view word);

// Whether it is said while one thinks, even within a name: "er", "um".
bool is_hesitation(std::string_view word);
std::vector<std::string_view> all_hesitations();

// Words that are neither a name nor a value by themselves: pronouns,
// prepositions, auxiliaries, common adjectives, determiners.
bool is_function_word(std::string_view word);

// Words of sentences: pronouns, auxiliaries, question words. Neither a name nor
// a place has one of them, and a text that has one may be about something else.
bool is_sentence_word(std::string_view word);

// "where", "when", "what", "which", "who", "whom", "why", "how".
bool is_asking_word(std::string_view word);

// All function words, sorted.
std::vector<std::string_view> all_function_words();

// "but", "if", "maybe", "not" …: a yes beside one of them is not a clear yes.
bool is_turning_word(std::string_view word);

// Phrases without meaning for the task, with one blank between words: "by the
// way".
std::span<const std::string_view> filler_phrases();

// "i'm" gives "i am", and "there'll" gives "there will": some endings make a
// contraction of any word. `word` has its apostrophe, if the writer made one.
// Empty if it is no contraction.
std::string contraction(std::string_view word);

} // namespace parlour::adapters::nlu
