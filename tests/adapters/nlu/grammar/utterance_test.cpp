#include <algorithm>

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
      {"please the toilet", "fup"},
      {"er", "f"}, // nothing else is said
      {"by the way David", "fff?"},
      {"by the toilet", "uup"},
      {"Dr. Ho", "p?"},
      {"excuse me, by the way", "fffff"},
      {"by the", "uu"}, // a phrase cut off
  };
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(kinds(text, automaton), expected) << text;
}

TEST(Utterance, LeavesOutWhatWinsTimeWithinASentence) {
  const auto words = [](const char* text) {
    std::string made;
    for (const auto& token : make_utterance(text, Automaton()).tokens.list)
      made += (made.empty() ? "" : " ") + token.word;
    return made;
  };
  EXPECT_EQ(words("I am here for, let me think, Dr. Ho"),
            "i am here for dr ho");
  EXPECT_EQ(words("the, what is it called, sky garden"), "the sky garden");
  EXPECT_EQ(words("the thing, what is it called, for it"), "the thing for it");
  // Who wins time has not said yes.
  EXPECT_EQ(words("Yes, let me see, er, no"), "yes let me see no");
  EXPECT_EQ(words("Okay, let me check, please"), "okay let me check please");
  // That may be all that is meant.
  EXPECT_EQ(words("let me think, Dr. Ho"), "let me think dr ho");
  EXPECT_EQ(words("Dr. Ho, let me think"), "dr ho let me think");
  EXPECT_EQ(words("Dr. Ho, let me think about it"),
            "dr ho let me think about it");
}

TEST(Utterance, JoinsNoNumberThatGoesOnOtherwise) {
  for (const auto* text : {"It is nine one. No, one moment.",
                           "Call 91234567. No, one more thing."}) {
    const auto tokens = make_utterance(text, Automaton()).tokens.list;
    EXPECT_TRUE(std::ranges::any_of(tokens, [](const Token& token) {
      return token.before == Break::sentence;
    })) << text;
  }
}

TEST(Utterance, JoinsANumberThatIsMendedAtOnce) {
  const auto sentences = [](const char* text) {
    std::size_t count = 1;
    for (const auto& token : make_utterance(text, Automaton()).tokens.list)
      count += token.before == Break::sentence ? 1U : 0U;
    return count;
  };
  EXPECT_EQ(sentences("At four. No, half past four, to Orchard Road"), 1U);
  EXPECT_EQ(sentences("Wake me at six. No wait, make it 6:30. Room 301"), 2U);
  EXPECT_EQ(sentences("At four. No, to Orchard Road"), 2U);
  EXPECT_EQ(sentences("A taxi. No, two"), 2U);
  EXPECT_EQ(sentences("At four. No. Half past four is late"), 3U);
}

TEST(Utterance, CountsNoWordsThatMeanNothing) {
  Automaton automaton;
  automaton.vocabulary = {{"toilet", 7}};
  const auto made = make_utterance("well the toilet there", automaton);
  EXPECT_EQ(made.words, (std::vector<WordNumber>{unknown_word, unknown_word, 7,
                                                 unknown_word}));
  EXPECT_EQ(made.weight_of(0, 1), 0);
  EXPECT_EQ(made.weight_of(0, 4), 2);
  EXPECT_EQ(made.weight_of(1, 99), 2); // to the end
  EXPECT_EQ(made.weight_of(3, 3), 0);
}

std::string words(const char* text) {
  Automaton automaton;
  automaton.vocabulary = {{"food", 1}, {"court", 2}};
  std::string all;
  for (const auto& token : make_utterance(text, automaton).tokens.list)
    all += (all.empty() ? "" : " ") + token.word;
  return all;
}

TEST(Utterance, LeavesOutHesitations) {
  EXPECT_EQ(words("next um friday"), "next friday");
  EXPECT_EQ(words("two ah o clock"), "two o clock");
  EXPECT_EQ(words("jeffery, er, ho"), "jeffery ho");
  EXPECT_EQ(words("ah meng"), "ah meng"); // a name
  EXPECT_EQ(words("um"), "um");
  EXPECT_EQ(words("mm-hm"), "mm hm"); // a yes
  EXPECT_EQ(words("mm hmm"), "mm hmm");
  EXPECT_EQ(words("mm, hall"), "hall");
}

TEST(Utterance, KeepsWordsOfTheApplication) {
  Automaton automaton;
  automaton.own_hesitations = {"er"};
  const auto kept = [&](const char* text) {
    std::string all;
    for (const auto& token : make_utterance(text, automaton).tokens.list)
      all += (all.empty() ? "" : " ") + token.word;
    return all;
  };
  EXPECT_EQ(kept("where is the ER"), "where is the er");
  EXPECT_EQ(kept("take me to ER"), "take me to er");
  EXPECT_EQ(kept("where is the er"), "where is the er");
  EXPECT_EQ(kept("where is, er, the bank"), "where is the bank");
  EXPECT_EQ(kept("Er, where is the, er, bank"), "where is the bank");
  EXPECT_EQ(kept("where is the um bank"), "where is the bank");
  EXPECT_EQ(kinds("the ER", automaton), "u?");
  EXPECT_EQ(words("where is the ER"), "where is the"); // no word of its own
}

TEST(Utterance, LeavesOutWhatIsSaidTwice) {
  EXPECT_EQ(words("the food, the food court"), "the food court");
  EXPECT_EQ(words("the the food food court"), "the food court");
  EXPECT_EQ(words("we want we want a taxi"), "we want a taxi");
  EXPECT_EQ(words("ting ting"), "ting ting"); // a name
  EXPECT_EQ(words("five five one"), "five five one");
  EXPECT_EQ(words("to the food. the food court"), "to the food the food court");
}

TEST(Utterance, KeepsPunctuationOfHesitations) {
  const auto made = make_utterance("jeffery, er ho", Automaton());
  ASSERT_EQ(made.size(), 2U);
  EXPECT_EQ(made.tokens.list[1].before, Break::comma);
}

TEST(Utterance, WordsThatAreOnlyCrossMeanNothing) {
  const Automaton automaton;
  const auto fillers = [&](const char* text) {
    const auto made = make_utterance(text, automaton);
    return std::ranges::count(made.filler, true);
  };
  EXPECT_EQ(fillers("where the hell is it"), 2);
  EXPECT_EQ(fillers("what on earth is it"), 2);
  EXPECT_EQ(fillers("why in the world is it"), 3);
  EXPECT_EQ(fillers("go to the hell"), 0);
}

} // namespace
} // namespace parlour::adapters::nlu
