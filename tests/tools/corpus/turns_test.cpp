#include <sstream>

#include <gtest/gtest.h>

#include "tools/corpus/turns.hpp"

namespace parlour::tools::corpus {
namespace {

TEST(Turns, ALineHasFieldsBetweenTabs) {
  const auto line = parse_line("is\tTime\t5 pm\t17:00\t");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->kind, LineKind::is);
  EXPECT_EQ(line->fields,
            (std::vector<std::string>{"Time", "5 pm", "17:00", ""}));
}

TEST(Turns, UnknownLinesAndWrongNumbersOfFieldsAreErrors) {
  EXPECT_EQ(parse_line("shout\tx").error().message, "there is no line 'shout'");
  EXPECT_EQ(parse_line("act\tinform").error().message,
            "'act' takes 3 fields, not 1");
  EXPECT_FALSE(parse_line("say\tit"));
  EXPECT_FALSE(parse_line("is\tTime"));
}

TEST(Turns, AReaderGivesOneDialogueAfterTheOther) {
  std::istringstream input("dialogue\ta\nturn\t1\ndialogue\tb\nsay\n");
  TurnReader reader(input);
  EXPECT_EQ(reader.next()->size(), 2u);
  const auto second = reader.next();
  ASSERT_EQ(second->size(), 2u);
  EXPECT_EQ(second->front().fields[0], "b");
  EXPECT_TRUE(reader.next()->empty());
}

TEST(Turns, AReaderTellsTheLineThatIsWrong) {
  std::istringstream input("dialogue\ta\nturn\n");
  const auto wrong = TurnReader(input).next();
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().place.line, 2u);
  std::istringstream headless("turn\t1\n");
  EXPECT_FALSE(TurnReader(headless).next());
}

} // namespace
} // namespace parlour::tools::corpus
