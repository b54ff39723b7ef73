#include "adapters/nlu/text/words.hpp"

#include <algorithm>
#include <array>

#include "adapters/nlu/text/word_set.hpp"

namespace parlour::adapters::nlu {

namespace {

using Words = WordSet;

// In English, and of visitors from elsewhere.
const Words& titles() {
  static const Words words{
      "dr",     "doctor", "mr",       "mister", "mrs",       "ms",     "miss",
      "prof",   "madam",  "mdm",      "madame", "professor", "sir",    "mme",
      "missus", "missis", "monsieur", "herr",   "frau",      "senor",  "senora",
      "signor", "tuan",   "encik",    "puan",   "cik",       "signora"};
  return words;
}

const Words& determiners() {
  static const Words words{"the",  "a",     "an",    "any",  "some", "this",
                           "that", "these", "those", "your", "our",  "my"};
  return words;
}

// "s/o" and "d/o" are two words to the tokenizer, and said as "son of".
const Words& connectors() {
  static const Words words{"bin", "binte", "binti", "bte",      "s",
                           "d",   "o",     "son",   "daughter", "al"};
  return words;
}

const Words& function_words() {
  static const Words words{
      // pronouns and question words
      "i", "me", "you", "he", "him", "she", "her", "it", "we", "us", "they",
      "them", "his", "their", "who", "whom", "whose", "what", "which", "where",
      "when", "why", "how", "there", "here", "one", "someone", "somebody",
      "something", "anyone", "anybody", "anything", "everyone", "everything",
      "nothing", "nobody", "somewhere", "anywhere",
      // prepositions and conjunctions
      "of", "in", "on", "at", "to", "from", "for", "by", "with", "without",
      "about", "around", "near", "into", "under", "above", "up", "down", "as",
      "and", "or", "but", "so", "if", "then", "than", "because", "until",
      // auxiliaries and verbs that carry little
      "am", "is", "are", "was", "were", "be", "been", "do", "does", "did",
      "have", "has", "had", "will", "would", "shall", "should", "can", "could",
      "may", "might", "must", "let", "want", "need", "like", "get", "got", "go",
      "going", "come", "know", "think", "mean", "say", "said", "tell", "give",
      "make", "find", "look", "looking", "show", "help", "take",
      // adverbs and adjectives that are no names
      "not", "no", "yes", "now", "just", "only", "also", "too", "very",
      "really", "again", "already", "still", "else", "late", "early", "lost",
      "hungry", "thirsty", "tired", "fine", "sorry", "sure", "good", "nice",
      "nearest", "closest", "next", "other", "another", "all", "more",
      "interested", "afraid", "available", "ready", "wrong", "right", "new",
      "called", "named", "finally", "exactly", "obviously", "certainly",
      "probably", "possibly", "usually", "normally", "unfortunately", "luckily",
      "hopefully", "honestly", "seriously", "literally", "totally",
      "absolutely", "completely", "definitely", "immediately", "quickly",
      "slowly", "lately", "recently", "suddenly"};
  return words;
}

// Longer phrases need not come first: every phrase that matches is marked.
constexpr std::array<std::string_view, 36> fillers{"on second thoughts",
                                                   "on second thought",
                                                   "er",
                                                   "erm",
                                                   "um",
                                                   "uh",
                                                   "uhm",
                                                   "hm",
                                                   "hmm",
                                                   "ah",
                                                   "eh",
                                                   "oh",
                                                   "well",
                                                   "please",
                                                   "by the way",
                                                   "excuse me",
                                                   "you know",
                                                   "i think",
                                                   "actually",
                                                   "so",
                                                   "ok so",
                                                   "okay so",
                                                   "kindly",
                                                   "lah",
                                                   "if you do not mind",
                                                   "as well",
                                                   "maybe",
                                                   "perhaps",
                                                   "just",
                                                   "basically",
                                                   "damn",
                                                   "goddamn",
                                                   "flipping",
                                                   "innit",
                                                   "lol",
                                                   "haha"};

struct Contraction {
  std::string_view word;
  std::string_view meant;
};
// With and without apostrophe, as speech recognisers write both; and as people
// type.
const WordMap<std::string_view>& contractions() {
  static const WordMap<std::string_view> table{
      {"i'm", "i am"},          {"im", "i am"},
      {"i'd", "i would"},       {"ive", "i have"},
      {"you'd", "you would"},   {"we'd", "we would"},
      {"he's", "he is"},        {"she's", "she is"},
      {"it's", "it is"},        {"its", "it is"},
      {"that's", "that is"},    {"thats", "that is"},
      {"there's", "there is"},  {"theres", "there is"},
      {"here's", "here is"},    {"what's", "what is"},
      {"whats", "what is"},     {"where's", "where is"},
      {"wheres", "where is"},   {"who's", "who is"},
      {"whos", "who is"},       {"how's", "how is"},
      {"hows", "how is"},       {"when's", "when is"},
      {"let's", "let us"},      {"lets", "let us"},
      {"can't", "can not"},     {"cant", "can not"},
      {"cannot", "can not"},    {"dont", "do not"},
      {"won't", "will not"},    {"gonna", "going to"},
      {"wanna", "want to"},     {"name's", "name is"},
      {"mustnt", "must not"},   {"shouldnt", "should not"},
      {"wouldnt", "would not"}, {"couldnt", "could not"},
      {"neednt", "need not"},   {"shan't", "shall not"},
      {"havent", "have not"},   {"doesnt", "does not"},
      {"didnt", "did not"},     {"isnt", "is not"},
      {"arent", "are not"},     {"wasnt", "was not"},
      {"youre", "you are"},     {"youve", "you have"},
      {"theyre", "they are"},   {"weve", "we have"},
      {"aint", "is not"},       {"ain't", "is not"},
      {"y'all", "you all"},     {"yall", "you all"},
      {"gotta", "have to"},     {"dunno", "i do not know"},
      {"gimme", "give me"},     {"lemme", "let me"},
      {"btw", "by the way"},    {"smth", "something"},
      {"tmrw", "tomorrow"},     {"pls", "please"},
      {"plz", "please"},
  };
  return table;
}

// Of any word: "there'll", "you've", "didn't".
constexpr Contraction endings[] = {{"'ll", " will"},
                                   {"'ve", " have"},
                                   {"'re", " are"},
                                   {"n't", " not"},
                                   {"'d", " would"}};

} // namespace

bool is_title(std::string_view word) {
  return titles().contains(word);
}

bool is_determiner(std::string_view word) {
  return determiners().contains(word);
}

bool follows_is(std::string_view word) {
  static const Words words{
      "the",  "a",    "an",    "this",   "that",  "your",   "my",    "it",
      "he",   "she",  "they",  "these",  "not",   "been",   "gone",  "broken",
      "free", "open", "there", "here",   "on",    "off",    "out",   "in",
      "at",   "too",  "very",  "so",     "still", "always", "never", "already",
      "no",   "like", "what",  "called", "going", "getting"};
  return words.contains(word) ||
         (word.size() > 4 && word.ends_with("ed") && !word.ends_with("eed"));
}

bool is_vague(std::string_view word) {
  static const Words words{
      "moment", "minute",   "second",  "while",  "meantime", "time",
      "times",  "way",      "thing",   "things", "stuff",    "bit",
      "lot",    "lots",     "kind",    "sort",   "idea",     "place",
      "places", "question", "problem", "matter", "reason",   "case",
      "end",    "rest",     "same",    "such",   "kinds",    "sorts",
      "bits",   "point",    "use",     "hurry",  "chance",   "chances"};
  return words.contains(word);
}

bool is_comment(std::string_view word) {
  static const Words words{
      "easier", "better",  "best",  "worse",   "cheaper",   "quicker",
      "faster", "enough",  "great", "perfect", "lovely",    "funny",
      "weird",  "strange", "odd",   "fine",    "wonderful", "marvellous"};
  return words.contains(word);
}

bool is_before_infinitive(std::string_view word) {
  static const Words words{
      "anything", "something", "nothing", "everything", "anywhere", "somewhere",
      "nowhere",  "place",     "places",  "room",       "time",     "like",
      "want",     "wants",     "need",    "needs",      "have",     "has",
      "how",      "where",     "what",    "able",       "allowed",  "try",
      "going",    "love",      "hoping",  "ready",      "possible", "supposed"};
  return words.contains(word);
}

bool is_before_verb(std::string_view word) {
  static const Words words{"i",     "you",    "we",    "they",  "he",
                           "she",   "can",    "could", "would", "will",
                           "shall", "should", "might", "must",  "cannot",
                           "us",    "not",    "do",    "does",  "did"};
  return words.contains(word);
}

bool is_connector(std::string_view word) {
  return connectors().contains(word);
}

bool is_light(std::string_view word) {
  static const Words words{"of", "and", "at", "in", "for", "on", "by", "n"};
  return words.contains(word) || is_determiner(word) || is_connector(word);
}

namespace {

const Words& hesitations() {
  static const Words words{"er", "erm", "um", "uh", "uhm",
                           "hm", "hmm", "mm", "eh"};
  return words;
}

} // namespace

bool is_hesitation(std::string_view word) {
  return hesitations().contains(word);
}

std::vector<std::string_view> all_hesitations() {
  return {hesitations().begin(), hesitations().end()};
}

bool is_asking_word(std::string_view word) {
  static const WordSet words{"where", "when", "what", "which",
                             "who",   "whom", "why",  "how"};
  return words.contains(word);
}

bool is_function_word(std::string_view word) {
  return function_words().contains(word) || is_determiner(word);
}

bool is_sentence_word(std::string_view word) {
  static const Words words{
      "i",       "me",        "you",      "he",       "she",    "we",
      "they",    "us",        "them",     "am",       "is",     "are",
      "was",     "were",      "be",       "been",     "do",     "does",
      "did",     "have",      "has",      "had",      "would",  "should",
      "could",   "can",       "not",      "never",    "what",   "which",
      "who",     "whom",      "where",    "when",     "why",    "how",
      "because", "if",        "whether",  "want",     "need",   "think",
      "know",    "mean",      "said",     "told",     "tell",   "forgot",
      "sorry",   "please",    "hello",    "yes",      "no",     "someone",
      "anyone",  "something", "anything", "nothing",  "nobody", "somebody",
      "anybody", "thanks",    "already",  "somewhere"};
  return words.contains(word);
}

bool is_turning_word(std::string_view word) {
  static const Words words{"not",    "no",      "never",   "nor",    "nothing",
                           "none",   "without", "but",     "if",     "unless",
                           "except", "only",    "instead", "until",  "before",
                           "maybe",  "perhaps", "or",      "hardly", "neither"};
  return words.contains(word);
}

std::vector<std::string_view> all_function_words() {
  std::vector<std::string_view> all(function_words().begin(),
                                    function_words().end());
  all.insert(all.end(), determiners().begin(), determiners().end());
  std::ranges::sort(all);
  return all;
}

std::span<const std::string_view> filler_phrases() {
  return fillers;
}

std::string contraction(std::string_view word) {
  if (const auto* const meant = contractions().find(word))
    return std::string(*meant);
  if (word.find('\'') == std::string_view::npos)
    return {};
  for (const auto& [ending, meant] : endings)
    if (word.size() > ending.size() && word.ends_with(ending))
      return std::string(word.substr(0, word.size() - ending.size())) +
             std::string(meant);
  return {};
}

} // namespace parlour::adapters::nlu
