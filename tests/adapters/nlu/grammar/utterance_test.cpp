#include <gtest/gtest.h>

#include "adapters/nlu/grammar/utterance.hpp"

namespace parlour::adapters::nlu {
namespace {

// A letter for each token: f filler, u function word, p otherwise plain,
// ? without a meaning of its own.
std::string kinds(const char* text, const Automaton& automaton) {
  const auto made = make_utterance(text, automaton);
  std::string letters;
  for (std::size_t at = 0; at < made.size(); ++at)
    letters += made.filler[at]     ? 'f'
               : made.function[at] ? 'u'
               : made.plain[at]    ? 'p'
                                   : '?';
  return letters;
}

TEST(Utterance, KnowsTheKindsOfWords) {
  Automaton automaton;
  automaton.vocabulary = {{"toilet", 1}, {"way", 2}};
  struct {
    const char* text;
    const char* expected;
  } const cases[] = {
      {"", ""},
      {"er the toilet", "fup"},
      {"by the way David", "fff?"},
      {"by the toilet", "uup"},
      {"Dr. Ho", "p?"},
      {"excuse me, by the way", "fffff"},
      {"by the", "uu"}, // a phrase cut off
  };
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(kinds(text, automaton), expected) << text;
}

TEST(Utterance, CountsNoWordsThatMeanNothing) {
  Automaton automaton;
  automaton.vocabulary = {{"toilet", 7}};
  const auto made = make_utterance("um the toilet there", automaton);
  EXPECT_EQ(made.words, (std::vector<WordNumber>{unknown_word, unknown_word, 7,
                                                 unknown_word}));
  EXPECT_EQ(made.weight_of(0, 1), 0);
  EXPECT_EQ(made.weight_of(0, 4), 2);
  EXPECT_EQ(made.weight_of(1, 99), 2); // to the end
  EXPECT_EQ(made.weight_of(3, 3), 0);
}

} // namespace
} // namespace parlour::adapters::nlu
