#include <gmock/gmock.h>

#include "adapters/nlu/understand/left_sentences.hpp"

namespace parlour::adapters::nlu::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> left(const char* text,
                              std::vector<TokenRange> understood = {}) {
  const Automaton automaton;
  std::vector<BuiltAct> acts;
  for (const auto range : understood) {
    acts.emplace_back();
    acts.back().begin = range.begin;
    acts.back().end = range.end;
  }
  const auto utterance = make_utterance(text, automaton);
  const auto found = left_sentences(utterance, acts);
  return {found.begin(), found.end()};
}

TEST(LeftSentences, AreThoseThatNoActIsFrom) {
  constexpr auto text = "Yes, please. Where is the bank? My dog waits.";
  EXPECT_THAT(left(text, {{0, 1}}),
              ElementsAre("Where is the bank", "My dog waits"));
  EXPECT_THAT(left(text, {{0, 1}, {5, 6}}), ElementsAre("My dog waits"));
  EXPECT_THAT(left(text, {{0, 9}}), IsEmpty());
}

TEST(LeftSentences, AreNotTheWholeUtterance) {
  EXPECT_THAT(left("Where is the bank?"), IsEmpty());
  EXPECT_THAT(left("Where is the bank, and my dog"), IsEmpty());
  EXPECT_THAT(left(""), IsEmpty());
}

TEST(LeftSentences, HaveAWordOfTheirOwn) {
  EXPECT_THAT(left("Where is the bank? And that is it."),
              ElementsAre("Where is the bank"));
}

} // namespace
} // namespace parlour::adapters::nlu::test
