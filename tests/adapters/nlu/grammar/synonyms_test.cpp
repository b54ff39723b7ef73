#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/nlu/grammar/synonyms.hpp"

namespace parlour::adapters::nlu {
namespace {

using testing::ElementsAre;
using testing::Pointee;

// Knows the words 1 taxi, 2 close, 3 near, 4 to.
class SynonymsTest : public testing::Test {
protected:
  SynonymsTest() {
    automaton.vocabulary = {{"taxi", 1}, {"close", 2}, {"near", 3}, {"to", 4}};
  }
  void add(const char* groups) {
    add_synonyms(
        read_synonyms(groups), [](auto word) { return word == "cabbage"; },
        automaton);
  }

  Automaton automaton;
};

TEST_F(SynonymsTest, AreGroupsOfWords) {
  EXPECT_THAT(
      read_synonyms("taxi Cab # a car\n\n# nothing\nalone\nloo WC\n"),
      ElementsAre(ElementsAre("taxi", "cab"), ElementsAre("loo", "wc")));
}

TEST_F(SynonymsTest, AreReadAsWhatAGrammarHas) {
  add("taxi cab minicab\nloo toilet\n");
  EXPECT_THAT(automaton.synonyms_of("cab"), Pointee(ElementsAre(1U)));
  EXPECT_THAT(automaton.synonyms_of("minicab"), Pointee(ElementsAre(1U)));
  EXPECT_EQ(automaton.synonyms_of("taxi"), nullptr);
  EXPECT_EQ(automaton.synonyms_of("loo"), nullptr); // nobody knows a toilet
}

TEST_F(SynonymsTest, AWordMayMeanSeveralOthers) {
  add("close shut\nnear close nearby\n");
  EXPECT_THAT(automaton.synonyms_of("shut"), Pointee(ElementsAre(2U)));
  EXPECT_THAT(automaton.synonyms_of("close"), Pointee(ElementsAre(3U)));
  EXPECT_THAT(automaton.synonyms_of("nearby"), Pointee(ElementsAre(3U, 2U)));
}

TEST_F(SynonymsTest, FunctionWordsAndValuesMeanThemselves) {
  add("close cabbage in\n");
  EXPECT_EQ(automaton.synonyms_of("cabbage"), nullptr);
  EXPECT_EQ(automaton.synonyms_of("in"), nullptr);
}

} // namespace
} // namespace parlour::adapters::nlu
