#include <gtest/gtest.h>

#include "tools/parlour/conversation_test/directive_reader.hpp"

namespace parlour::tools {
namespace {

TEST(DirectiveReader, gives_words_and_the_rest) {
  DirectiveReader reader("  post Telephone   Call now ");
  EXPECT_EQ(reader.word()->text, "post");
  EXPECT_EQ(reader.word()->text, "Telephone");
  EXPECT_EQ(reader.rest(), "Call now");
}

TEST(DirectiveReader, gives_nothing_at_the_end) {
  DirectiveReader reader(" ");
  EXPECT_FALSE(reader.word());
  EXPECT_FALSE(reader.open_quote());
}

TEST(DirectiveReader, reads_quoted_words) {
  DirectiveReader reader(R"('Dr. Jeffery Ho' "say \"hi\"" '')");
  EXPECT_EQ(reader.word()->text, "Dr. Jeffery Ho");
  EXPECT_EQ(reader.word()->text, "say \"hi\"");
  EXPECT_EQ(reader.word()->text, "");
  EXPECT_FALSE(reader.word());
}

TEST(DirectiveReader, tells_of_an_open_quote) {
  DirectiveReader reader("'never closed");
  EXPECT_FALSE(reader.word());
  EXPECT_TRUE(reader.open_quote());
}

TEST(Word, is_a_number_only_where_it_prints_as_written) {
  EXPECT_EQ((Word{"12", false}.value().type()), ValueType::integer);
  EXPECT_EQ((Word{"0.5", false}.value().type()), ValueType::number);
  EXPECT_EQ((Word{"-3", false}.value().type()), ValueType::integer);
  EXPECT_EQ((Word{"007", false}.value().type()), ValueType::string);
  EXPECT_EQ((Word{"12", true}.value().type()), ValueType::string);
}

TEST(Word, is_a_truth_value_or_unknown) {
  EXPECT_EQ((Word{"true", false}.value().type()), ValueType::boolean);
  EXPECT_TRUE((Word{"unknown", false}.value().is_unknown()));
  EXPECT_FALSE((Word{"unknown", true}.value().is_unknown()));
}

TEST(Word, is_written_as_it_is_read) {
  for (const Value& value : std::initializer_list<Value>{
           "", "left", "the left one", "4006381", "007", "10", "-1.50", "true",
           "unknown", "'s", "\"", "a\\b", "a \"b\" \\ c", 12, 0.5, true,
           Value()}) {
    const auto word = written(value);
    ASSERT_TRUE(word) << to_string(value);
    const auto line = *word + " behind";
    DirectiveReader reader(line);
    const auto read = reader.word()->value();
    EXPECT_EQ(read, value) << *word;
    EXPECT_EQ(read.type(), value.type()) << *word;
    EXPECT_EQ(reader.rest(), "behind") << *word;
  }
  EXPECT_EQ(written("left"), "left");
  EXPECT_EQ(written("10"), "\"10\"");
  EXPECT_FALSE(written(List{1}));
  EXPECT_FALSE(written(Map()));
}

TEST(Sides, are_split_at_the_first_or_last_equals) {
  EXPECT_EQ(split_at_first_equals("a.b = c = d")->left, "a.b");
  EXPECT_EQ(split_at_last_equals("x where y = 1 = 2")->left, "x where y = 1");
  EXPECT_EQ(split_at_last_equals("x where y = 1 = 2")->right, "2");
  EXPECT_FALSE(split_at_first_equals("a=b"));
}

} // namespace
} // namespace parlour::tools
