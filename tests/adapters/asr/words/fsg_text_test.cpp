#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/fsg_text.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::HasSubstr;

class FsgTextTest : public testing::Test {
protected:
  FsgTextTest() {
    GraphBuilder names;
    names.add_sentence({siti});
    names.add_sentence({siti, nur});
    sets[name] = names.finish();
    builder.add_sentence({call, name});
    builder.add_sentence({name});
  }

  Symbols symbols;
  Symbol call = symbols.word("call");
  Symbol siti = symbols.word("siti");
  Symbol nur = symbols.word("nur");
  Symbol name = symbols.value_set("db:staff.name");
  std::map<Symbol, WordGraph> sets;
  GraphBuilder builder;
};

TEST_F(FsgTextTest, PutsASetInOnceForEachPlaceItGoesOnAt) {
  const auto made = fsg_text(builder.finish(), symbols, sets, {.another = 0});
  // call, two ways into the set, and siti (that ends or not) and nur.
  EXPECT_EQ(made.text,
            "FSG_BEGIN parlour\nNUM_STATES 7\nSTART_STATE 0\nFINAL_STATE 3\n"
            "TRANSITION 0 1 0.5 call\n"
            "TRANSITION 4 5 1 siti\n"
            "TRANSITION 4 3 1 siti\n"
            "TRANSITION 5 3 0.5 nur\n"
            "TRANSITION 0 4 0.5 \n"
            "TRANSITION 1 4 1 \n"
            "FSG_END\n");
  EXPECT_EQ(made.transitions, 6u);
  EXPECT_TRUE(made.is_whole);
}

TEST_F(FsgTextTest, LetsASentenceEndWhereItMayGoOn) {
  GraphBuilder calls;
  calls.add_sentence({call});
  calls.add_sentence({call, siti});
  const auto made = fsg_text(calls.finish(), symbols, sets, {.another = 0});
  EXPECT_EQ(made.text,
            "FSG_BEGIN parlour\nNUM_STATES 4\nSTART_STATE 0\nFINAL_STATE 3\n"
            "TRANSITION 0 1 1 call\n"
            "TRANSITION 1 3 0.5 siti\n"
            "TRANSITION 1 3 0.5 \n"
            "FSG_END\n");
}

TEST_F(FsgTextTest, LetsSentencesFollowEachOther) {
  const auto made = fsg_text(builder.finish(), symbols, sets, {.another = 0.2});
  EXPECT_THAT(made.text, HasSubstr("TRANSITION 3 0 0.2 \n"));
}

TEST_F(FsgTextTest, PutsALargeSetInOnce) {
  const auto please = symbols.word("please");
  builder.add_sentence({call, name, please});
  const auto made = fsg_text(builder.finish(), symbols, sets,
                             {.another = 0, .most_copied = 1});
  std::size_t copies = 0;
  for (auto at = made.text.find("nur"); at != std::string::npos;
       at = made.text.find("nur", at + 1))
    ++copies;
  EXPECT_EQ(copies, 1u);
  // What follows it: the end, and "please".
  EXPECT_THAT(made.text, HasSubstr(" 0.5 \nTRANSITION"));
  EXPECT_THAT(made.text, HasSubstr("please"));
}

TEST_F(FsgTextTest, IsBounded) {
  const auto made =
      fsg_text(builder.finish(), symbols, sets, {.most_transitions = 2});
  EXPECT_FALSE(made.is_whole);
  EXPECT_EQ(made.transitions, 2u);
}

} // namespace
} // namespace parlour::adapters::asr
