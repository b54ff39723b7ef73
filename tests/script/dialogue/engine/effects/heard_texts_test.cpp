#include <gtest/gtest.h>

#include "script/dialogue/engine/effects/heard_texts.hpp"
#include "tests/script/dialogue/speaker.hpp"

namespace parlour::dialogue {
namespace {

Value texts_of(std::vector<Value> params) {
  Message result;
  result.params = std::move(params);
  return heard_texts(result);
}

TEST(HeardTexts, AreThoseOfAResult) {
  EXPECT_EQ(texts_of({"too", 0.6, List{"two", "too", "to"}}),
            (List{"too", "two", "to"}));
  EXPECT_EQ(
      texts_of({"too", 0.6, List{Map{{"text", "two"}, {"confidence", 0.2}}}}),
      (List{"too", "two"}));
}

TEST(HeardTexts, AreOneWithoutAChoice) {
  EXPECT_EQ(texts_of({"too", 1, List{}}), List{"too"});
  EXPECT_EQ(texts_of({"too", 1, List{"too", "", 7, Map{}}}), List{"too"});
  EXPECT_EQ(texts_of({"too", 1, List{std::string(1'001, 'x')}}), List{"too"});
}

TEST(HeardTexts, AreUnknownOfWhatIsTyped) {
  EXPECT_TRUE(texts_of({}).is_unknown());
  EXPECT_TRUE(texts_of({"too", 1}).is_unknown());
  EXPECT_TRUE(texts_of({"too", 1, Value()}).is_unknown());
  EXPECT_TRUE(texts_of({3, 1, List{"two"}}).is_unknown());
}

TEST(HeardTexts, AreFewAndShort) {
  List many;
  for (int i = 0; i < 100; ++i)
    many.push_back(std::to_string(i) + " times");
  EXPECT_EQ(texts_of({"often", 1, many}).if_list()->size(), 5u);
}

TEST(HeardTexts, BelongToTheLikeliestAlone) {
  const Value heard = List{"too", "two"};
  EXPECT_EQ(with_heard(Map{{"now", 1}}, "too", heard)["heard"], (List{"two"}));
  EXPECT_EQ(with_heard(Map{}, "too", List{"too"})["heard"], List{});
  EXPECT_EQ(with_heard(Map{}, "other", heard)["heard"], List{});
  EXPECT_TRUE(with_heard(Map{}, "too", Value())["heard"].is_unknown());
}

// The context of the last question to the understanding.
Value context_of(const Speaker& world) {
  return world.messages.back().params.at(1);
}

TEST(HeardTexts, ComeWithTheWordsOfTheirTurn) {
  Speaker world(R"(<handler name='H'><messages><component>
    <ASR><RecognitionResult>
      <post module="NLU" command="DoNLU" param="_LPARAM1"/>
    </RecognitionResult></ASR></component></messages></handler>)");
  world.hear("too", {"two"});
  EXPECT_EQ(context_of(world)["heard"], (List{"two"}));
  world.hear("four");
  EXPECT_TRUE(context_of(world)["heard"].is_unknown());
}

} // namespace
} // namespace parlour::dialogue
