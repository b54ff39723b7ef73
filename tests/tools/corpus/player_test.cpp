#include <sstream>

#include <gtest/gtest.h>

#include "tests/tools/corpus/corpus_fixture.hpp"
#include "tools/corpus/player.hpp"

namespace parlour::tools::corpus {
namespace {

using Texts = std::vector<std::string>;

class CorpusPlayer : public testing::Test {
protected:
  // Words are separated by commas here; "kind turn topic slot wanted/found".
  Texts play(std::string text) {
    for (auto& character : text)
      if (character == ',')
        character = '\t';
    std::istringstream input("dialogue\td\n" + text);
    Texts told;
    Player player(compile_table(folder), [&](const Fault& fault) {
      told.push_back(std::string(name_of(fault.kind)) + " " + fault.turn + " " +
                     fault.topic + " " + fault.slot + " " + fault.wanted + "/" +
                     fault.found);
    });
    player.play(TurnReader(input).next().value());
    counts = player.counts();
    return told;
  }

  static std::string inform(const std::string& slot) {
    return "act,inform,Table,no\nslot," + slot + "\nsay\n";
  }

  test::TemporaryFolder folder;
  Counts counts;
};

TEST_F(CorpusPlayer, AStateIsComparedWithTheFrame) {
  const auto turn = "turn,1\n" + inform("People,2") + "state,Table\n";
  EXPECT_EQ(play(turn + "is,People,two,2\n"), Texts{});
  EXPECT_EQ(counts.turns, 1u);
  EXPECT_EQ(counts.states, 1u);
  EXPECT_EQ(counts.slots, 1u);
  EXPECT_EQ(play(turn + "is,People,*\n"), Texts{});
  EXPECT_EQ(play(turn + "is,People,3\n"), Texts{"wrong 1 Table People 3/2"});
  EXPECT_EQ(play(turn), Texts{"wrong 1 Table People /2"});
  EXPECT_EQ(play(turn + "is,People,2\nis,Window,yes\n"),
            Texts{"wrong 1 Table Window yes/"});
}

TEST_F(CorpusPlayer, AReturnMustFindWhatWasLeft) {
  const auto left = "turn,1\n" + inform("People,2") +
                    "turn,2\nact,inform,Hours,no\nsay\n" +
                    "turn,3\nreturns,Table\n";
  EXPECT_EQ(play(left + inform("Time,5 pm") +
                 "state,Table\nis,People,2\nis,Time,5 pm\n"),
            Texts{});
  EXPECT_EQ(counts.returns, 1u);
}

TEST_F(CorpusPlayer, ALostSlotIsTold) {
  const auto cancelled = "turn,1\n" + inform("People,2") +
                         "turn,2\nact,cancel,,no\nsay\n" +
                         "turn,3\nreturns,Table\n" + inform("Time,5 pm");
  EXPECT_EQ(play(cancelled + "state,Table\nis,People,2\nis,Time,5 pm\n"),
            (Texts{"wrong 3 Table People 2/", "lost 3 Table People 2/"}));
  EXPECT_EQ(play("turn,1\n" + inform("People,2") +
                 "turn,2\nact,cancel,,no\nsay\nkeeps,Table\n"),
            Texts{"lost 2 Table People 2/"});
}

TEST_F(CorpusPlayer, ATurnWithoutAnAnswerIsADeadEnd) {
  EXPECT_EQ(play("turn,1\nact,help,,no\nsay\n"), Texts{"silent 1   /"});
}

TEST_F(CorpusPlayer, ErrorsOfScriptsAreTold) {
  const auto told = play("turn,1\nact,request,Table,no\nsay\n");
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].substr(0, 8), "error 1 ");
}

TEST_F(CorpusPlayer, WordsAndTheCurrentTopic) {
  const auto turn = "turn,1\n" + inform("People,2");
  EXPECT_EQ(play(turn + "said,When?\ntopic,Table\n"), Texts{});
  EXPECT_EQ(play(turn + "said,How?\ntopic,Hours\n"),
            (Texts{"unsaid 1   How?/When?", "elsewhere 1 Hours  Hours/Table"}));
  EXPECT_EQ(play(turn + "said,When?\nsaid,When?\n"),
            Texts{"unsaid 1   When?/When?"});
}

TEST_F(CorpusPlayer, QuestionsAreAnswered) {
  const auto begun = "turn,1\nact,inform,Table,no\nsay\n";
  EXPECT_EQ(play(std::string(begun) + "answer,Table\nstate,Table\n"
                                      "is,People,something\n"),
            Texts{});
  EXPECT_EQ(play("turn,1\nact,inform,Hours,no\nsay\nanswer,Table\n"),
            Texts{"unasked 1 Table  /"});
  // Nobody says yes: the topic asks and is never over.
  EXPECT_EQ(play(std::string(begun) + "fill,Table\n"),
            Texts{"unasked 1 Table  /"});
}

} // namespace
} // namespace parlour::tools::corpus
